//! The crate's promise of hits and places, at outlines of every kind.
//!
//! The unit is [`laboratory::unit`]. Of a place, the hit's own distance counts as well.
//!
//! ```text
//! PROMISE_OUTLINES=2600 cargo test -p embedded-lathe-laboratory --test promise -- --nocapture
//! ```
//!
//! asks 2.4 million rays instead of some thousands, and prints the worst of each kind.

use embedded_lathe::math::Native;
use embedded_lathe::solve::Split;
use embedded_lathe::{Hit, Part, Ray};
use laboratory::cases::{Case, Cast, Family, Outline, cases};
use laboratory::lathes::{is_in, lathe};
use laboratory::oracle::{self, Shape, value};
use laboratory::outlines::Kind;
use laboratory::{PROMISE, ROUNDOFF};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use std::env;

const SEED: u64 = 1995;

/// The least displacement, in units and to a quarter of itself, that excuses the answer: one below which all that the ray must
/// meet is not what it is said to meet.
fn excuse(shape: &Shape, case: &Case, nearest: Option<Hit>) -> f64 {
    let mut units = 1.0;
    while units < 1e7 {
        let bands = oracle::bands(shape, &case.ray(), case.eps(units));
        let is_right = match bands.sure.first() {
            Some(band) => nearest.is_some_and(|hit| is_in(&hit, band)),
            None => nearest.is_none() || !bands.complete,
        };
        if is_right {
            break;
        }
        units *= 1.25;
    }
    units
}

/// How far a hit of a cap or a ring is from its plane, in units.
fn off_plane(shape: &Shape, case: &Case, hit: &Hit) -> f64 {
    let (ray, t) = (case.ray(), f64::from(hit.t));
    let z = ray.origin[2] + t * ray.direction[2];
    let knot = shape.knots[hit.segment + usize::from(hit.u > 0.5)];
    (z - knot).abs() / case.unit_at(t)
}

/// How far a hit's place is from the surface, in units.
fn off(shape: &Shape, case: &Case, hit: &Hit) -> f64 {
    let ray = case.ray();
    let length = ray.direction.iter().map(|c| c * c).sum::<f64>().sqrt();
    let t = f64::from(hit.t);
    let unit = case.unit_at(t);
    let along = oracle::crossings(shape, &ray).into_iter().map(|at| (t - at.t).abs() * length * at.cos);
    let along = along.fold(f64::INFINITY, f64::min) / unit;
    // Beside an edge another point of the surface may be nearer.
    if along <= PROMISE { along } else { along.min(distance(shape, &ray, t, 64.0 * unit) / unit) }
}

/// The distance of the point at t from the surface, if that is below `within`: over the heights about it, to the nearest point
/// at each.
fn distance(shape: &Shape, ray: &oracle::Ray, t: f64, within: f64) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|i| ray.origin[i] + t * ray.direction[i]);
    let rho = (shape.k * x * x + y * y).sqrt();
    // From the axis of a sheet the way to a radius is along y.
    let to_level = if rho > 0.0 { rho / (shape.k * x).hypot(y) } else { 1.0 };
    let at = |up: f64| {
        let up = (z + up).clamp(shape.base(), shape.top()) - z;
        let (segment, u) = shape.locate(z + up);
        let r = value(shape.squared_radius(segment), u).max(0.0).sqrt();
        ((rho - r) * to_level).hypot(up)
    };
    // As close together as they are near, since beside a pole the radius is a root of the height; then about the best of them.
    let ups = (0..=240).map(|i| within * (-f64::from(i) / 4.0).exp2());
    let ups = ups.flat_map(|up| [up, -up]);
    // A segment may be lower than two of these are apart.
    let of_segments = shape
        .knots
        .windows(2)
        .flat_map(|ends| (0..=32).map(|i| ends[0] + (ends[1] - ends[0]) * f64::from(i) / 32.0 - z));
    let best = ups.chain(of_segments).min_by(|&one, &other| at(one).total_cmp(&at(other))).unwrap_or(0.0);
    let (mut low, mut high) = (0.8 * best, 1.25 * best);
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if at(a) < at(b) { high = b } else { low = a }
    }
    at(0.0).min(at(best)).min(at(low)).min(to_ring(shape, z, rho, to_level))
}

