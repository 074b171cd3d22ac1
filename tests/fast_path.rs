//! The fast path of single rays finds the crossings that the traversal alone finds.

mod random;

use embedded_lathe::math::Native;
use embedded_lathe::solve::Split;
use embedded_lathe::{End, Hit, Lathe, Part, Profile, Ray, Segment};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use random::{even, random_camera, random_lathe, upright_camera};

const LATHES: u32 = 6_000;
const RAYS: u32 = 250;
const SIDE: u32 = 4_000;

/// Two hits are of one crossing if their t differ by less than this, times 1 + |t|. The fast path certifies a
/// root only if g rises above the tolerance behind it. The tolerance is at least sixteen units of 2⁻²⁴, and
/// its square root is 10⁻³.
const SAME: f32 = 1e-3;

/// Hits of a lathe of eight segments.
type Hits = heapless::Vec<Hit, 33>;

/// Returns the nearest hit. Panics if the traversal alone finds another one, or if `is_hit` does not agree.
fn agree(lathe: &Lathe<[Segment; 8]>, ray: &Ray, t_min: f32, what: &str) -> Option<Hit> {
    let (found, traversed) = (lathe.nearest(ray, t_min), lathe.nearest_by::<Split<Native>>(ray, t_min));
    let is_same = match (found, traversed) {
        (None, None) => true,
        (Some(found), Some(traversed)) => {
            (found.t - traversed.t).abs() < SAME * (1.0 + found.t.abs())
                && (found.enters, found.part) == (traversed.enters, traversed.part)
        }
        _ => false,
    };
    assert_eq!(found.is_some(), lathe.is_hit(ray, t_min), "{what}: {ray:?} at {lathe:?}");
    assert!(is_same, "{what}: {found:?} is not {traversed:?}, beyond {t_min} on {ray:?} at {lathe:?}");
    found
}

#[test]
fn the_fast_path_finds_what_the_traversal_finds() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let (mut hits, mut rays) = (0, 0);
    for number in 0..LATHES {
        let lathe = random_lathe(&mut rng);
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        for _ in 0..RAYS {
            let (x, y) = (rng.random_range(0..SIDE), rng.random_range(0..SIDE));
            let ray = camera.ray(x, y, SIDE, SIDE);
            let t_min = if rng.random_ratio(1, 4) { even(&mut rng, -3.0, 3.0) } else { 0.0 };
            let found = agree(&lathe, &ray, t_min, &format!("lathe {number}"));
            (rays, hits) = (rays + 1, hits + u32::from(found.is_some()));
        }
    }
    assert!(rays / 4 < hits && hits < rays * 3 / 4, "{hits} of {rays} rays hit");
}

/// Heights and squared radii over three decades; most joins are creases.
fn uneven_lathe(rng: &mut ChaCha8Rng) -> (Lathe<[Segment; 8]>, Vec<f32>, Vec<f32>) {
    let decades = |rng: &mut ChaCha8Rng| 10_f32.powf(even(rng, -3.0, 0.0));
    loop {
        let segments = rng.random_range(1..=8);
        let mut knots = vec![even(rng, -1.0, 0.0)];
        for _ in 0..segments {
            knots.push(knots[knots.len() - 1] + decades(rng));
        }
        let ordinates: Vec<f32> = (0..3 * segments + 1).map(|_| decades(rng)).collect();
        let end = |open| if open { End::Open } else { End::Capped };
        if let Ok(profile) = Profile::<8>::from_squared_radii(&knots, &ordinates) {
            let lathe = Lathe::turn(profile.base(end(rng.random())).top(end(rng.random())));
            return (lathe, knots, ordinates);
        }
    }
}

/// Rays of any length at joins and rims, from where they come and from where they meet the surface: the
/// nearest hit is the first of all, and those follow one another. (At a rim, hit and miss are as good.)
#[test]
fn the_nearest_hit_is_the_first_of_all() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let mut hits = 0;
    for number in 0..LATHES {
        let (lathe, knots, ordinates) = uneven_lathe(&mut rng);
        for _ in 0..RAYS / 2 {
            // At a join or a rim to the last bit, or somewhere about it.
            let knot = rng.random_range(0..knots.len());
            let (radius, z) = (ordinates[3 * knot].sqrt(), knots[knot]);
            let (sin, cos) = even(&mut rng, -3.2, 3.2).sin_cos();
            let exactly = rng.random();
            let target = if exactly {
                [radius * cos, radius * sin, z]
            } else {
                [even(&mut rng, -0.8, 0.8), even(&mut rng, -0.8, 0.8), z + even(&mut rng, -0.01, 0.01)]
            };
            let direction = [(); 3].map(|()| even(&mut rng, -4.0, 4.0));
            let origin = std::array::from_fn(|i| target[i] - direction[i]);
            let Ok(ray) = Ray::new(origin, direction) else { continue };
            let what = format!("lathe {number}");
            let found = if exactly { lathe.nearest(&ray, 0.0) } else { agree(&lathe, &ray, 0.0, &what) };
            let Some(hit) = found else { continue };
            hits += 1;
            // From there on, any way.
            let direction = [(); 3].map(|()| even(&mut rng, -4.0, 4.0));
            let Ok(next) = Ray::new(ray.at(hit.t), direction) else { continue };
            for ray in [ray, next] {
                let (nearest, all): (_, Hits) = (lathe.nearest(&ray, 0.0), lathe.hits(&ray, 0.0));
                assert_eq!(nearest, all.first().copied(), "{what}: {ray:?} at {lathe:?}");
                let follow = all.is_sorted_by(|one, next| one.t <= next.t && one.enters != next.enters);
                assert!(follow, "{what}: {all:?} by {ray:?} at {lathe:?}");
            }
        }
    }
    assert!(hits > LATHES * RAYS / 10, "{hits} hits");
}

