//! The truth about a ray and an outline's wall, for exactly the f32 numbers given, and how far an answer is from it.
//!
//! On a segment, with ζ = z − zᵢ and h its height, `h³·g(t) = Σ fⱼ·h³⁻ʲ·ζʲ − h³·(k·x² + y²)` is a polynomial in t with dyadic coefficients: its signs and
//! roots are certified ([`super::exact`]).
//!
//! The error of "the nearest crossing is at t" is the least displacement that makes it true: of the point there, onto the surface; and of
//! every point before it that is on the wrong side, out of there (or beyond an end, or before the ray's start). In units
//! of the promise ([`crate::unit()`]). Points are sampled densely, so it too is a lower bound.
//!
//! [`Truth::judge_unsure`] first lets the squared radius be off as well, by one bound everywhere, and displaces
//! points after that: near the axis a small error of the squared radius is a large displacement.

use super::exact::{Exact, Polynomial, exact, float, quotient, shortened};
use crate::cases::{Case, Cast, Outline};

pub struct Truth<'a> {
    outline: &'a Outline,
    cast: Cast,
    unit: f64,
    pieces: Vec<Piece>,
    samples: Vec<Sample>,
    /// The t of every crossing, ascending.
    pub crossings: Vec<f64>,
}

struct Piece {
    profile: Rounded,
    knot: Exact,
    g: Polynomial,
    from: Exact,
    to: Exact,
}

impl Piece {
    fn new(outline: &Outline, segment: usize, cast: &Cast, from: Exact, to: Exact) -> Self {
        let profile = Powers::of(outline, segment);
        let g = along(&profile, outline.k, cast);
        Piece { profile: profile.rounded(), knot: profile.knot, g, from, to }
    }
}

/// A segment: f as powers of u, its lower knot and its height.
struct Powers {
    f: [Exact; 4],
    knot: Exact,
    h: Exact,
}

/// The same in f64, for slopes and bends, of which a few digits are enough.
struct Rounded {
    f: [f64; 4],
    h: f64,
}

impl Powers {
    fn of(outline: &Outline, segment: usize) -> Self {
        let [b0, b1, b2, b3] = std::array::from_fn(|j| exact(outline.ordinates[3 * segment + j]));
        let three = exact(3.0);
        let (d1, d2) = (&b1 - &b0, &b2 - &b1);
        let f = [b0.clone(), &three * &d1, &three * (&d2 - &d1), b3 - b0 - &three * &d2];
        let knot = exact(outline.knots[segment]);
        let h = exact(outline.knots[segment + 1]) - &knot;
        Powers { f, knot, h }
    }

    fn rounded(&self) -> Rounded {
        Rounded { f: self.f.each_ref().map(float), h: float(&self.h) }
    }

    /// `h³·f` as a polynomial of ζ.
    fn of_height(&self) -> Polynomial {
        let (f, h) = (&self.f, &self.h);
        let (h2, h3) = (h * h, h * h * h);
        Polynomial(vec![&f[0] * &h3, &f[1] * &h2, &f[2] * h, f[3].clone()])
    }
}

/// A point of the ray: where, the wall from there, and the way to an end or the ray's start.
struct Sample {
    t: f64,
    wall: Wall,
    way: f64,
}

/// The wall from a point: g, the length of its gradient, and half its second derivative.
#[derive(Clone, Copy)]
struct Wall {
    value: f64,
    gradient: f64,
    bend: f64,
}

impl Wall {
    /// How far, about, if g is off by `doubt` at most: it changes by `n·d + κ·d²` at most over a distance d.
    fn distance(&self, doubt: f64) -> f64 {
        let (size, n) = (self.value.abs() - doubt, self.gradient);
        if size > 0.0 { 2.0 * size / (n + (n * n + 4.0 * self.bend * size).sqrt()) } else { 0.0 }
    }
}

/// Samples between two neighbouring turning points.
const SAMPLES: u32 = 8;

impl<'a> Truth<'a> {
    pub fn new(case: &Case<'a>) -> Self {
        Self::of(case.outline, case.cast, case.eps(1.0))
    }