/// The distance from the nearest ring, at a height and a distance from the axis: of a knot that is no step, from its circle.
fn to_ring(shape: &Shape, z: f64, rho: f64, to_level: f64) -> f64 {
    let inner_knots = 1..shape.segments();
    let away = inner_knots.map(|knot| {
        let [below, above] = shape.radii(knot).map(f64::sqrt);
        let held = rho.clamp(below.min(above), below.max(above));
        ((rho - held) * to_level).hypot(z - shape.knots[knot])
    });
    away.fold(f64::INFINITY, f64::min)
}

/// The worst of one kind: decisions, places, each with its case.
#[derive(Default)]
struct Worst {
    decision: (f64, String),
    place: (f64, String),
}

impl Worst {
    fn judge(&mut self, shape: &Shape, case: &Case, hit: Option<Hit>) {
        let tell = || format!("{hit:?} of {:?} by\n{case}", oracle::crossings(shape, &case.ray()));
        let units = excuse(shape, case, hit);
        if units > self.decision.0 {
            self.decision = (units, tell());
        }
        let Some(hit) = hit.filter(|_| units <= PROMISE) else { return };
        let units =
            if hit.part == Part::Wall { off(shape, case, &hit) } else { off_plane(shape, case, &hit) };
        if units > self.place.0 && units.is_finite() {
            self.place = (units, tell());
        }
    }
}

#[test]
fn hits_and_places_are_as_promised() {
    let count: u64 = env::var("PROMISE_OUTLINES").map_or(30, |count| count.parse().expect("a number"));
    for kind in Kind::ALL {
        let [mut asked, mut walked] = [Worst::default(), Worst::default()];
        let mut rays = 0;
        for number in 0..count {
            let outline = kind.outline(SEED, number);
            let (shape, lathe) = (&outline.shape(), &lathe(&outline));
            for case in Family::ALL.into_iter().flat_map(|family| cases(&outline, family, SEED + number, 10))
            {
                let ray = Ray::new(case.cast.origin, case.cast.direction).expect("a finite ray");
                asked.judge(shape, &case, lathe.nearest(&ray, case.cast.t_min));
                walked.judge(shape, &case, lathe.nearest_by::<Split<Native>>(&ray, case.cast.t_min));
                rays += 1;
            }
        }
        for (how, worst) in [("as asked", asked), ("traversed", walked)] {
            println!(
                "{kind:?}, {rays} rays {how}: decisions {:.1}, places {:.1} units",
                worst.decision.0, worst.place.0
            );
            for (units, case) in [worst.decision, worst.place] {
                if env::var("PROMISE_SHOW").is_ok() && units > PROMISE {
                    println!("{units} {case}");
                    continue;
                }
                assert!(units <= PROMISE, "{kind:?} {how}: {units} units, {case}");
            }
        }
    }
}

fn f(bits: u32) -> f32 {
    f32::from_bits(bits)
}

/// The answer at an open outline, and what it is off by: `[decision, place]`.
fn units(
    knots: &[f32],
    ordinates: &[f32],
    k: f32,
    origin: [u32; 3],
    direction: [u32; 3],
) -> (Option<Hit>, [f64; 2]) {
    let outline = Outline {
        name: "found",
        knots: knots.to_vec(),
        ordinates: ordinates.to_vec(),
        k,
        base_closed: false,
        top_closed: false,
    };
    let cast = Cast { origin: origin.map(f), direction: direction.map(f), t_min: 0.0 };
    let case = Case { outline: &outline, family: Family::Random, seed: 0, index: 0, cast };
    let shape = outline.shape();
    let ray = Ray::new(cast.origin, cast.direction).expect("a finite ray");
    let hit = lathe(&outline).nearest(&ray, 0.0);
    (hit, [excuse(&shape, &case, hit), hit.map_or(0.0, |hit| off(&shape, &case, &hit))])
}

