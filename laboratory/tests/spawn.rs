//! Rays that go on from a hit: they do not meet the surface that they leave, and all else as they should.

use embedded_lathe::{Hit, Part, Pose, Ray, Rgb, Rotation, Solid};
use laboratory::cases::{Family, cases, outlines, stepped_outlines};
use laboratory::lathes::lathe;
use laboratory::oracle::{self, Shape};
use laboratory::{PROMISE, ROUNDOFF};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

const SEED: u64 = 1995;
const RAYS: u64 = 60;

fn direction(rng: &mut ChaCha8Rng) -> [f32; 3] {
    [(); 3].map(|()| rng.random_range(-1.0_f32..1.0))
}

fn wide(v: [f32; 3]) -> [f64; 3] {
    v.map(f64::from)
}

/// What the ray should meet first, `None` if it should miss; an error if its start is not clear of the surface, or a rounding
/// may decide.
fn truth(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> Result<Option<oracle::Band>, ()> {
    let ray = oracle::Ray { origin, direction, t_min: 0.0 };
    let bands = oracle::bands(shape, &ray, PROMISE * shape.unit(origin));
    match bands.sure.first() {
        Some(band) => Ok(Some(*band)),
        None if bands.complete => Ok(None),
        None => Err(()),
    }
}

fn agrees(hit: Option<Hit>, band: Option<oracle::Band>) -> bool {
    match (hit, band) {
        (None, None) => true,
        (Some(hit), Some(band)) => hit.enters == band.enters && band.holds(hit.t),
        _ => false,
    }
}

#[test]
fn a_spawned_ray_leaves_its_surface() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let (mut spawned, mut unsure, mut naive) = (0, 0, 0);
    for outline in outlines().iter().chain(&stepped_outlines()) {
        let (shape, lathe) = (outline.shape(), lathe(outline));
        let is_convex = ["cylinder", "cone", "sphere", "ellipsoid"].contains(&outline.name);
        for case in Family::ALL.into_iter().flat_map(|family| cases(outline, family, SEED, RAYS)) {
            let ray = Ray::new(case.cast.origin, case.cast.direction).unwrap();
            let Some(hit) = lathe.nearest(&ray, case.cast.t_min) else { continue };
            let met = lathe.surface(&ray, &hit);
            let point = met.point;
            for _ in 0..4 {
                let towards = direction(&mut rng);
                let next = lathe.spawn(&ray, &hit, towards).unwrap();
                let nearest = lathe.nearest(&next, 0.0);
                let origin = wide(next.origin());
                // No farther away than the bound says.
                let offset = (0..3).map(|i| (origin[i] - f64::from(point[i])).powi(2)).sum::<f64>().sqrt();
                let [x, y, z] = wide(case.cast.origin);
                let lengths = 4.0 * 0.5 * 2.0_f64.sqrt() * shape.size()
                    + [x, y, z - shape.middle()].iter().map(|c| c.abs()).sum::<f64>()
                    + 2.0 * wide(point).iter().map(|c| c.abs()).sum::<f64>();
                assert!(offset <= 16.5 * ROUNDOFF * lengths, "{offset} of {lengths}\n{case}");

                spawned += 1;
                let normal = wide(met.normal);
                let is_outward = (0..3).map(|i| normal[i] * f64::from(towards[i])).sum::<f64>() > 0.0;
                assert!(!(is_convex && is_outward && nearest.is_some()), "{nearest:?} by {next:?}\n{case}");
                match truth(&shape, origin, wide(towards)) {
                    Ok(band) => {
                        assert!(agrees(nearest, band), "{nearest:?} is not {band:?} by {next:?}\n{case}")
                    }
                    Err(()) => unsure += 1,
                }
                // What a ray does that starts at the point itself.
                let at = Ray::new(point, towards).unwrap();
                let again = lathe.nearest(&at, 0.0).is_some_and(|hit| f64::from(hit.t) < 1e-5 * shape.size());
                naive += usize::from(again);
            }
        }
    }
    assert!(spawned > 10_000, "{spawned}");
    // Grazing ones, and those from a rim, a crease or a tip.
    assert!(unsure < spawned / 20, "{unsure} of {spawned} are not sure");
    assert!(naive > spawned / 4, "only {naive} of {spawned} are met again without the offset");
}

/// Among solids in the world: from a hit of one none of it is met at once, and of another what lies in the way is.
#[test]
fn shadows_among_solids() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let shapes = outlines();
    let lathes: Vec<_> = shapes.iter().map(lathe).collect();
    let convex: Vec<_> =
        (0..shapes.len()).filter(|&i| ["cylinder", "cone", "sphere"].contains(&shapes[i].name)).collect();
    let mut left = 0;
    for _ in 0..2_000 {
        let place =
            [(); 3].map(|()| 10_f32.powf(rng.random_range(-2.0..3.0)) * [1.0, -1.0][rng.random_range(0..2)]);
        let turn = Rotation::about_x(rng.random_range(-3.0..3.0))
            .then(Rotation::about_z(rng.random_range(-3.0..3.0)));
        let scale = 10_f32.powf(rng.random_range(-2.0..2.0));
        let one = &lathes[convex[rng.random_range(0..convex.len())]];
        let solid = Solid::new(one, Rgb::WHITE).posed(Pose::new(place, turn, scale).unwrap());
        for _ in 0..10 {
            let way = direction(&mut rng);
            let from = std::array::from_fn(|i| place[i] - scale * 4.0 * way[i]);
            let Ok(ray) = Ray::new(from, way) else { continue };
            let Some(hit) = solid.nearest(&ray, 0.0) else { continue };
            let normal = solid.surface(&ray, &hit).normal;
            let towards = direction(&mut rng);
            let next = solid.spawn(&ray, &hit, towards).unwrap();
            let cos = (0..3).map(|i| towards[i] * normal[i]).sum::<f32>();
            // Beside a rim either side is near.
            let is_met = solid.is_hit(&next, 0.0);
            if hit.part == Part::Wall && (0.01..0.99).contains(&hit.u) {
                assert_eq!(is_met, cos < 0.0, "{hit:?} {ray:?} {next:?} {solid:?}");
                left += 1;
            }
        }
    }
    assert!(left > 3_000, "{left}");
}
