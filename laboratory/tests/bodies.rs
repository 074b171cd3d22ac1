//! Bodies of several sheets: what rays meet of them is what they should, and no ray slips in where two sheets meet.
//!
//! The unit of error is 2⁻²⁴·(size of the body + distance of the ray's origin from its first sheet's middle).

use embedded_lathe::{Hit, Lathe, Pose, Profile, Ray, Rgb, Rotation, SceneError, Segment, Sheet, Solid};
use laboratory::cases::{Body, Case, Cast, Family, Outline, bodies, cases};
use laboratory::lathes::ended;
use laboratory::oracle;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

const SEED: u64 = 1995;
const RAYS: u64 = 400;
/// As for single lathes: a ray that is clear of silhouettes, rims and its start by this number of units hits what it
/// should.
const CLEARANCE: f64 = 4.0;
const CAPACITY: usize = 3 * (4 * 4 + 1);

type Turned = Lathe<[Segment; 4]>;

fn profile(outline: &Outline) -> Profile<4> {
    let profile = Profile::from_squared_radii(&outline.knots, &outline.ordinates);
    ended(profile.unwrap().squash(outline.k).unwrap(), outline)
}

fn turned(body: &Body) -> Vec<Turned> {
    let first = profile(&body.sheets[0].0);
    body.sheets.iter().map(|(outline, _)| Lathe::turn_beside(profile(outline), &first)).collect()
}

fn sheets<'a>(body: &Body, lathes: &'a [Turned]) -> Vec<Sheet<'a>> {
    let sides = body.sheets.iter().map(|(_, is_inner)| *is_inner);
    let sheet = |(lathe, is_inner): (&'a Turned, bool)| {
        if is_inner { Sheet::inner(lathe) } else { Sheet::outer(lathe) }
    };
    lathes.iter().zip(sides).map(sheet).collect()
}

/// Units of a ray at a body.
fn eps(body: &Body, cast: &Cast, units: f64) -> f64 {
    let [x, y, z] = cast.origin.map(f64::from);
    let distance = x.hypot(y).hypot(z - body.sheets[0].0.middle());
    units * (-24_f64).exp2() * (body.size() + distance)
}

fn every_body(mut check: impl FnMut(&Body, &Solid)) {
    for body in bodies() {
        let lathes = turned(&body);
        let sheets = sheets(&body, &lathes);
        check(&body, &Solid::body(&sheets, Rgb::WHITE).expect(body.name));
    }
}

fn every_ray(mut check: impl FnMut(&Body, &Solid, &Case, &Ray)) {
    every_body(|body, solid| {
        for (outline, _) in &body.sheets {
            for case in Family::ALL.into_iter().flat_map(|family| cases(outline, family, SEED, RAYS)) {
                let ray = Ray::new(case.cast.origin, case.cast.direction).expect("a finite ray");
                check(body, solid, &case, &ray);
            }
        }
    });
}

#[test]
fn rays_meet_what_they_should() {
    let (mut told, mut all) = (0, 0);
    every_ray(|body, solid, case, ray| {
        let t_min = case.cast.t_min;
        let (nearest, hits) = (solid.nearest(ray, t_min), solid.hits::<CAPACITY>(ray, t_min));
        let what = || format!("{hits:?} of the {} by {case}", body.name);
        assert_eq!(nearest, hits.first().copied(), "{}", what());
        assert_eq!(solid.is_hit(ray, t_min), nearest.is_some(), "{}", what());
        assert!(hits.is_sorted_by(|one, next| one.t <= next.t), "{}", what());
        let [few, full] = [&solid.hits::<2>(ray, t_min)[..], &hits];
        assert_eq!(few, &full[..full.len().min(2)], "{}", what());
        all += 1;
        let Some(expected) = body.crossings(&case.ray(), eps(body, &case.cast, CLEARANCE)) else { return };
        told += 1;
        assert_eq!(hits.len(), expected.len(), "{expected:?}: {}", what());
        for (hit, band) in hits.iter().zip(&expected) {
            let (t, slack) = (f64::from(hit.t), 4.0 * f64::from(hit.t).abs() * (-24_f64).exp2());
            let is_within = (band.from - slack..=band.to + slack).contains(&t);
            assert!(is_within && hit.enters == band.enters, "{hit:?} is not {band:?}: {}", what());
            let own = solid.sheets().nth(band.sheet).unwrap();
            assert!(core::ptr::eq(solid.sheet_of(hit), own), "{hit:?} is not {band:?}: {}", what());
            // The normal points out of the material.
            let normal = solid.surface(ray, hit).normal.map(f64::from);
            let facing: f64 = (0..3).map(|i| normal[i] * f64::from(case.cast.direction[i])).sum();
            let blunt = 1e-3 * case.cast.direction.iter().map(|c| f64::from(c.abs())).sum::<f64>();
            assert!(
                facing.abs() < blunt || (facing < 0.0) == hit.enters,
                "{normal:?} of {hit:?}: {}",
                what()
            );
        }
        // Closed outlines: what is entered is left.
        let alternate = hits.is_sorted_by(|one, next| one.enters != next.enters);
        assert!(alternate, "{}", what());
    });
    assert!(told * 10 > all * 8, "{told} of {all}");
}