/// A ray that cuts the corner of a shoulder a thousandth of its height: it enters below the shoulder's upper edge.
#[test]
fn a_shoulder_is_not_missed() {
    let (hit, [decision, place]) = units(
        &[0, 0x3f800000, 0x3f8020c5, 0x40001062].map(f),
        &[
            0x3e1200b5, 0x3e1200b5, 0x3e1200b5, 0x3e1200b5, 0x3e67e99d, 0x3eb1de18, 0x3f015e1c, 0x3f015e1c,
            0x3f015e1c, 0x3f015e1c,
        ]
        .map(f),
        1.0,
        [0x3e7103e2, 0xbe9cda94, 0x3f0f73db],
        [0x3f0e1e20, 0x3f206a30, 0x3f0c052d],
    );
    assert!(hit.is_some_and(|hit| hit.enters), "{hit:?}");
    assert!(decision <= PROMISE && place <= PROMISE, "{hit:?}: {decision} and {place} units");
}

/// A step by a hair at which the slope rises by much: what the fast path says of the ray includes that rise.
#[test]
fn a_slope_that_rises_at_a_step_is_not_missed() {
    let knots = [-0.32995105, -0.32995105, -0.15492278, -0.15492278, 0.14727473];
    let ordinates = [
        0.392923,
        0.49814606,
        0.8768854,
        0.8162081,
        0.51225674,
        0.5122516,
        0.8109802,
        0.4352292,
        0.0031784645,
    ];
    let (origin, direction) =
        ([-3.0544715, 0.47903198, -0.82062316_f32], [0.9409121, -0.074034564, 0.3304592_f32]);
    let [origin, direction] = [origin, direction].map(|v| v.map(f32::to_bits));
    let (hit, [decision, place]) = units(&knots, &ordinates, 0.7389029, origin, direction);
    assert!(hit.is_some_and(|hit| hit.enters), "{hit:?}");
    assert!(decision <= PROMISE && place <= PROMISE, "{hit:?}: {decision} and {place} units");
}

/// Roots far along a chord from where its cubic is formed: within one unit, t to its last bit but one.
#[test]
fn far_roots_are_near() {
    let (spheroid, [decision, place]) = units(
        &[0.0, f(0x40657e91)],
        &[0.0, f(0x3faaaaab), f(0x3faaaaab), 0.0],
        1.0,
        [0xbe31a83f, 0x3ea8805d, 0x3f0840e5],
        [0x3e1e3f1d, 0xbe42df05, 0x3f783037],
    );
    assert!(decision <= 1.0 && place <= 1.0, "{spheroid:?}: {decision} and {place} units");
    let (sheet, [decision, place]) = units(
        &[0.0, f(0x3f041081)],
        &[0x3c7832f3, 0x3f3d2881, 0x3ef69649, 0x3f2c5bd3].map(f),
        0.0,
        [0xbd78b3ce, 0x3d245f95, 0x396e1b67],
        [0xbeb14519, 0xbf5382d8, 0x3ee388a1],
    );
    assert!(decision <= 1.0 && place <= 1.0, "{sheet:?}: {decision} and {place} units");
}

