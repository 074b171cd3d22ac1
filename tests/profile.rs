//! What is a profile, what is not and why, and what the exact ones are.

mod promise;

use embedded_lathe::{End, Lathe, Part, Profile, ProfileError, Ray, RayError, Segment, valid};
use promise::{PROMISE, unit};
use std::fmt::Display;

const KNOTS: [f32; 3] = [0.0, 0.4, 1.0];
const ORDINATES: [f32; 7] = [0.1, 0.2, 0.3, 0.2, 0.1, 0.1, 0.4];

fn profile(knots: &[f32], ordinates: &[f32]) -> Result<Profile<4>, ProfileError> {
    Profile::from_squared_radii(knots, ordinates)
}

fn with(numbers: &[f32], at: usize, number: f32) -> Vec<f32> {
    let mut numbers = numbers.to_vec();
    numbers[at] = number;
    numbers
}

#[test]
fn a_wrong_profile_names_the_culprit() {
    use ProfileError::*;
    assert!(profile(&KNOTS, &ORDINATES).is_ok());
    assert_eq!(profile(&[], &[]), Err(NoSegments { knots: 0 }));
    assert_eq!(profile(&[1.0], &[1.0]), Err(NoSegments { knots: 1 }));
    let six = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
    assert_eq!(profile(&six, &[1.0; 16]), Err(TooManySegments { segments: 5, capacity: 4 }));
    assert_eq!(profile(&KNOTS, &ORDINATES[..6]), Err(OrdinateCount { expected: 7, found: 6 }));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for knot in 0..3 {
            let error = KnotNotFinite { knot, height: bad };
            assert_eq!(profile(&with(&KNOTS, knot, bad), &ORDINATES), Err(error));
        }
        for point in 0..7 {
            let error = OrdinateNotFinite { point, square: bad };
            assert_eq!(profile(&KNOTS, &with(&ORDINATES, point, bad)), Err(error));
        }
    }
    let not_above = |knot, before, height| Err(KnotsNotIncreasing { knot, before, height });
    assert_eq!(profile(&[0.0, 0.4, 0.3], &ORDINATES), not_above(2, 0.4, 0.3));
    assert_eq!(profile(&[0.0, 1e-40, 1.0], &ORDINATES), not_above(1, 0.0, 1e-40));
    let too_high = profile(&[f32::MIN, 0.0, f32::MAX], &ORDINATES);
    assert!(matches!(too_high, Err(Height { height: f32::INFINITY, .. })), "{too_high:?}");
    let too_high = profile(&[0.0, 1.0, 1e11], &ORDINATES);
    let Err(Height { height: 1e11, radius }) = too_high else { panic!("{too_high:?}") };
    assert!((radius * radius - 0.4).abs() < 1e-6, "{radius}");
    assert_eq!(profile(&KNOTS, &[0.0; 7]), Err(Size { square: 0.0 }));
    let too_large = profile(&KNOTS, &[1e31; 7]);
    assert_eq!(too_large, Err(Size { square: 1e31 }));
    for k in [-0.1, 1.1, f32::NAN, f32::INFINITY] {
        assert_eq!(profile(&KNOTS, &ORDINATES).unwrap().squash(k), Err(Squash { squash: k }));
    }
}