    pub fn of(outline: &'a Outline, cast: Cast, unit: f64) -> Self {
        let mut truth = Self {
            outline,
            cast,
            unit,
            pieces: pieces(outline, &cast),
            samples: Vec::new(),
            crossings: Vec::new(),
        };
        for piece in &truth.pieces {
            let cuts = piece.g.cuts(&piece.from, &piece.to);
            for pair in cuts.windows(2) {
                let within = (1..SAMPLES).map(|i| {
                    let share = exact(f64::from(i) / f64::from(SAMPLES));
                    // Any point will do, and one of few digits costs the least.
                    shortened(&pair[0] + (&pair[1] - &pair[0]) * share, 64)
                });
                let places = [pair[0].clone()].into_iter().chain(within).chain([pair[1].clone()]);
                let samples: Vec<Sample> = places.map(|t| truth.sample(piece, &t)).collect();
                truth.samples.extend(samples);
            }
            let roots = piece.g.roots_between(&cuts);
            truth.crossings.extend(roots.iter().map(float));
        }
        truth.crossings.dedup();
        truth
    }

    /// The error of an answer, in units.
    pub fn judge(&self, answer: Option<f32>) -> f64 {
        self.judge_unsure(answer, 0.0)
    }

    /// The same if the squared radius may be off by `doubt`.
    pub fn judge_unsure(&self, answer: Option<f32>, doubt: f64) -> f64 {
        let (residual, end) = match answer {
            Some(t) if t > self.cast.t_min && t.is_finite() => (self.residual(t, doubt), f64::from(t)),
            Some(_) => return f64::INFINITY,
            None => (0.0, f64::INFINITY),
        };
        let (mut inside, mut outside) = (0f64, 0f64);
        for sample in self.samples.iter().filter(|sample| sample.t < end) {
            let depth = sample.wall.distance(doubt).min(sample.way);
            if sample.wall.value > 0.0 {
                inside = inside.max(depth);
            } else {
                outside = outside.max(depth);
            }
        }
        residual.max(inside.min(outside)) / self.unit
    }

    /// From the first crossing, along the ray, in units; none if there is none, or no answer.
    pub fn distance(&self, answer: Option<f32>) -> Option<f64> {
        let length = self.cast.direction.map(f64::from).iter().map(|d| d * d).sum::<f64>().sqrt();
        let (t, first) = answer.zip(self.crossings.first())?;
        Some((f64::from(t) - first).abs() * length / self.unit)
    }

    /// From the point at t to the surface.
    fn residual(&self, t: f32, doubt: f64) -> f64 {
        let at = exact(t);
        let [x, y, z] = point(&self.cast, &at);
        let knots = &self.outline.knots;
        let (bottom, top) = (exact(knots[0]), exact(knots[knots.len() - 1]));
        let beyond = float(&(&bottom - &z)).max(float(&(&z - &top))).max(0.0);
        let held = z.clamp(bottom, top);
        let above = knots.partition_point(|&knot| exact(knot) <= held);
        let segment = above.clamp(1, knots.len() - 1) - 1;
        let profile = Powers::of(self.outline, segment);
        let (h, zeta) = (&profile.h, &held - &profile.knot);
        let value = profile.of_height().at(&zeta) - h * h * h * (exact(self.outline.k) * &x * &x + &y * &y);
        let value = float(&value) / float(h).powi(3);
        let wall = self.wall(&profile.rounded(), [float(&x), float(&y)], float(&zeta), value);
        wall.distance(doubt).max(beyond)
    }

    fn sample(&self, piece: &Piece, t: &Exact) -> Sample {
        let knots = &self.outline.knots;
        let [x, y, z] = point(&self.cast, t);
        let value = float(&piece.g.at(t)) / piece.profile.h.powi(3);
        let zeta = float(&(&z - &piece.knot));
        let wall = self.wall(&piece.profile, [float(&x), float(&y)], zeta, value);
        let [bottom, top] = [knots[0], knots[knots.len() - 1]].map(|knot| float(&(&z - exact(knot))).abs());
        let length = self.cast.direction.map(f64::from).iter().map(|d| d * d).sum::<f64>().sqrt();
        let to_start = float(&(t - exact(self.cast.t_min))) * length;
        Sample { t: float(t), wall, way: bottom.min(top).min(to_start).max(0.0) }
    }