/// Beside the tips of needles, capped and cut off: what is met farther from the rim than two units is named by its part.
#[test]
fn parts_beside_a_tip() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let (mut walls, mut caps) = (0, 0);
    for number in 0..400 {
        let upright =
            Outline { base_closed: true, top_closed: true, k: 1.0, ..Kind::Needle.outline(SEED, number) };
        // Every other one with its tip down.
        let outline = if number % 2 == 0 {
            upright
        } else {
            let ordinates = upright.ordinates.iter().rev().copied().collect();
            Outline { ordinates, ..upright }
        };
        let (shape, lathe) = (outline.shape(), lathe(&outline));
        let tip = if number % 2 == 0 { shape.top() } else { shape.base() };
        let rim = shape.segments[0][if number % 2 == 0 { 3 } else { 0 }].sqrt();
        for index in 0..100 {
            let mut near = || rng.random_range(-1.0_f64..1.0);
            // At the rim, from about it or from far within, at any slope.
            let unit = shape.size() * ROUNDOFF;
            let away = unit * 1000_f64.powf(near() + 1.0);
            let turn = 3.0 * near();
            let target =
                [rim * turn.cos() + away * near(), rim * turn.sin() + away * near(), tip + away * near()];
            let steep = shape.size().powf(near());
            let direction = [near(), near(), steep * near()];
            let way = [1.0, shape.size()][index % 2] * near().abs();
            let origin: [f32; 3] = std::array::from_fn(|i| (target[i] - way * direction[i]) as f32);
            let cast = Cast { origin, direction: direction.map(|d| d as f32), t_min: 0.0 };
            let case =
                Case { outline: &outline, family: Family::Rims, seed: SEED, index: index as u64, cast };
            let bands = oracle::bands(&shape, &case.ray(), case.eps(2.0));
            let Some(band) = bands.sure.first() else { continue };
            let Ok(ray) = Ray::new(cast.origin, cast.direction) else { continue };
            let hit = lathe.nearest(&ray, 0.0);
            assert!(hit.is_some_and(|hit| is_in(&hit, band)), "{hit:?} is not {band:?} by\n{case}");
            match band.part {
                oracle::Part::Wall => walls += 1,
                _ => caps += 1,
            }
        }
    }
    assert!(walls > 500 && caps > 500, "{walls} walls, {caps} caps");
}

/// Rays that leave needles by the wall of a short tip, a quarter of a unit from its rim: they end at the wall, and not at the cap
/// whose plane they reach almost at the same place.
#[test]
fn the_wall_of_a_tip_is_no_cap() {
    let needles = [
        (
            [0.0, 1063.2888, 1063.3036],
            [1.0, 1.0, 1.0, 1.0, 0.34277964, 0.009513234, 0.0002007737],
            [0x3deab55f, 0xbee7d8b6, 0x446730f0],
            [0xbe4df11f, 0x3f53297d, 0x437323a5],
        ),
        (
            [0.0, 32.662964, 32.67544],
            [1.0, 1.0, 1.0, 1.0, 0.40721262, 0.077972874, 0.012280828],
            [0xbe7055cd, 0x3e7d903a, 0x41ea5e11],
            [0x3e561c9f, 0xbee98241, 0x40af2036],
        ),
        // Its tip down.
        (
            [0.0, 0.020664215, 33.378613],
            [9.217412e-7, 0.0006403563, 0.33397338, 1.0, 1.0, 1.0, 1.0],
            [0x3e9740e8, 0xbc1226b0, 0x3f60192d],
            [0xbf2ff463, 0x3cbdd36f, 0xc00258bb],
        ),
    ];
    for (knots, ordinates, origin, direction) in needles {
        let outline = Outline {
            name: "needle",
            knots: knots.to_vec(),
            ordinates: ordinates.to_vec(),
            k: 1.0,
            base_closed: true,
            top_closed: true,
        };
        let cast = Cast { origin: origin.map(f), direction: direction.map(f), t_min: 0.0 };
        let case = Case { outline: &outline, family: Family::Rims, seed: 0, index: 0, cast };
        let bands = oracle::bands(&outline.shape(), &case.ray(), case.eps(0.25));
        let ray = Ray::new(cast.origin, cast.direction).expect("a finite ray");
        let hit = lathe(&outline).nearest(&ray, 0.0);
        let first = bands.sure.first().expect("a crossing, whoever looks");
        assert_eq!(first.part, oracle::Part::Wall, "{case}");
        assert!(hit.is_some_and(|hit| is_in(&hit, first)), "{hit:?} is not {first:?} by\n{case}");
    }
}