/// A step is a knot that stands twice, and so is the ordinate there.
#[test]
fn a_wrong_step_names_the_culprit() {
    use ProfileError::*;
    let knob = [0.0, 0.2, 0.2, 0.4];
    let ordinates = [0.3, 0.3, 0.3, 0.3, 0.1, 0.1, 0.1, 0.2];
    assert_eq!(profile(&knob, &ordinates).unwrap().segments(), 2);
    assert_eq!(profile(&knob, &ordinates[..7]), Err(OrdinateCount { expected: 8, found: 7 }));
    assert_eq!(profile(&[0.0, 0.0, 1.0], &ORDINATES), Err(OrdinateCount { expected: 5, found: 7 }));
    let equal = profile(&knob, &with(&ordinates, 4, 0.3));
    assert_eq!(equal, Err(StepWithoutWidth { knot: 2, height: 0.2, square: 0.3 }));
    let thrice = profile(&[0.0, 0.2, 0.2, 0.2, 0.4], &[0.3; 9]);
    assert_eq!(thrice, Err(KnotThrice { knot: 3, height: 0.2 }));
    assert_eq!(profile(&[1.0, 1.0], &[0.1, 0.2]), Err(NoSegments { knots: 2 }));
    assert_eq!(profile(&[1.0, 1.0, 1.0], &[0.1; 3]), Err(KnotThrice { knot: 2, height: 1.0 }));
    let infinite = profile(&[f32::INFINITY; 2], &[0.1, 0.2]);
    assert_eq!(infinite, Err(KnotNotFinite { knot: 0, height: f32::INFINITY }));
    assert_eq!(
        profile(&[0.0, 0.2, 0.2, 0.1], &ordinates),
        Err(KnotsNotIncreasing { knot: 3, before: 0.2, height: 0.1 })
    );
    // At the ends, too: what lies beyond the wall, and is wider than it, counts.
    let washer = [0.0, 0.0, 1.0, 1.0];
    let squares = [0.1, 0.3, 0.3, 0.3, 0.3, 0.1];
    assert!(profile(&washer, &squares).is_ok());
    let below = profile(&washer, &with(&squares, 0, -0.1));
    assert_eq!(below, Err(Negative { segment: 0, height: 0.0, square: -0.1 }));
    let above = profile(&washer, &with(&squares, 5, -0.2));
    assert_eq!(above, Err(Negative { segment: 0, height: 1.0, square: -0.2 }));
    assert_eq!(profile(&washer, &with(&squares, 0, 2e30)), Err(Size { square: 2e30 }));
    let flange = profile(&washer, &with(&squares, 5, 4.0)).unwrap();
    assert_eq!((flange.largest_radius(), flange.top(End::Open).largest_radius()), (2.0, 0.3_f32.sqrt()));
    // An end that is capped, or opened, is one no matter what it was.
    assert_eq!(
        profile(&washer, &squares).unwrap().closed(),
        profile(&[0.0, 1.0], &[0.3; 4]).unwrap().closed()
    );
}

