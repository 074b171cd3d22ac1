//! What holds for every ray there is: the three questions agree, and no answer is NaN.

use embedded_lathe::{End, Hit, Lathe, Pose, Profile, Ray, Rgb, Rotation, Segment, Solid};
use laboratory::cases::{Outline, outlines as known, stepped_outlines};
use laboratory::lathes::{CAPACITY, SEGMENTS, ended, lathe};
use laboratory::outlines::Kind;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

type Turned = Lathe<[Segment; SEGMENTS]>;
type Hits = heapless::Vec<Hit, CAPACITY>;

const RAYS: usize = 400;

/// Every shape of the other tests, those of every kind at random, and these at scales as far as profiles go: flat ones, needles,
/// plates, sheets.
fn every_lathe() -> Vec<Turned> {
    let random = Kind::ALL.into_iter().flat_map(|kind| (0..20).map(move |number| kind.outline(7, number)));
    let named: Vec<Outline> = known().into_iter().chain(stepped_outlines()).chain(random).collect();
    let mut all: Vec<Turned> = named.iter().map(lathe).collect();
    for outline in &named {
        for (tall, wide) in [(1e-8, 1.0), (1e8, 1.0), (1e-14, 1e-14), (1e14, 1e14), (1.0, 1e-9), (1.0, 1e9)] {
            for k in [0.0, outline.k] {
                let (knots, ordinates) = (
                    outline.knots.iter().map(|z| z * tall).collect::<Vec<f32>>(),
                    outline.ordinates.iter().map(|b| b * wide * wide).collect::<Vec<f32>>(),
                );
                let Ok(profile) =
                    Profile::from_squared_radii(&knots, &ordinates).and_then(|profile| profile.squash(k))
                else {
                    continue;
                };
                all.push(Lathe::turn(ended(profile, outline)));
            }
        }
    }
    all
}

/// Any finite number: any bits, zero, f32's ends, and numbers of the order of one.
fn number(rng: &mut ChaCha8Rng) -> f32 {
    match rng.random_range(0..8) {
        0 => 0.0,
        1 => [f32::MAX, f32::MIN, f32::MIN_POSITIVE, -0.0, 1e-45][rng.random_range(0..5)],
        2 | 3 => loop {
            let number = f32::from_bits(rng.random());
            if number.is_finite() {
                break number;
            }
        },
        _ => rng.random_range(-2.0_f32..2.0),
    }
}

/// A ray of such numbers, or at the solid from as far as such a number away.
fn any_ray(rng: &mut ChaCha8Rng, scale: f32) -> Ray {
    loop {
        let mut origin = [(); 3].map(|()| number(rng));
        let mut direction = [(); 3].map(|()| number(rng));
        if rng.random() {
            let target = [(); 3].map(|()| scale * rng.random_range(-1.0_f32..1.0));
            let way = number(rng);
            let aimed = std::array::from_fn(|i| target[i] - way * direction[i]);
            if rng.random_ratio(1, 4) {
                origin = target;
            } else {
                origin = aimed;
            }
            if rng.random_ratio(1, 4) {
                direction[rng.random_range(0..3)] = 0.0;
            }
        }
        if let Ok(ray) = Ray::new(origin, direction) {
            return ray;
        }
    }
}

fn any_start(rng: &mut ChaCha8Rng) -> f32 {
    match rng.random_range(0..6) {
        0 => [f32::NEG_INFINITY, f32::INFINITY, f32::NAN, f32::MIN, f32::MAX][rng.random_range(0..5)],
        1 => number(rng),
        2 => rng.random_range(-2.0_f32..2.0),
        _ => 0.0,
    }
}

/// The three questions' answers, which are one. What hits there are.
fn asked(lathe: &Turned, ray: &Ray, t_min: f32) -> Hits {
    let (nearest, hits): (_, Hits) = (lathe.nearest(ray, t_min), lathe.hits(ray, t_min));
    assert_eq!(nearest, hits.first().copied(), "beyond {t_min} on {ray:?} at {lathe:?}");
    assert_eq!(nearest.is_some(), lathe.is_hit(ray, t_min), "beyond {t_min} on {ray:?} at {lathe:?}");
    let follow = hits.is_sorted_by(|one, next| one.t <= next.t && one.enters != next.enters);
    let numbers = hits.iter().all(|hit| hit.t > t_min && hit.t.is_finite() && (0.0..=1.0).contains(&hit.u));
    assert!(follow && numbers, "{hits:?} beyond {t_min} on {ray:?} at {lathe:?}");
    hits
}

fn is_unit(normal: [f32; 3]) -> bool {
    let square: f64 = normal.iter().map(|&c| f64::from(c).powi(2)).sum();
    (square - 1.0).abs() < 1e-6
}

fn every_ray(mut check: impl FnMut(&mut ChaCha8Rng, &Turned, &Ray)) {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    for lathe in every_lathe() {
        // As large as the solid is, about.
        let scale = 10_f32.powi(rng.random_range(-15..15));
        for _ in 0..RAYS {
            let scale = if rng.random() { 1.0 } else { scale };
            let ray = any_ray(&mut rng, scale);
            check(&mut rng, &lathe, &ray);
        }
    }
}

