//! Profiles through points: monotone where the points are, smooth, exact for quadrics.

use embedded_lathe::{Profile, ProfileError};
use rand::{RngExt, SeedableRng, rngs::ChaCha8Rng};

type Points = Vec<(f32, f32)>;

/// The radius at a height: where a level ray from outside hits.
fn radius(profile: &Profile<16>, z: f32) -> f32 {
    use embedded_lathe::{Lathe, Ray};
    let lathe = Lathe::turn(*profile);
    let size = 4.0 * profile.largest_radius();
    let ray = Ray::new([size, 0.0, z], [-1.0, 0.0, 0.0]).unwrap();
    lathe.nearest(&ray, 0.0).map_or(0.0, |hit| size - hit.t)
}

fn random(rng: &mut ChaCha8Rng) -> Points {
    let mut z = 0.0;
    let count = rng.random_range(2..9);
    let mut points: Points = Vec::new();
    for _ in 0..count {
        let point = (z, rng.random_range(0.05..1.0));
        points.push(point);
        if rng.random_range(0..5) == 0 {
            points.push(point);
        }
        z += [1e-2, 0.1, 1.0][rng.random_range(0..3)] * rng.random_range(0.5..1.0);
    }
    for end in [0, points.len() - 1] {
        if rng.random() && points.len() > 3 {
            let z = points[end].0;
            points.iter_mut().filter(|point| point.0 == z).for_each(|point| point.1 = 0.0);
        }
    }
    points
}

#[test]
fn radii_stay_between_those_of_the_points() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut turns = 0;
    for case in 0..400 {
        let points = random(&mut rng);
        let Ok(profile) = Profile::<16>::through(&points) else { panic!("case {case}: {points:?}") };
        let mut before = None;
        for pair in points.windows(2).filter(|pair| pair[0] != pair[1]) {
            let ((z0, r0), (z1, r1)) = (pair[0], pair[1]);
            let mut last = r0;
            for i in 1..16 {
                let r = radius(&profile, z0 + (z1 - z0) * i as f32 / 16.0);
                // Rays are good to some 10⁻⁶ of the size.
                let slack = 1e-4 * (r0 + r1);
                assert!(r >= r0.min(r1) - slack && r <= r0.max(r1) + slack, "case {case}: {r} {points:?}");
                assert!((r - last) * (r1 - r0).signum() >= -slack, "case {case}: {points:?}");
                last = r;
            }
            turns += usize::from(before.is_some_and(|rise: f32| rise * (r1 - r0) < 0.0));
            before = Some(r1 - r0);
        }
    }
    assert!(turns > 100, "only {turns} turns came up");
}

#[test]
fn points_of_quadrics_give_quadrics() {
    type Quadric = fn(f32) -> f32;
    let cases: [(&str, Quadric, &[f32]); 5] = [
        ("sphere", |z| (2.0 * z - z * z).sqrt(), &[0.0, 0.5, 1.0, 1.7, 2.0]),
        ("cone", |z| 0.2 + 0.5 * z, &[0.0, 0.3, 1.0, 1.1]),
        ("paraboloid", |z| z.sqrt(), &[0.0, 0.4, 1.0]),
        ("cylinder", |_| 0.3, &[0.0, 0.4, 1.0]),
        ("hyperboloid", |z| (0.1 + (z - 0.7) * (z - 0.7)).sqrt(), &[0.0, 0.3, 0.7, 1.5]),
    ];
    for (name, quadric, heights) in cases {
        let points: Points = heights.iter().map(|z| (*z, quadric(*z))).collect();
        let profile = Profile::<16>::through(&points).unwrap();
        let top = heights[heights.len() - 1];
        for i in 1..40 {
            let z = top * i as f32 / 40.0;
            let (found, right) = (radius(&profile, z), quadric(z));
            assert!((found - right).abs() < 3e-6 / right.max(0.1), "{name} at {z}: {found} for {right}");
        }
    }
}

#[test]
fn poles_are_round_or_pointed() {
    let near = |points: &[(f32, f32)]| radius(&Profile::<16>::through(points).unwrap(), 1e-4);
    // r ~ √z, or r ~ z.
    assert!(near(&[(0.0, 0.0), (0.5, 0.5), (1.0, 0.6)]) > 5e-3);
    assert!(near(&[(0.0, 0.0), (0.0, 0.0), (0.5, 0.5), (1.0, 0.6)]) < 5e-4);
    let straight = Profile::<16>::straight(&[(0.0, 0.0), (0.5, 0.5), (1.0, 0.6)]).unwrap();
    assert!((radius(&straight, 0.25) - 0.25).abs() < 1e-6 && (radius(&straight, 0.75) - 0.55).abs() < 1e-6);
}

#[test]
fn two_points_at_one_height_are_a_step() {
    // A knob: its base, a rim, a ledge, a stem with a flat top.
    let points = [(0.0, 0.0), (0.0, 3.0), (1.0, 3.0), (1.0, 2.0), (4.0, 2.0), (4.0, 0.0)];
    let [through, straight] = [Profile::<2>::through(&points), Profile::<2>::straight(&points)];
    let knots = [0.0, 0.0, 1.0, 1.0, 4.0, 4.0];
    let same = Profile::from_squared_radii(&knots, &[0.0, 9.0, 9.0, 9.0, 9.0, 4.0, 4.0, 4.0, 4.0, 0.0]);
    assert_eq!((&through, &straight), (&same, &same));
    let thrice = Profile::<2>::through(&[(0.0, 1.0), (1.0, 1.0), (1.0, 2.0), (1.0, 3.0), (2.0, 3.0)]);
    assert_eq!(thrice, Err(ProfileError::KnotThrice { knot: 3, height: 1.0 }));
}

#[test]
fn errors_name_the_point() {
    let through = Profile::<2>::through;
    let negative = through(&[(0.0, 1.0), (1.0, -0.5)]);
    assert_eq!(negative, Err(ProfileError::Radius { point: 1, radius: -0.5 }));
    assert_eq!(negative.unwrap_err().to_string(), "the radius of point 1 is -0.5");
    assert!(matches!(through(&[(0.0, f32::NAN), (1.0, 1.0)]), Err(ProfileError::Radius { point: 0, .. })));
    assert_eq!(through(&[]), Err(ProfileError::NoSegments { knots: 0 }));
    assert_eq!(through(&[(0.0, 1.0), (0.0, 1.0)]), Err(ProfileError::NoSegments { knots: 1 }));
    let many = [(0.0, 1.0), (1.0, 1.0), (2.0, 1.0), (3.0, 1.0)];
    assert_eq!(through(&many), Err(ProfileError::TooManySegments { segments: 3, capacity: 2 }));
    let falling = through(&[(0.0, 1.0), (1.0, 1.0), (0.5, 1.0)]);
    assert_eq!(falling, Err(ProfileError::KnotsNotIncreasing { knot: 2, before: 1.0, height: 0.5 }));
    assert!(matches!(through(&[(0.0, 0.0), (1.0, 0.0)]), Err(ProfileError::Size { .. })));
    assert!(matches!(
        through(&[(0.0, 1.0), (f32::INFINITY, 1.0)]),
        Err(ProfileError::KnotNotFinite { knot: 1, .. })
    ));
}