    fn wall(&self, profile: &Rounded, [x, y]: [f64; 2], zeta: f64, value: f64) -> Wall {
        let Rounded { f: [_, f1, f2, f3], h } = *profile;
        let (u, k) = ((zeta / h).clamp(0.0, 1.0), f64::from(self.outline.k));
        let slope = ((3.0 * f3 * u + 2.0 * f2) * u + f1) / h;
        let bend = ((3.0 * f3 * u + f2) / (h * h)).abs().max(1.0);
        Wall { value, gradient: (2.0 * k * x).hypot(2.0 * y).hypot(slope), bend }
    }
}

fn point(cast: &Cast, t: &Exact) -> [Exact; 3] {
    std::array::from_fn(|i| exact(cast.origin[i]) + exact(cast.direction[i]) * t)
}

/// The ray's stretches in the slabs of the segments, in order.
fn pieces(outline: &Outline, cast: &Cast) -> Vec<Piece> {
    let knots = &outline.knots;
    let start = exact(cast.t_min);
    let [.., z] = cast.origin;
    let [.., c] = cast.direction;
    let last = knots.len() - 2;
    if c == 0.0 {
        let above = knots.partition_point(|&knot| knot <= z);
        let segment = above.clamp(1, knots.len() - 1) - 1;
        let inside = knots[0] <= z && z <= knots[last + 1];
        let end = far_end(outline, cast).filter(|end| inside && *end > f64::from(cast.t_min));
        return Vec::from_iter(end.map(|end| Piece::new(outline, segment, cast, start, exact(end))));
    }
    let plane = |knot: f32| quotient(&(exact(knot) - exact(z)), &exact(c));
    let piece = |segment: usize| {
        let mut ends = [plane(knots[segment]), plane(knots[segment + 1])];
        ends.sort();
        let [from, to] = ends;
        (to > start).then(|| Piece::new(outline, segment, cast, from.max(start.clone()), to))
    };
    if c > 0.0 {
        (0..=last).filter_map(piece).collect()
    } else {
        (0..=last).rev().filter_map(piece).collect()
    }
}

/// `h³·g` as a polynomial of t.
fn along(profile: &Powers, k: f32, cast: &Cast) -> Polynomial {
    let [x, y, z] = cast.origin.map(exact);
    let [a, b, c] = cast.direction.map(exact);
    let Polynomial(e) = profile.of_height();
    let (d, h) = (z - &profile.knot, &profile.h);
    let (two, three, k, h3) = (exact(2.0), exact(3.0), exact(k), h * h * h);
    let [e0, e1, e2, e3] = [&e[0], &e[1], &e[2], &e[3]];
    Polynomial(vec![
        e0 + e1 * &d + e2 * &d * &d + e3 * &d * &d * &d - &h3 * (&k * &x * &x + &y * &y),
        &c * (e1 + &two * e2 * &d + &three * e3 * &d * &d) - &two * &h3 * (&k * &a * &x + &b * &y),
        &c * &c * (e2 + &three * e3 * &d) - &h3 * (&k * &a * &a + &b * &b),
        &c * &c * &c * e3,
    ])
}

/// Where a ray has left a cylinder of twice the largest radius for good, if it ever does.
fn far_end(outline: &Outline, cast: &Cast) -> Option<f64> {
    let [x, y, _] = cast.origin.map(f64::from);
    let [a, b, _] = cast.direction.map(f64::from);
    let k = f64::from(outline.k);
    let square = 4.0 * outline.ordinates.iter().copied().fold(0.0, f32::max);
    let (q, p) = (k * a * a + b * b, k * a * x + b * y);
    let under = p * p - q * (k * x * x + y * y - f64::from(square));
    (q > 0.0 && under > 0.0).then(|| (-p + under.sqrt()) / q)
}