/// Every parameter of every quadric, with every kind of wrong number; zero where it makes none.
#[test]
fn a_radius_or_height_that_is_none_is_named() {
    type Make = fn(f32, f32, f32) -> Result<Profile<1>, ProfileError>;
    /// Which argument, its name, and whether it may be zero.
    type Parameter = (usize, &'static str, bool);
    let makers: [(Make, &[Parameter]); 7] = [
        (|r, h, _| Profile::cylinder(r, h), &[(0, "radius", false), (1, "height", false)]),
        (|r, h, _| Profile::cone(r, h), &[(0, "radius", false), (1, "height", false)]),
        (Profile::frustum, &[(0, "base", true), (1, "top", true), (2, "height", false)]),
        (|r, _, _| Profile::sphere(r), &[(0, "radius", false)]),
        (|r, h, _| Profile::spheroid(r, h), &[(0, "radius", false), (1, "half_height", false)]),
        (|r, h, _| Profile::paraboloid(r, h), &[(0, "radius", false), (1, "height", false)]),
        (Profile::hyperboloid, &[(0, "waist", true), (1, "rim", false), (2, "half_height", false)]),
    ];
    for (make, parameters) in makers {
        assert!(make(1.0, 2.0, 3.0).is_ok());
        for &(place, name, may_be_zero) in parameters {
            for value in [-1.0, -1e-40, 0.0, -0.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let mut given = [1.0, 2.0, 3.0];
                given[place] = value;
                let made = make(given[0], given[1], given[2]);
                if value == 0.0 && may_be_zero {
                    assert!(made.is_ok(), "{name} = {value}: {made:?}");
                } else {
                    assert_eq!(made, Err(ProfileError::Dimension { name, value }));
                }
            }
        }
    }
    assert_eq!(Profile::frustum(0.0, 0.0, 1.0), Err(ProfileError::Dimension { name: "top", value: 0.0 }));
}

#[test]
fn a_squared_radius_may_touch_zero_but_not_pass_it() {
    let negative = |profile: Result<Profile<4>, ProfileError>, segment, heights: [f32; 2], square: f32| {
        let Err(ProfileError::Negative { segment: found, height, square: least }) = profile else {
            panic!("{profile:?}");
        };
        assert!((heights[0]..=heights[1]).contains(&height), "{height} is not within {heights:?}");
        assert!((least - square).abs() <= 1e-3 * square.abs(), "{least} instead of {square}");
        assert_eq!(found, segment);
    };
    // At an end, and only between the ends, in either segment: the least values are those of the cubics in f64.
    negative(profile(&KNOTS, &with(&ORDINATES, 0, -0.01)), 0, [0.0, 0.0], -0.01);
    negative(profile(&KNOTS, &with(&ORDINATES, 1, -0.4)), 0, [0.08, 0.12], least([0.1, -0.4, 0.3, 0.2]));
    negative(profile(&KNOTS, &with(&ORDINATES, 5, -0.4)), 1, [0.74, 0.82], least([0.2, 0.1, -0.4, 0.4]));
    // A negative ordinate alone does not make a negative radius.
    assert!(profile(&KNOTS, &with(&ORDINATES, 1, -0.05)).is_ok());
    // (1 − 2u)² touches zero at 1/2; scaled by numbers that round.
    for scale in [1.0, 0.1, 3.3, 1e-18, 1e18] {
        let touching = [1.0, -1.0 / 3.0, -1.0 / 3.0, 1.0].map(|b: f32| b * scale);
        assert!(profile(&[0.0, 1.0], &touching).is_ok(), "{scale}");
        let mut below = touching;
        below[1] -= 1e-5 * scale;
        let square = least(below.map(f64::from)).min(-3e-6 * scale);
        assert!(square > -5e-6 * scale);
        let found = profile(&[0.0, 1.0], &below);
        let Err(ProfileError::Negative { segment: 0, height, square }) = found else { panic!("{found:?}") };
        assert!((height - 0.5).abs() < 0.01, "{height}");
        assert!(square < -3e-6 * scale && square > -5e-6 * scale, "{square}");
    }
}

/// The least value of a cubic in Bernstein form over [0, 1], among ten thousand.
fn least(b: [f64; 4]) -> f32 {
    let value = |u: f64| {
        let v = 1.0 - u;
        b[0] * v * v * v + 3.0 * b[1] * v * v * u + 3.0 * b[2] * v * u * u + b[3] * u * u * u
    };
    (0..=10_000).map(|i| value(f64::from(i) / 10_000.0)).fold(f64::INFINITY, f64::min) as f32
}

#[test]
fn a_message_reads_well() {
    let error = |result: Result<Profile<4>, ProfileError>| result.unwrap_err().to_string();
    let not_above =
        "the height of knot 2 is 0.3, not above, or too little above, that of the knot before it, 0.4";
    assert_eq!(error(profile(&[0.0, 0.4, 0.3], &ORDINATES)), not_above);
    let count = "there must be 3 ordinates a segment, 1 a step and 1 more, 7, and there are 6";
    assert_eq!(error(profile(&KNOTS, &ORDINATES[..6])), count);
    let thrice = "knot 2 is the third at the height 1.0, and a step has two";
    assert_eq!(error(profile(&[1.0, 1.0, 1.0], &[1.0; 4])), thrice);
    let flat = "the step at knot 1, at the height 0.5, has one squared radius below and above, 0.3";
    assert_eq!(error(profile(&[0.5, 0.5, 1.0], &[0.3; 5])), flat);
    let few = "a profile needs knots at 2 heights at least; in all it has 1";
    assert_eq!(error(profile(&[1.0], &[1.0])), few);
    let negative = "the squared radius is -0.01 at the height 0.0, in segment 0";
    assert_eq!(error(profile(&KNOTS, &with(&ORDINATES, 0, -0.01))), negative);
    let dimension = |radius| Profile::sphere(radius).unwrap_err().to_string();
    assert_eq!(dimension(-1.5), "the parameter radius must not be negative, and is -1.5");
    assert_eq!(dimension(0.0), "the parameter radius must not be zero, and is 0.0");
    assert_eq!(dimension(f32::NAN), "the parameter radius must be finite, and is NaN");
}

/// Errors are keys, too: equal ones have the same hash, a NaN in them is equal to itself, and another number is not.
#[test]
fn errors_are_compared_and_hashed_by_their_bits() {
    let numbers = [f32::NAN, 0.0, -0.0, 1.5, f32::INFINITY];
    let mut known = std::collections::HashSet::new();
    for squash in numbers {
        assert!(known.insert(ProfileError::Squash { squash }));
        assert!(!known.insert(ProfileError::Squash { squash }));
        assert!(known.insert(ProfileError::Size { square: squash }));
    }
    assert_eq!(known.len(), 2 * numbers.len());
}

/// Many segments, known at run time only, and room to spare.
#[test]
fn as_many_segments_as_are_known_at_run_time() {
    for segments in 1..=64_usize {
        let knots: heapless::Vec<f32, 65> = (0..=segments).map(|i| i as f32 / segments as f32).collect();
        let ordinates: heapless::Vec<f32, 193> = (0..=3 * segments).map(|_| 1.0).collect();
        let profile = Profile::<64>::from_squared_radii(&knots, &ordinates).unwrap();
        assert_eq!(profile.segments(), segments);
        let lathe = Lathe::turn(profile);
        let hit = lathe.nearest(&Ray::new([0.0, -3.0, 0.999], [0.0, 1.0, 0.0]).unwrap(), 0.0).unwrap();
        assert_eq!((hit.t, hit.segment), (2.0, segments - 1));
    }
}

/// As `heights` and `largest_radius` promise, of a profile and of the lathe made of it.
#[test]
fn extents_are_those_of_the_outline() {
    // A barrel: radius² is 1 at its ends, and 1.75 half way up its only segment.
    let barrel = |z: f32, height: f32| {
        Profile::<3>::from_squared_radii(&[z, z + height], &[1.0, 2.0, 2.0, 1.0]).unwrap()
    };
    let off = |radius: f32| f64::from(radius) / 1.75_f64.sqrt() - 1.0;
    for (z, height) in [(0.0, 1.0), (-0.3, 0.7), (1000.1, 0.3), (-70.7, 91.3), (1e-7, 3e-7)] {
        let profile = barrel(z, height);
        let lathe = Lathe::turn(profile);
        assert_eq!((profile.heights(), profile.segments()), ([z, z + height], 1));
        assert_eq!(lathe.segments(), 1);
        assert!(
            (-6e-8..=1.5e-6).contains(&off(profile.largest_radius())),
            "{:e}",
            off(profile.largest_radius())
        );
        assert!(off(lathe.largest_radius()).abs() <= 1.6e-6, "{:e}", off(lathe.largest_radius()));
        let [low, high] = profile.heights();
        for (found, is) in lathe.heights().into_iter().zip([low, high]) {
            assert!((found - is).abs() <= low.abs().max(high.abs()) / 8_388_608.0, "{found} for {is}");
        }
    }
    // The ordinates are largest beside the squared radius: k·u·(3 − 4·u)², at most k, has one of 3·k.
    let mut most = 0.0_f64;
    for i in 0..2000 {
        let k = 1e-3 * (1.0 + 0.01 * i as f32);
        let Ok(profile) = profile(&[0.0, 1.0], &[0.0, 3.0 * k, -2.0 * k, k]) else { continue };
        let off = |radius: f32| f64::from(radius) / f64::from(k).sqrt() - 1.0;
        assert!((-6e-8..=1.5e-6).contains(&off(profile.largest_radius())), "{k}");
        assert!(off(Lathe::turn(profile).largest_radius()).abs() <= 1.6e-6, "{k}");
        most = most.max(off(profile.largest_radius()));
    }
    assert!(most > 7e-7, "{most:e}");
    let two = profile(&KNOTS, &ORDINATES).unwrap();
    assert_eq!((two.heights(), two.segments(), Lathe::turn(two).segments()), ([0.0, 1.0], 2, 2));
}

/// A ray gives back the numbers it was made of, however large, unless one is lost beside another.
#[test]
fn a_ray_has_the_direction_it_was_given() {
    for scale in [1.0, 0.1, 1e-20, 3e-38, 1e30, f32::MAX] {
        for direction in [[1.0, -0.5, 0.3], [0.0, 0.0, -1.0], [1e-3, 1.0, 1e-6]] {
            let direction = direction.map(|c: f32| c * scale);
            let ray = Ray::new([1.0, 2.0, 3.0], direction).unwrap();
            assert_eq!((ray.origin(), ray.direction()), ([1.0, 2.0, 3.0], direction));
        }
    }
}

/// Where a ray along +y at height z and abscissa x first meets a lathe.
fn y_at(lathe: &Lathe, x: f32, z: f32) -> Option<f32> {
    let ray = Ray::new([x, -8.0, z], [0.0, 1.0, 0.0]).unwrap();
    lathe.nearest(&ray, 0.0).map(|hit| hit.t - 8.0)
}

/// The radius of each, by its equation, in f64.
#[test]
fn the_exact_profiles_are_exact() {
    type Radius = fn(f64) -> f64;
    static LATHES: [(Lathe<[Segment; 1]>, f32, f32, Radius); 7] = [
        (Lathe::turn(valid!(Profile::cylinder(1.5, 2.0))), 0.0, 2.0, |_| 1.5),
        (Lathe::turn(valid!(Profile::cone(1.5, 2.0))), 0.0, 2.0, |z| 1.5 * (1.0 - z / 2.0)),
        (Lathe::turn(valid!(Profile::frustum(1.5, 0.5, 2.0))), 0.0, 2.0, |z| 1.5 - z / 2.0),
        (Lathe::turn(valid!(Profile::sphere(1.5))), -1.5, 1.5, |z| (2.25 - z * z).sqrt()),
        (Lathe::turn(valid!(Profile::spheroid(1.5, 0.75))), -0.75, 0.75, |z| (2.25 - 4.0 * z * z).sqrt()),
        (Lathe::turn(valid!(Profile::paraboloid(1.5, 2.0))), 0.0, 2.0, |z| 1.5 * (z / 2.0).sqrt()),
        (Lathe::turn(valid!(Profile::hyperboloid(0.5, 1.5, 1.0))), -1.0, 1.0, |z| {
            (0.25 + 2.0 * z * z).sqrt()
        }),
    ];
    for (i, (lathe, low, high, radius)) in LATHES.iter().enumerate() {
        has_radius(i, lathe, (*low, *high), radius);
    }
}

/// The radius between two heights is that, in f64, at most 1.5, and r·r′ ≤ 2.
fn has_radius(name: impl Display, lathe: &Lathe, (low, high): (f32, f32), radius: impl Fn(f64) -> f64) {
    for step in 1..100 {
        let z = low + (high - low) * step as f32 / 100.0;
        let r = radius(z.into());
        let y = f64::from(y_at(lathe, 0.0, z).expect("the ray meets the axis"));
        // As promised of every hit, of sizes up to 3 and a distance of 8; incidence as steep as the profile is, cos ≥
        // r/√(r² + (r·r′)²), r·r′ ≤ 2.
        let cos = r / r.hypot(2.0);
        let bound = PROMISE * unit(3.0, 8.0) / cos;
        assert!((y + r).abs() <= bound, "{name} at {z}: {} instead of {r}, bound {bound:e}", -y);
    }
}

/// As the documents of `Profile` say: with (r, r′) at each end a straight line is a cone, and a circle a sphere.
#[test]
fn radii_and_slopes_make_ordinates() {
    let lathe = |(low, high): (f32, f32), [(r0, slope0), (r1, slope1)]: [(f32, f32); 2]| {
        let two_thirds = 2.0 / 3.0 * (high - low);
        let ordinates =
            [r0 * r0, r0 * r0 + two_thirds * r0 * slope0, r1 * r1 - two_thirds * r1 * slope1, r1 * r1];
        Lathe::turn(Profile::<1>::from_squared_radii(&[low, high], &ordinates).unwrap())
    };
    let heights = (0.25, 1.0);
    has_radius("cone", &lathe(heights, [(1.5, -1.0), (0.75, -1.0)]), heights, |z| 1.75 - z);
    // About the height 0.5.
    let circle = |z: f64| (1.5f64.powi(2) - (z - 0.5).powi(2)).sqrt();
    let end = |z: f32| (circle(z.into()) as f32, (0.5 - z) / circle(z.into()) as f32);
    has_radius("sphere", &lathe(heights, [end(heights.0), end(heights.1)]), heights, circle);
}

#[test]
fn ends_are_open_or_capped() {
    let closed = Lathe::turn(Profile::cylinder(1.0, 2.0).unwrap());
    let open = Lathe::turn(Profile::cylinder(1.0, 2.0).unwrap().base(End::Open).top(End::Open));
    let cup = Lathe::turn(Profile::cylinder(1.0, 2.0).unwrap().top(End::Open));
    let down = Ray::new([0.3, 0.2, 5.0], [0.0, 0.0, -1.0]).unwrap();
    let parts = |lathe: &Lathe<[Segment; 1]>| -> Vec<(Part, bool, f32)> {
        lathe.hits::<5>(&down, 0.0).iter().map(|hit| (hit.part, hit.enters, hit.t)).collect()
    };
    assert_eq!(parts(&closed), [(Part::Top, true, 3.0), (Part::Base, false, 5.0)]);
    assert_eq!(parts(&open), []);
    assert_eq!(parts(&cup), [(Part::Base, false, 5.0)]);
    // Through the opening at a slant, onto the wall from within.
    let slant = Ray::new([0.0, 0.0, 3.0], [0.6, 0.0, -1.0]).unwrap();
    let hit = cup.nearest(&slant, 0.0).unwrap();
    assert!(!hit.enters && hit.part == Part::Wall);
}

/// What a ray meets of a shape, from above: part, segment, u, and whether it enters.
#[test]
fn rings_say_that_they_are() {
    let down = |x: f32| Ray::new([x, 0.0, 5.0], [0.0, 0.0, -1.0]).unwrap();
    let up = |x: f32| Ray::new([x, 0.0, -5.0], [0.0, 0.0, 1.0]).unwrap();
    let met = |lathe: &Lathe<[Segment; 2]>, ray: Ray| -> Vec<(Part, usize, f32, bool, f32, f32)> {
        let hits = lathe.hits::<9>(&ray, 0.0);
        assert_eq!(lathe.nearest(&ray, 0.0), hits.first().copied());
        let seen = |hit| lathe.surface(&ray, hit).normal[2];
        hits.iter().map(|hit| (hit.part, hit.segment, hit.u, hit.enters, hit.t, seen(hit))).collect()
    };
    // Wide below, narrow above, with a hole of radius 0.25 at the top.
    let knob = Profile::<2>::from_squared_radii(
        &[0.0, 1.0, 1.0, 2.0, 2.0],
        &[1.0, 1.0, 1.0, 1.0, 0.25, 0.25, 0.25, 0.25, 0.0625],
    );
    let knob = Lathe::turn(knob.unwrap().base(End::Capped));
    let (base, ring) = ((Part::Base, 0, 0.0), (Part::Ring, 0, 1.0));
    let leaves = |(part, segment, u): (Part, usize, f32), t, normal| (part, segment, u, false, t, normal);
    let enters = |(part, segment, u): (Part, usize, f32), t, normal| (part, segment, u, true, t, normal);
    assert_eq!(met(&knob, down(0.75)), [enters(ring, 4.0, 1.0), leaves(base, 5.0, -1.0)]);
    assert_eq!(met(&knob, up(0.75)), [enters(base, 5.0, -1.0), leaves(ring, 6.0, 1.0)]);
    assert_eq!(met(&knob, down(0.375)), [enters((Part::Top, 1, 1.0), 3.0, 1.0), leaves(base, 5.0, -1.0)]);
    // Through the hole, from within.
    assert_eq!(met(&knob, down(0.125)), [leaves(base, 5.0, -1.0)]);
    assert_eq!(met(&knob, down(1.25)), []);
    // Narrow below, wide above, with a flange beyond the top, and a hole through all of it.
    let knob = Profile::<2>::from_squared_radii(
        &[0.0, 1.0, 1.0, 2.0, 2.0],
        &[0.25, 0.25, 0.25, 0.25, 1.0, 1.0, 1.0, 1.0, 4.0],
    );
    let knob = Lathe::turn(knob.unwrap());
    let (ring, flange) = ((Part::Ring, 1, 0.0), (Part::Top, 1, 1.0));
    assert_eq!(met(&knob, down(0.75)), [leaves(ring, 4.0, -1.0)]);
    assert_eq!(met(&knob, up(0.75)), [enters(ring, 6.0, -1.0)]);
    assert_eq!(met(&knob, down(1.5)), [leaves(flange, 3.0, -1.0)]);
    assert_eq!(met(&knob, up(1.5)), [enters(flange, 7.0, -1.0)]);
    assert_eq!(met(&knob, up(0.25)), []);
}

#[test]
fn a_ray_needs_numbers_and_a_direction() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for i in 0..3 {
            let mut v = [1.0; 3];
            v[i] = bad;
            assert_eq!(Ray::new(v, [1.0; 3]), Err(RayError::OriginNotFinite { origin: v }));
            assert_eq!(Ray::new([1.0; 3], v), Err(RayError::DirectionNotFinite { direction: v }));
        }
    }
    for direction in [[0.0, -0.0, 0.0], [1e-40, 0.0, 0.0]] {
        assert_eq!(Ray::new([1.0; 3], direction), Err(RayError::NoDirection { direction }));
    }
    let ball = Lathe::turn(Profile::sphere(1.0).unwrap());
    let ray = Ray::new([0.0, -3.0, 0.0], [0.0, 1.0, 0.0]).unwrap();
    assert_eq!(ball.nearest(&ray, f32::NAN), None, "beyond nothing");
    assert_eq!(ball.nearest(&ray, f32::INFINITY), None);
    assert_eq!(ball.nearest(&ray, f32::NEG_INFINITY).unwrap().t, 2.0);
    assert_eq!(ball.nearest(&ray, 2.0).unwrap().t, 4.0, "beyond, not at");
    assert!(!ball.nearest(&ray, 3.0).unwrap().enters);
}