#[test]
fn the_three_questions_agree() {
    let (mut met, mut again) = (0, 0);
    every_ray(|rng, lathe, ray| {
        let start = any_start(rng);
        let hits = asked(lathe, ray, start);
        met += usize::from(!hits.is_empty());
        // From each hit on, and from the numbers beside it.
        for hit in &hits {
            for t_min in [hit.t.next_down(), hit.t, hit.t.next_up()] {
                again += asked(lathe, ray, t_min).len();
            }
        }
    });
    assert!(met > 10_000 && again > 30_000, "{met} rays met, {again} hits again");
}

#[test]
fn no_answer_is_nan() {
    let mut seen = 0;
    every_ray(|rng, lathe, ray| {
        let far = number(rng);
        assert!(ray.at(far).iter().all(|c| c.is_finite()), "{ray:?} at {far}");
        let pose = Pose::new(
            [(); 3].map(|()| number(rng)),
            Rotation::about_x(rng.random_range(-3.0..3.0))
                .then(Rotation::about_z(rng.random_range(-3.0..3.0))),
            10_f32.powf(rng.random_range(-29.9..29.9)),
        );
        let solid = Solid::new(lathe, Rgb::WHITE);
        let posed = solid.posed(pose.unwrap());
        for hit in lathe.hits::<CAPACITY>(ray, any_start(rng)) {
            let met = lathe.surface(ray, &hit);
            let is_finite = met.point.iter().all(|c| c.is_finite());
            assert!(is_finite && is_unit(met.normal), "{met:?} of {hit:?} by {ray:?} at {lathe:?}");
            seen += 1;
        }
        for solid in [solid, posed] {
            let Some(hit) = solid.nearest(ray, 0.0) else { continue };
            let met = solid.surface(ray, &hit);
            let is_finite = met.point.iter().all(|c| c.is_finite());
            assert!(
                hit.t.is_finite() && is_finite && is_unit(met.normal),
                "{met:?} of {hit:?} by {ray:?} at {solid:?}"
            );
            seen += 1;
        }
    });
    assert!(seen > 10_000, "{seen} hits");
}

/// From so far away that where a hit lies is not known to within the solid's size, the normal is still one.
#[test]
fn a_normal_from_beyond_all_digits() {
    let drum = Lathe::turn(Profile::<1>::cylinder(1e15, 1e15).unwrap());
    let ray = Ray::new([0.0, f32::MAX, 5e14], [0.0, -1.003e37, 0.0]).unwrap();
    let hit = drum.nearest(&ray, 0.0).expect("the wall");
    let met = drum.surface(&ray, &hit);
    assert!(met.point.iter().all(|c| c.is_finite()), "{met:?}");
    assert_eq!(met.normal.map(f32::abs), [0.0, 1.0, 0.0]);
}

/// A profile a ten-millionth as high as wide, met from beyond a `t_min` that lies among its crossings.
#[test]
fn a_flat_profile_is_hit_by_all_or_by_none() {
    let f = f32::from_bits;
    let knots = [0xb3d2fede, 0xb2837620, 0x3295a56d, 0x33d2fede].map(f);
    let ordinates = [
        0x41b777db, 0x42885e3c, 0x42ad25dd, 0x425a153c, 0x41cf1f64, 0x429a38e4, 0x396135ba, 0, 0x3f118165,
        0x41425efb,
    ];
    let profile = Profile::from_squared_radii(&knots, &ordinates.map(f)).unwrap().top(End::Capped);
    let ray = Ray::new([1.2721038e-8, 1.181181, 1.8853217], [-0.99114305, 0.7079169, -0.6722731]).unwrap();
    asked(&Lathe::turn(profile), &ray, -0.1373758);
}

/// A shoulder so low that its two knots are one height in the lathe's frame is met like a disc between two radii.
#[test]
fn a_ring_of_no_height() {
    let knots = [-1.0, 0.0, 1e-9, 1.0];
    let ordinates = [0.25, 0.25, 0.25, 0.25, 0.5, 0.75, 1.0, 1.0, 1.0, 1.0];
    let lathe = Lathe::turn(Profile::<SEGMENTS>::from_squared_radii(&knots, &ordinates).unwrap().closed());
    for (x, t, enters) in [(0.75, 3.0, true), (0.25, 2.0, true)] {
        let up = Ray::new([x, 0.0, -3.0], [0.0, 0.0, 1.0]).unwrap();
        let hits = asked(&lathe, &up, 0.0);
        let met: Vec<_> = hits.iter().map(|hit| (hit.t, hit.enters)).collect();
        assert_eq!(met, [(t, enters), (4.0, false)]);
        let down = Ray::new([x, 0.0, 3.0], [0.0, 0.0, -1.0]).unwrap();
        let met: Vec<_> = asked(&lathe, &down, 0.0).iter().map(|hit| (hit.t, hit.enters)).collect();
        assert_eq!(met, [(2.0, true), (6.0 - t, false)]);
    }
}
