//! A convex solid is crossed twice, or not at all: quadrics, met by rays of all kinds.

use embedded_lathe::solve::Solver;
use embedded_lathe::{Lathe, Profile, Ray, Segment};
use laboratory::over_every_backend;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

type Quadric = Lathe<[Segment; 1]>;

/// What makes a profile of three measures.
type Make = fn([f32; 3]) -> Profile<1>;

/// The quadric profiles that make convex solids, `[a, b, c]` their measures.
const QUADRICS: [(&str, Make); 6] = [
    ("cylinder", |[a, b, _]| Profile::cylinder(a, b).unwrap()),
    ("cone", |[a, b, _]| Profile::cone(a, b).unwrap()),
    ("frustum", |[a, b, c]| Profile::frustum(a, b, c).unwrap()),
    ("sphere", |[a, ..]| Profile::sphere(a).unwrap()),
    ("spheroid", |[a, b, _]| Profile::spheroid(a, b).unwrap()),
    ("paraboloid", |[a, b, _]| Profile::paraboloid(a, b).unwrap()),
];

/// A ray from outside, inside or the surface: at a point of the solid, a rim, a tip, or past it.
fn ray(rng: &mut ChaCha8Rng, [a, b, c]: [f32; 3]) -> Ray {
    let size = a.max(b).max(c);
    let mut near = |size: f32| [(); 3].map(|()| size * rng.random_range(-1.0..1.0f32));
    let (place, tiny, from) = (near(1.5 * size), near(1e-6 * size), near(3.0 * size));
    let at = match rng.random_range(0..4) {
        0 => place,
        1 => [0.0, 0.0, b],
        2 => [a, 0.0, 0.0],
        _ => [place[0] * 1e-3, place[1] * 1e-3, place[2]],
    };
    let at: [f32; 3] = std::array::from_fn(|j| at[j] + tiny[j]);
    let mut direction: [f32; 3] = std::array::from_fn(|j| at[j] - from[j]);
    if rng.random_range(0..3) == 0 {
        // Along a side of the cone.
        direction = [direction[0].signum() * a, 1e-4 * direction[1], b];
    }
    let far = if rng.random() { 1.0 } else { 1e-3 };
    let origin = std::array::from_fn(|j| at[j] - far * direction[j]);
    Ray::new(origin, direction).unwrap()
}

fn two_at_most<S: Solver>() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut twice = 0;
    for index in 0..60_000 {
        let measures = [(); 3].map(|()| rng.random_range(0.1..3.0_f32));
        let (name, profile) = QUADRICS[index % QUADRICS.len()];
        let lathe: Quadric = Lathe::turn(profile(measures));
        let ray = ray(&mut rng, measures);
        let by = lathe.hits_by::<S, 5>(&ray, f32::NEG_INFINITY);
        for hits in [&by, &lathe.hits::<5>(&ray, f32::NEG_INFINITY)] {
            assert!(hits.len() <= 2, "{name} {measures:?}, {ray:?}: {hits:?}");
            assert!(hits.windows(2).all(|pair| pair[0].t <= pair[1].t), "{hits:?}");
            assert!(hits.windows(2).all(|pair| pair[0].enters && !pair[1].enters), "{hits:?}");
        }
        twice += usize::from(by.len() == 2);
    }
    assert!(twice > 15_000, "{twice}");
}

over_every_backend!(two_at_most);

/// What once was reported as four crossings.
#[test]
fn the_side_of_a_cone() {
    let cone = Lathe::turn(Profile::<1>::cone(1.0, 2.0).unwrap());
    let ray = Ray::new([-0.37914282, 0.85480225, 0.31061497], [0.76347595, 0.2729686, -0.5853141]).unwrap();
    assert!(cone.hits::<5>(&ray, f32::NEG_INFINITY).len() <= 2);
    assert_eq!(cone.hits::<5>(&ray, 0.0).len(), 2);
}