/// The same scene at any scale of solid and of direction: t is the distance over the direction's length.
#[test]
fn scale_does_not_matter() {
    for solid in [-40, -20, 0, 20, 40] {
        let size = 2_f32.powi(solid);
        let profile = Profile::<1>::from_squared_radii(
            &[0.0, size],
            &[0.5, 0.7, 0.2, 0.4].map(|b: f32| b * size * size),
        );
        let lathe = Lathe::turn(profile.unwrap().closed());
        for direction in [-60, -3, 0, 3, 60] {
            let length = 2_f32.powi(direction);
            let origin = [0.2, -3.0, 0.3].map(|c: f32| c * size);
            let ray = Ray::new(origin, [0.1, 1.0, 0.05].map(|c: f32| c * length)).unwrap();
            let hit = lathe.nearest(&ray, 0.0).unwrap();
            let unit = Lathe::turn(
                Profile::<1>::from_squared_radii(&[0.0, 1.0], &[0.5, 0.7, 0.2, 0.4]).unwrap().closed(),
            );
            let same = unit.nearest(&Ray::new([0.2, -3.0, 0.3], [0.1, 1.0, 0.05]).unwrap(), 0.0).unwrap();
            // Powers of two: the very same bits.
            assert_eq!((hit.t * length / size, hit.u), (same.t, same.u), "2^{solid}, 2^{direction}");
        }
    }
}

/// Any bits of a ray: a clear answer, nothing NaN.
#[test]
fn any_bits_of_a_ray_will_do() {
    use rand::{Rng, SeedableRng};
    let mut rng = rand::rngs::ChaCha8Rng::seed_from_u64(42);
    let lathe = Lathe::turn(profile(&KNOTS, &ORDINATES).unwrap().squash(0.3).unwrap().closed());
    let mut met = 0;
    for _ in 0..500_000 {
        let [ox, oy, oz, dx, dy, dz, t_min] = [(); 7].map(|()| f32::from_bits(rng.next_u32()));
        let Ok(ray) = Ray::new([ox, oy, oz], [dx, dy, dz]) else { continue };
        for hit in lathe.hits::<17>(&ray, t_min) {
            met += 1;
            assert!(hit.t > t_min && (0.0..=1.0).contains(&hit.u), "{ray:?} {hit:?}");
            let [x, y, z] = lathe.surface(&ray, &hit).normal;
            assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6);
        }
    }
    assert!(met > 100, "{met}");
}
