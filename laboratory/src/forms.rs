//! Whole intersections in f32: how the cubic is formed, with any method to solve it. Walls only; both ends are open.
//!
//! - [`paper`]: the elimination of "An algorithm of finding intersection point for ray tracing to ternary Bézier curve rotating surface"
//!   (Kang and Lu, Journal of Xi'an Jiaotong University, 1995): the ray's parameter is eliminated by the height.
//! - [`sound`]: the ray is cut to each segment's slab and cylinder first, and g is formed along what remains.
//! - [`asked`]: the crate's own; [`shipped`]: its traversal alone, with any solver.

use super::contenders::{Direct, FirstRoot, textbook_roots};
use crate::cases::{Cast, Outline};
use embedded_lathe::math::{Libm, Micromath, Native, Std};
use embedded_lathe::solve::{Cardano, Solver, Split};
use embedded_lathe::{Cubic, Lathe, Profile, Ray, Segment};

/// Enough segments for every outline under test.
pub type Turned = Lathe<[Segment; 16]>;

/// All real roots of a cubic; unused places are NaN.
pub type Roots = fn(&[f32; 4]) -> [f32; 3];

pub fn turned(outline: &Outline) -> Turned {
    let profile = Profile::from_squared_radii(&outline.knots, &outline.ordinates);
    let squashed = profile.and_then(|profile| profile.squash(outline.k));
    Lathe::turn(squashed.unwrap_or_else(|error| panic!("{error}: {outline:?}")))
}

pub fn asked(lathe: &Turned, cast: &Cast) -> Option<f32> {
    let ray = Ray::new(cast.origin, cast.direction).ok()?;
    Some(lathe.nearest(&ray, cast.t_min)?.t)
}

pub fn shipped<S: Solver>(lathe: &Turned, cast: &Cast) -> Option<f32> {
    let ray = Ray::new(cast.origin, cast.direction).ok()?;
    Some(lathe.nearest_by::<S>(&ray, cast.t_min)?.t)
}

/// The paper's equations (5) and, for a horizontal ray, (6), in its own order of operations; A₀'s last term has the factor 2 that is missing in print.
pub fn paper(outline: &Outline, cast: &Cast, roots: Roots) -> Option<f32> {
    let [[x, y, z], [a, b, c]] = [cast.origin, cast.direction];
    let k = outline.k;
    let mut nearest = None;
    let mut see = |t: f32| {
        if t > cast.t_min && nearest.is_none_or(|nearest| t < nearest) {
            nearest = Some(t);
        }
    };
    for (knots, q) in segments(outline) {
        let [k0, k1, k2, k3] = powers(q);
        let (k0z, k1z) = (knots[0], knots[1] - knots[0]);
        if c == 0.0 {
            let u = (z - k0z) / k1z;
            if (0.0..=1.0).contains(&u) {
                let r = k3 * u * u * u + k2 * u * u + k1 * u + k0;
                let (qa, qb) = (k * a * a + b * b, 2.0 * (k * a * x + b * y));
                let root = (qb * qb - 4.0 * qa * (k * x * x + y * y - r)).sqrt();
                for root in [-root, root] {
                    see((-qb + root) / (2.0 * qa));
                }
            }
            continue;
        }
        let q = k * a * a + b * b;
        let p = k * a * x + b * y;
        let below = k0z - z;
        let cubic = [
            k0 - (k * x * x + y * y + q * below * below / (c * c) + 2.0 * p * below / c),
            k1 - 2.0 / c * (q * k1z * below / c + p * k1z),
            k2 - q * k1z * k1z / (c * c),
            k3,
        ];
        let inside = roots(&cubic).into_iter().filter(|u| (0.0..=1.0).contains(u));
        inside.for_each(|u| see((k1z * u + k0z - z) / c));
    }
    nearest
}

/// The first root that the method finds along the chords.
pub fn sound(outline: &Outline, cast: &Cast, first_root: FirstRoot) -> Option<f32> {
    chords(outline, cast).into_iter().find_map(|chord| {
        let w = first_root(&chord.c, 0.0, 1.0)?;
        Some((chord.start + w * chord.length) * chord.unit)
    })
}

/// What of a ray lies in one segment's slab and bounding cylinder, and g along it: `Σ c[j]·wʲ` for w from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Chord {
    pub c: [f32; 4],
    start: f32,
    length: f32,
    unit: f32,
}

