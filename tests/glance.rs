//! What most rays meet is told at a glance: the same as by a walk along them, beyond any doubt.

mod random;

use embedded_lathe::math::Native;
use embedded_lathe::solve::Split;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use random::{even, random_camera, random_lathe, upright_camera};

const LATHES: u32 = 10_000;
const RAYS: u32 = 250;
const SIDE: u32 = 4_000;

/// Two answers are one crossing if they are nearer to each other than this part of their distance. What a glance tells
/// is a crossing with a slope of 1/64 at least, in a frame where the solid's radius is between 1 and 2: the next one
/// is farther away.
const SAME: f32 = 1e-3;

#[test]
fn a_glance_tells_what_a_walk_does() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let (mut hits, mut rays) = (0, 0);
    for number in 0..LATHES {
        let lathe = random_lathe(&mut rng);
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        for _ in 0..RAYS {
            let (x, y) = (rng.random_range(0..SIDE), rng.random_range(0..SIDE));
            let ray = camera.ray(x, y, SIDE, SIDE);
            let t_min = if rng.random_ratio(1, 4) { even(&mut rng, -3.0, 3.0) } else { 0.0 };
            let (seen, walked) = (lathe.nearest(&ray, t_min), lathe.nearest_by::<Split<Native>>(&ray, t_min));
            let is_same = match (seen, walked) {
                (None, None) => true,
                (Some(seen), Some(walked)) => {
                    (seen.t - walked.t).abs() < SAME * (1.0 + seen.t.abs())
                        && (seen.enters, seen.part) == (walked.enters, walked.part)
                }
                _ => false,
            };
            assert!(is_same, "lathe {number}: {seen:?} is not {walked:?}, beyond {t_min} on {ray:?}");
            assert_eq!(seen.is_some(), lathe.is_hit(&ray, t_min), "lathe {number}: {ray:?}");
            (rays, hits) = (rays + 1, hits + u32::from(seen.is_some()));
        }
    }
    assert!(rays / 4 < hits && hits < rays * 3 / 4, "{hits} of {rays} rays hit");
}