/// From within a needle, however high, a ray leaves it.
#[test]
fn rays_leave_a_needle() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    for height in [1e3, 1e5, 3e5, 1e6] {
        let needle = Lathe::turn(Profile::<1>::cylinder(1.0, height).unwrap());
        for _ in 0..10_000 {
            let origin = [0.0, 0.0, height * even(&mut rng, 0.001, 0.999)];
            let ray = Ray::new(origin, [even(&mut rng, 0.1, 2.0), even(&mut rng, -2.0, 2.0), 1.0]).unwrap();
            let (nearest, all): (_, heapless::Vec<Hit, 5>) =
                (needle.nearest(&ray, 0.0), needle.hits(&ray, 0.0));
            assert!(nearest.is_some_and(|hit| !hit.enters), "{height:e}: {ray:?}");
            assert_eq!(nearest, all.first().copied(), "{height:e}: {ray:?}");
        }
    }
}

/// Rays that begin on the surface, at a join, a wall or a rim have as many hits as by the traversal alone,
/// and the first of them is the nearest.
#[test]
fn rays_from_the_surface() {
    let turned = |knots: &[f32], ordinates: &[f32], k: f32, base, top| {
        Lathe::turn(
            Profile::<8>::from_squared_radii(knots, ordinates)
                .unwrap()
                .squash(k)
                .unwrap()
                .base(base)
                .top(top),
        )
    };
    let (open, capped) = (End::Open, End::Capped);
    let wall = [0.30719712, 0.30011117, 0.3097217, 0.3000663, 0.29041085, 0.31072047, 0.28254128];
    let cases = [
        (
            turned(&[-3.8297892, -3.7297893, -3.6297894], &wall, 1.0, capped, capped),
            Ray::new([-0.29408365, 0.46036878, -3.7226307], [-0.2026828, -0.1294738, -0.030114653]),
        ),
        (
            turned(&[-0.64198023, -0.6414236, -0.6362717], &[0.3194147; 7], 1.0, open, capped),
            Ray::new([0.34936258, -0.44425273, -0.6414236], [0.06563994, 0.21904434, -0.24904598]),
        ),
        (
            turned(&[0.4396598, 0.463303], &[0.4314638, 0.0, 0.38344777, 0.7272914], 0.9252547, open, open),
            Ray::new([0.3926368, 0.7646246, 0.463303], [-0.6647761, -0.91240495, 0.0]),
        ),
    ];
    for (lathe, ray) in cases {
        let ray = ray.unwrap();
        let (hits, traversed): (Hits, Hits) =
            (lathe.hits(&ray, 0.0), lathe.hits_by::<Split<Native>, 33>(&ray, 0.0));
        assert_eq!(hits.len(), traversed.len(), "{hits:?} are not {traversed:?}");
        assert_eq!(lathe.nearest(&ray, 0.0), hits.first().copied(), "{hits:?}");
    }
}

/// A ledge a thousandth wide, on whose ring a ray comes down before it would meet the wall below: that one is not the first, however
/// steeply g rises there.
#[test]
fn a_ledge_hides_the_wall_below() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let (wall, edge) = ([1.0; 4], [1.001; 4]);
    let ordinates = [wall, edge, wall].concat();
    let ledge = Profile::<3>::from_squared_radii(&[0.0, 1.0, 1.0, 1.0005, 1.0005, 2.0], &ordinates).unwrap();
    let ledge = Lathe::turn(ledge);
    for _ in 0..100_000 {
        let target = [even(&mut rng, 1.0001, 1.0009).sqrt(), 0.0, 1.0005];
        let direction = [even(&mut rng, -0.3, -0.02), 1.0, even(&mut rng, -0.9, -0.2)];
        let ray = Ray::new(std::array::from_fn(|i| target[i] - 2.0 * direction[i]), direction).unwrap();
        let hit = ledge.nearest(&ray, 0.0).expect("the ledge");
        assert_eq!(
            (hit.part, hit.segment, hit.u, hit.enters),
            (Part::Ring, 1, 1.0, true),
            "{hit:?} by {ray:?}"
        );
    }
}