/// The chords beyond `t_min` in the ray's order. With P = A + w·V on a chord, `g = f(u(A) + w·du) − ⟨A,A⟩ − 2w⟨A,V⟩ − w²⟨V,V⟩`.
pub fn chords(outline: &Outline, cast: &Cast) -> Vec<Chord> {
    let (root, size) = (outline.k.sqrt(), cast.direction.map(f32::abs).into_iter().fold(0.0, f32::max));
    let [a, b, c] = cast.direction.map(|d| d / size);
    let [x, y, z] = cast.origin;
    let middle = 0.5 * (outline.knots[0] + outline.knots[outline.knots.len() - 1]);
    let z = z - middle;
    let shift = -(x * a + y * b + z * c) / (a * a + b * b + c * c);
    let (x, y, z) = (root * (x + shift * a), y + shift * b, z + shift * c);
    let a = root * a;
    let first = cast.t_min * size - shift;
    let mut chords = Vec::new();
    for (knots, ordinates) in segments(outline) {
        let [low, high] = knots.map(|knot| knot - middle);
        let widest = ordinates.into_iter().fold(0.0, f32::max) * 1.01;
        let q = a * a + b * b;
        let p = x * a + y * b;
        let nearest = -p / q;
        let (nx, ny) = (x + nearest * a, y + nearest * b);
        let half = ((widest - (nx * nx + ny * ny)) / q).sqrt();
        let (near, far) =
            if q > 0.0 { (nearest - half, nearest + half) } else { (f32::NEG_INFINITY, f32::INFINITY) };
        let (from, to) = if c == 0.0 {
            let inside = low <= z && z <= high;
            if inside { (f32::NEG_INFINITY, f32::INFINITY) } else { (0.0, -1.0) }
        } else {
            let [one, other] = [low, high].map(|plane| (plane - z) / c);
            (one.min(other), one.max(other))
        };
        // A cylinder passed by leaves NaN, which this comparison turns away.
        let (start, end) = (from.max(near).max(first), to.min(far));
        if !(half >= 0.0 || q == 0.0) || !(start < end && (end - start).is_finite()) {
            continue;
        }
        let length = end - start;
        let u = |t: f32| ((z + t * c - low) / (high - low)).clamp(0.0, 1.0);
        let (at, du) = (u(start), u(end) - u(start));
        let [f0, f1, f2, f3] = powers(ordinates);
        let (px, py, vx, vy) = (x + start * a, y + start * b, length * a, length * b);
        let c = [
            ((f3 * at + f2) * at + f1) * at + f0 - (px * px + py * py),
            ((3.0 * f3 * at + 2.0 * f2) * at + f1) * du - 2.0 * (px * vx + py * vy),
            (3.0 * f3 * at + f2) * (du * du) - (vx * vx + vy * vy),
            f3 * (du * du * du),
        ];
        let unit = 1.0 / size;
        chords.push(Chord { c, start: start + shift, length, unit });
    }
    if cast.direction[2] < 0.0 {
        chords.reverse();
    }
    chords
}

fn segments(outline: &Outline) -> impl Iterator<Item = ([f32; 2], [f32; 4])> {
    let knots = outline.knots.windows(2).map(|pair| [pair[0], pair[1]]);
    knots.enumerate().map(|(i, knots)| (knots, std::array::from_fn(|j| outline.ordinates[3 * i + j])))
}

/// The paper's matrix M: Bernstein ordinates to powers.
fn powers([q0, q1, q2, q3]: [f32; 4]) -> [f32; 4] {
    [q0, -3.0 * q0 + 3.0 * q1, 3.0 * q0 - 6.0 * q1 + 3.0 * q2, -q0 + 3.0 * q1 - 3.0 * q2 + q3]
}

/// A whole intersection.
pub type Nearest = fn(&Outline, &Cast) -> Option<f32>;

/// What is compared: the form, the solver, both together.
pub const METHODS: &[(&str, &str, Nearest)] = &[
    ("paper", "textbook Cardano", |outline, cast| paper(outline, cast, textbook)),
    ("paper", "split", |outline, cast| paper(outline, cast, split)),
    ("sound form", "textbook Cardano", |outline, cast| sound(outline, cast, textbook_first)),
    ("crate", "as asked", |outline, cast| asked(&turned(outline), cast)),
    ("crate", "split over native", |outline, cast| shipped::<Split<Native>>(&turned(outline), cast)),
    ("crate", "split over std", |outline, cast| shipped::<Split<Std>>(&turned(outline), cast)),
    ("crate", "split over libm", |outline, cast| shipped::<Split<Libm>>(&turned(outline), cast)),
    ("crate", "split over micromath", |outline, cast| shipped::<Split<Micromath>>(&turned(outline), cast)),
    ("crate", "Cardano over native", |outline, cast| shipped::<Cardano<Native>>(&turned(outline), cast)),
    ("crate", "Cardano over std", |outline, cast| shipped::<Cardano<Std>>(&turned(outline), cast)),
    ("crate", "Cardano over libm", |outline, cast| shipped::<Cardano<Libm>>(&turned(outline), cast)),
    ("crate", "Cardano over micromath", |outline, cast| {
        shipped::<Cardano<Micromath>>(&turned(outline), cast)
    }),
];

fn textbook(c: &[f32; 4]) -> [f32; 3] {
    textbook_roots::<Direct<Std>>(c)
}

fn textbook_first(c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    let inside = textbook(c).into_iter().filter(|root| (lo..=hi).contains(root));
    inside.reduce(f32::min)
}

/// The crate's solver on the paper's coefficients.
fn split(c: &[f32; 4]) -> [f32; 3] {
    let mut places = [f32::NAN; 3];
    let found = Cubic::new(*c).roots_by::<Split<Std>>(0.0, 1.0);
    places.iter_mut().zip(found).for_each(|(place, root)| *place = root);
    places
}