/// Rays from outside at rims, where sheets meet, to the last bit or almost: what is entered is left, and nothing is left that
/// was not entered, but for crossings that rounding cannot tell apart.
#[test]
fn no_ray_slips_between_two_sheets() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let mut met = 0;
    every_body(|body, solid| {
        let size = body.size();
        let k = f64::from(body.sheets[0].0.k);
        for (outline, _) in &body.sheets {
            let shape = outline.shape();
            for _ in 0..20_000 {
                let knot = rng.random_range(0..shape.knots.len());
                let square = shape.radii(knot)[rng.random_range(0..2)];
                let (sin, cos) = rng.random_range(-3.2_f64..3.2).sin_cos();
                let rim = [square.sqrt() * cos / k.sqrt(), square.sqrt() * sin, shape.knots[knot]];
                let off = size * 10_f64.powf(rng.random_range(-9.0..-5.0));
                let target = rim.map(|c| c + off * rng.random_range(-1.0..1.0));
                let direction = [(); 3].map(|()| rng.random_range(-1.0_f32..1.0));
                let length = direction.iter().map(|c| f64::from(c * c)).sum::<f64>().sqrt();
                let back = size * rng.random_range(2.0 / k..4.0 / k) / length;
                let origin = std::array::from_fn(|i| (target[i] - back * f64::from(direction[i])) as f32);
                let Ok(ray) = Ray::new(origin, direction) else { continue };
                let hits = solid.hits::<CAPACITY>(&ray, 0.0);
                let cast = Cast { origin, direction, t_min: 0.0 };
                let what = || format!("{hits:?} of the {} by {cast:?}", body.name);
                assert!(hits.len() % 2 == 0, "{}", what());
                let mut depth = 0;
                for (number, hit) in hits.iter().enumerate() {
                    depth += if hit.enters { 1 } else { -1 };
                    // A crossing too early, or too late, by rounding.
                    let next = hits.get(number + 1).map_or(f32::INFINITY, |next| next.t);
                    let gap = f64::from(next - hit.t) * length;
                    let is_thin = gap < same(solid, &ray, hit, eps(body, &cast, CLEARANCE));
                    assert!(
                        (0..=1).contains(&depth) || is_thin,
                        "{depth} behind {number}, {gap:e}: {}",
                        what()
                    );
                }
                assert_eq!(depth, 0, "{}", what());
                met += hits.len();
            }
        }
    });
    assert!(met > 500_000, "{met}");
}

/// How far apart two crossings that should be one may lie along a ray: twice what each may be off, over the cosine.
fn same(solid: &Solid, ray: &Ray, hit: &Hit, eps: f64) -> f64 {
    let normal = solid.surface(ray, hit).normal.map(f64::from);
    let direction = ray.direction().map(f64::from);
    let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
    let cos = (0..3).map(|i| normal[i] * direction[i]).sum::<f64>().abs() / length;
    2.0 * eps / cos.max(1e-3)
}

/// Points are inside as the sheets that hold them say, and what leaves them says the same.
#[test]
fn points_inside() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let (mut inside, mut all) = (0, 0);
    every_body(|body, solid| {
        let shape = body.sheets[0].0.shape();
        let size = body.size();
        for _ in 0..20_000 {
            let wide = 1.2 * shape.widest() / shape.k.sqrt();
            let point = [
                rng.random_range(-wide..wide),
                rng.random_range(-wide..wide),
                rng.random_range(shape.base() - 0.1 * size..shape.top() + 0.1 * size),
            ];
            let point = point.map(|c| c as f32);
            let exact = point.map(f64::from);
            // Clear of the surface, as all its neighbours say.
            let depth = body.depth(exact);
            let near = [-1e-5, 1e-5].into_iter().flat_map(|off| {
                (0..3).map(move |i| std::array::from_fn(|j| exact[j] + if i == j { off * size } else { 0.0 }))
            });
            if near.map(|point| body.depth(point)).any(|other| other != depth) {
                continue;
            }
            assert!((0..=1).contains(&depth), "{point:?} is {depth} deep in the {}", body.name);
            assert_eq!(solid.is_inside(point), depth == 1, "{point:?} in the {}", body.name);
            (inside, all) = (inside + depth, all + 1);
        }
    });
    assert!(all > 150_000 && inside > all / 20, "{inside} of {all}");
}

/// A ray that goes on from a hit begins on the side that it goes to.
#[test]
fn spawned_rays_begin_on_their_side() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let mut spawned = 0;
    let position = [1.0, -2.0, 0.5];
    let pose = Pose::new(position, Rotation::about_x(0.7).then(Rotation::about_z(0.4)), 1.5).unwrap();
    every_body(|body, solid| {
        let solid = solid.posed(pose);
        for _ in 0..4_000 {
            let [to, from] = [0.5, 4.0].map(|size| [(); 3].map(|()| rng.random_range(-size..size)));
            let origin: [f32; 3] = std::array::from_fn(|i| position[i] + to[i] + from[i]);
            let direction = std::array::from_fn(|i| -from[i]);
            let Ok(ray) = Ray::new(origin, direction) else { continue };
            let Some(hit) = solid.nearest(&ray, 0.0) else { continue };
            let normal = solid.surface(&ray, &hit).normal;
            let towards = [(); 3].map(|()| rng.random_range(-1.0_f32..1.0));
            let leaves = (0..3).map(|i| normal[i] * towards[i]).sum::<f32>();
            if leaves.abs() < 0.1 {
                continue;
            }
            let next = solid.spawn(&ray, &hit, towards).unwrap();
            let first = solid.nearest(&next, 0.0);
            let what = format!("{hit:?} of the {} by {ray:?}: {first:?} by {next:?}", body.name);
            // From within something is met, and left; from without, if anything, entered.
            assert!(first.map_or(leaves > 0.0, |first| first.enters == (leaves > 0.0)), "{what}");
            spawned += 1;
        }
    });
    assert!(spawned > 5_000, "{spawned}");
}

#[test]
fn sheets_that_make_no_body() {
    let outline = |k| profile(&Outline { k, ..bodies()[0].sheets[0].0.clone() });
    let [first, squashed, apart] = [
        Lathe::turn(outline(1.0)),
        Lathe::turn(outline(0.5)),
        Lathe::turn(Profile::<4>::from_squared_radii(&[0.0, 0.5], &[0.1; 4]).unwrap()),
    ];
    let body = |sheets: &[Sheet]| Solid::body(sheets, Rgb::WHITE).map(|_| ());
    assert_eq!(body(&[]), Err(SceneError::NoSheets));
    assert_eq!(body(&[Sheet::outer(&first), Sheet::inner(&first)]), Ok(()));
    let error = SceneError::SheetSquash { sheet: 1, squash: 0.5, first: 1.0 };
    assert_eq!(body(&[Sheet::outer(&first), Sheet::inner(&squashed)]), Err(error));
    let error = SceneError::SheetMiddle { sheet: 2, middle: 0.25, first: 0.5 };
    assert_eq!(body(&[Sheet::outer(&first), Sheet::inner(&first), Sheet::inner(&apart)]), Err(error));
    let message = "sheet 2 must be turned beside the first, about the height 0.5, and is turned about 0.25";
    assert_eq!(error.to_string(), message);
}

/// The oracle knows the same.
#[test]
fn bodies_are_closed_outlines() {
    let mut rays = 0;
    every_ray(|body, _, case, _| {
        let ray: oracle::Ray = case.ray();
        let Some(expected) = body.crossings(&ray, 1e-9 * body.size()) else { return };
        assert!(expected.is_sorted_by(|one, next| one.enters != next.enters), "{expected:?}\n{case}");
        rays += 1;
    });
    assert!(rays > 50_000, "{rays}");
}
