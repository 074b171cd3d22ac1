//! The proof of how far a section and the segments that stand for it are apart, both ways.
//!
//! Let C(t) be a point of the section, and let d(t) and e(t) be vectors, at most 1 long, that change continuously
//! with t; d points away from the axis, e towards it. Let every point C(t) + β(t)·d(t) be outside of the fitted
//! curve, farther from the axis than it is at that height, and every point C(t) + γ(t)·e(t) inside of it. The numbers β
//! and γ are continuous, not negative, and at most B. Then neither curve is anywhere farther than B from the other
//! one:
//!
//! - The line from C(t) + γ·e straight to C(t) and on to C(t) + β·d crosses the fitted curve, and no point of it is
//!   farther than B from C(t).
//! - These lines, for all t, are the image of a rectangle. Its border winds once around each point of the fitted curve
//!   between the first line and the last one: a way that leaves the point along the fitted curve, which height
//!   parametrizes, crosses neither of the two long sides, and of the short ones only one. So the point is in the
//!   image: it lies on a line, not farther than B from C(t).
//!
//! That is the whole proof, and it needs signs only. d and −e are the section's normals, interpolated linearly
//! between two cuts. At a corner t stands still while they turn from the one normal to the other, on the side where
//! the two leave a gap between them; on the other side, where normals cross, they turn on the way to the corner. The
//! parallel C(t) + B·d(t) is polynomial, or a ratio of polynomials over one denominator, and so is H = F − r² along
//! it, F the fitted squared radius. Its Bernstein coefficients, computed in [`Ball`]s that are rounded outwards, have
//! one sign, or the interval is halved. On the inner side of a sharp bend, where parallels fold, smaller β do.
//!
//! Both curves are continued beyond their ends by parallel rays: upright ones, or, where the end is level or at the
//! axis, rays at 14° to it. At the axis they go on to negative radii. A step at an end belongs to the fitted curve. A
//! point of a ray is farther from whatever lies behind the ray's start than that start is, so that what is proven of
//! the continued curves holds for those without rays.

use crate::{
    ball::Ball,
    bernstein::{lift, product, restrict, scale, sum},
    piece::{Piece, Point, Radius},
    section::{Place, Section},
    segment::Segment,
};

/// An upper bound of the distance between the section and the segments, the larger of both ways, that does not
/// exceed the tolerance; or, if none is proven, the place on the section where the proof fails. The segments
/// stand one on the other; `steps` says whether a step leads from the end of the segments to that of the section,
/// below and above.
pub(crate) fn distance(
    section: &Section,
    segments: &[Segment],
    steps: [bool; 2],
    tolerance: f64,
) -> Result<f64, f64> {
    let proof = Proof::new(section, segments, steps, tolerance);
    let beyond = proof.ends.iter().fold(0.0, |m: f64, end| m.max(end.beyond));
    let room = (tolerance - beyond).next_down() * (1.0 - 8.0 * f64::EPSILON);
    if !(room > 0.0) {
        let at = if proof.ends[0].beyond >= tolerance { 0.0 } else { section.pieces.len() as f64 };
        return Err(at);
    }
    proof.holds(room)?;
    // A smaller bound may hold, too: no smaller one than what is measured.
    let (mut least, mut next) = (room, 1.01 * proof.measured() + proof.rounding());
    for _ in 0..CLOSER {
        if !(next < 0.99 * least) {
            break;
        }
        match proof.holds(next) {
            Ok(()) => least = next,
            Err(_) => next = (next * least).sqrt(),
        }
        if least == next {
            break;
        }
    }
    Ok((least * (1.0 + 8.0 * f64::EPSILON) + beyond).next_up())
}

/// How many smaller bounds are tried.
const CLOSER: usize = 5;

/// What is tried for β, in units of B.
const REACHES: [f64; 6] = [1.0, 0.7, 0.45, 0.25, 0.1, 0.0];

/// How often intervals are halved, for each piece.
const HALVINGS: usize = 200;

/// In how many boxes the curves are looked at beside an end.
const BOXES: i32 = 16;

/// Within what distance of a corner, in units of B, d turns from the normal to the corner's direction.
pub(crate) const NEAR_CORNER: f64 = 3.0;

/// Shorter intervals of t are not halved but where the proof needs it.
const LONG: f64 = 0.1;

/// Normals between which d is interpolated in longer ones: their product is at least as large, 25° between them.
const NEAR: f64 = 0.9;

type Vector = [f64; 2];

/// What is proven of what.
struct Proof<'a> {
    section: &'a Section,
    segments: &'a [Segment],
    /// Below and above.
    ends: [End; 2],
}

/// How both curves go on beyond an end.
struct End {
    /// Where the section ends.
    drawn: Point,
    /// Where the segments end, or the step.
    fitted: Point,
    /// The direction of the ray, upwards.
    ray: Vector,
    /// How far either curve passes its end in the direction of the ray.
    beyond: f64,
}

/// Numbers from the first to the second.
#[derive(Clone, Copy, Debug)]
struct Range(f64, f64);

impl Range {
    fn of(balls: impl IntoIterator<Item = Ball>) -> Self {
        let none = Self(f64::INFINITY, f64::NEG_INFINITY);
        balls.into_iter().fold(none, |range, ball| Self(range.0.min(ball.low()), range.1.max(ball.high())))
    }

    /// The square roots of what is not below zero.
    fn roots(self) -> Self {
        Self(self.0.max(0.0).sqrt().next_down().max(0.0), self.1.max(0.0).sqrt().next_up())
    }
}

/// The two sides of the fitted curve.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Outside,
    Inside,
}

impl Side {
    fn sign(self) -> f64 {
        if self == Self::Outside { 1.0 } else { -1.0 }
    }
}

/// A part of the continued section over which d is interpolated.
#[derive(Clone)]
struct Part {
    line: Line,
    /// Where it begins and ends on its line.
    t: Vector,
    /// The directions there.
    d: [Vector; 2],
}

/// What a part lies on.
#[derive(Clone)]
enum Line {
    /// A piece of the section.
    Piece(usize),
    /// A straight line that continues it at a place.
    Straight([Point; 2], f64),
}

/// A part's polynomials, in balls.
struct Stretch {
    radius: Radii,
    z: Vec<Ball>,
    w: Vec<Ball>,
}

enum Radii {
    Plain(Vec<Ball>),
    Squared(Vec<Ball>),
}

impl Stretch {
    fn new(piece: &Piece, [a, b]: Vector) -> Self {
        let part = |c: &[f64]| restrict(&lift::<Ball>(c), a, b);
        let radius = match &piece.radius {
            Radius::Plain(r) => Radii::Plain(part(r)),
            Radius::Squared(f) => Radii::Squared(part(f)),
        };
        Self { radius, z: part(&piece.z), w: part(&piece.w) }
    }

    fn over_weights(&self, c: &[Ball]) -> Range {
        if self.w.len() == 1 {
            return Range::of(c.iter().copied());
        }
        // What is of a higher degree than the weights is so by a factor that interpolates.
        let w = sum(&self.w, &vec![Ball::exact(0.0); c.len()]);
        Range::of(c.iter().zip(w).map(|(c, w)| c.over(w)))
    }

    fn radii(&self) -> Range {
        match &self.radius {
            Radii::Plain(r) => self.over_weights(r),
            Radii::Squared(f) => Range::of(f.iter().copied()).roots(),
        }
    }

    /// The parallel at d times `by`.
    fn parallel(&self, d: [Vector; 2], by: f64) -> Parallel {
        let along = |axis: usize| scale(&lift::<Ball>(&[d[0][axis], d[1][axis]]), Ball::exact(by));
        let (dr, dz) = (along(0), along(1));
        let z = sum(&self.z, &product(&self.w, &dz));
        let (radius, square) = match &self.radius {
            Radii::Plain(r) => {
                let radius = sum(r, &product(&self.w, &dr));
                let square = product(&product(&radius, &radius), &self.w);
                (radius, square)
            }
            Radii::Squared(f) => {
                let Range(low, high) = Range::of(f.iter().copied()).roots();
                let root = Ball::between(low, high);
                let twice = scale(&dr, root + root);
                (sum(&[root], &dr), sum(f, &sum(&twice, &product(&dr, &dr))))
            }
        };
        let heights = self.over_weights(&z);
        let radii = self.over_weights(&radius);
        Parallel { radius, square, z, heights, radii }
    }
}

/// The points at some distance from a stretch, by its weights w: w·r, w³·r² and w·z.
struct Parallel {
    radius: Vec<Ball>,
    square: Vec<Ball>,
    z: Vec<Ball>,
    heights: Range,
    radii: Range,
}

impl<'a> Proof<'a> {
    fn new(section: &'a Section, segments: &'a [Segment], steps: [bool; 2], tolerance: f64) -> Self {
        let end = |upper: bool| {
            let (tip, segment) = if upper {
                (&section.high, &segments[segments.len() - 1])
            } else {
                (&section.low, &segments[0])
            };
            let (z, f) = if upper { (segment.z[1], segment.b[3]) } else { (segment.z[0], segment.b[0]) };
            let r = if steps[usize::from(upper)] { tip.at.r } else { f.sqrt() };
            let slope = tip.ray(upper);
            let length = slope.hypot(1.0);
            let ray = [slope / length, 1.0 / length];
            End { drawn: tip.at, fitted: Point { r, z }, ray, beyond: 0.0 }
        };
        let mut proof = Self { section, segments, ends: [end(false), end(true)] };
        for upper in [false, true] {
            proof.ends[usize::from(upper)].beyond = proof.beyond(upper, tolerance);
        }
        proof
    }

    /// How far, in the direction of a ray, either curve passes its end, or the end of the other one.
    fn beyond(&self, upper: bool, tolerance: f64) -> f64 {
        let End { drawn, fitted, ray, .. } = self.ends[usize::from(upper)];
        let apart = drawn.distance(fitted) * (1.0 + 4.0 * f64::EPSILON);
        if ray[0] == 0.0 || drawn.r == 0.0 {
            return apart;
        }
        // Within what heights a point of the ray may be near: twice the tolerance.
        let near = 2.0 * tolerance;
        let from = if upper { drawn.z - near } else { drawn.z };
        let within = |at: i32| from + near * f64::from(at) / f64::from(BOXES);
        let along = |Range(least, most): Range, z: Range| {
            let [across, up] = if upper { ray } else { [-ray[0], -ray[1]] };
            let r = if across > 0.0 { most - drawn.r } else { least - drawn.r };
            let z = if upper { z.1 - drawn.z } else { z.0 - drawn.z };
            (across * r + up * z).next_up()
        };
        let mut beyond: f64 = 0.0;
        for z in (0..BOXES).map(|i| Range(within(i), within(i + 1))) {
            for piece in &self.section.pieces {
                let t = |z: f64| match z {
                    z if z <= piece.start().z => 0.0,
                    z if z >= piece.end().z => 1.0,
                    z => piece.at_height(z),
                };
                let [a, b] = [t(z.0), t(z.1)];
                if a < b {
                    let stretch = Stretch::new(piece, [a, b]);
                    beyond = beyond.max(along(stretch.radii(), stretch.over_weights(&stretch.z)));
                }
            }
            for segment in self.at_heights(z) {
                let u = |z: f64| ((z - segment.z[0]) / (segment.z[1] - segment.z[0])).clamp(0.0, 1.0);
                let [a, b] = [u(z.0), u(z.1)];
                if a < b {
                    beyond =
                        beyond.max(along(Range::of(restrict(&segment.b.map(Ball::exact), a, b)).roots(), z));
                }
            }
        }
        beyond + apart
    }

    /// What rounding to f32 may cost.
    fn rounding(&self) -> f64 {
        let z = self.ends.iter().fold(0.0, |z: f64, end| z.max(end.drawn.z.abs()));
        let f = self.segments.iter().flat_map(|segment| segment.b).fold(0.0, f64::max);
        (z + f.sqrt()) / f64::from(1 << 24)
    }

    /// About how far they are apart, by places of the section.
    fn measured(&self) -> f64 {
        let length = self.section.pieces.len() as f64;
        let at = |i: usize| {
            let place = self.section.place(length * i as f64 / MEASURED_AT as f64);
            let segment = self.at_heights(Range(place.z, place.z))[0];
            let (f, slope) = segment.at(place.z);
            let along = (2.0 * place.r).hypot(slope).max(f64::MIN_POSITIVE);
            ((f - place.f).abs() / along).min((f.max(0.0).sqrt() - place.r).abs())
        };
        (1..MEASURED_AT).map(at).fold(0.0, f64::max)
    }

    /// Whether the lines of a length of at most `by` to both sides end on that side; if not, where.
    fn holds(&self, by: f64) -> Result<(), f64> {
        [Side::Outside, Side::Inside]
            .into_iter()
            .try_for_each(|side| self.side(&self.parts(by, side), by, side))
    }

    /// The continued section from below: its pieces, its corners where normals have a gap between them, and its rays.
    fn parts(&self, by: f64, side: Side) -> Vec<Part> {
        let pieces = &self.section.pieces;
        let [low, high] = &self.ends;
        let across = |end: &End| [end.ray[1], -end.ray[0]];
        let on_ray =
            |end: &End, by: f64| Point { r: end.drawn.r + by * end.ray[0], z: end.drawn.z + by * end.ray[1] };
        let joins: Vec<Place> = (0..=pieces.len()).map(|i| self.section.place(i as f64)).collect();
        // Where a piece ends below a join, and where the next one begins.
        let d = |join: &Place| if join.is_gapped(side.sign()) { join.normals } else { [join.normal; 2] };
        let mut parts = vec![Part {
            line: Line::Straight([on_ray(low, -2.0 * by), low.drawn], 0.0),
            t: [0.0, 1.0],
            d: [across(low), joins[0].normal],
        }];
        for (i, ends) in joins.windows(2).enumerate() {
            parts.push(Part { line: Line::Piece(i), t: [0.0, 1.0], d: [d(&ends[0])[1], d(&ends[1])[0]] });
            if ends[1].is_gapped(side.sign()) {
                let corner = Point { r: ends[1].r, z: ends[1].z };
                let line = Line::Straight([corner; 2], (i + 1) as f64);
                parts.push(Part { line, t: [0.0, 1.0], d: ends[1].normals });
            }
        }
        let last = pieces.len();
        parts.push(Part {
            line: Line::Straight([high.drawn, on_ray(high, 2.0 * by)], last as f64),
            t: [0.0, 1.0],
            d: [joins[last].normal, across(high)],
        });
        parts
    }

    fn side(&self, parts: &[Part], by: f64, side: Side) -> Result<(), f64> {
        let mut left: Vec<Part> = parts.iter().rev().cloned().collect();
        let mut before = None;
        let mut halvings = HALVINGS * parts.len();
        while let Some(part) = left.pop() {
            let reach = self.reach(&part, by, side, before);
            if let Some(reach) = reach {
                before = Some(reach);
                continue;
            }
            let middle = 0.5 * (part.t[0] + part.t[1]);
            let d = self.direction(&part, middle, by, side);
            let here = Part { t: [middle; 2], d: [d; 2], ..part.clone() };
            halvings = halvings.saturating_sub(1);
            if halvings == 0
                || !(part.t[0] < middle && middle < part.t[1])
                || self.reach(&here, by, side, None).is_none()
            {
                return Err(self.place(&here));
            }
            left.push(Part { t: [middle, part.t[1]], d: [d, part.d[1]], ..part.clone() });
            left.push(Part { t: [part.t[0], middle], d: [part.d[0], d], ..part });
        }
        Ok(())
    }

    /// The place on the section where a part begins.
    fn place(&self, part: &Part) -> f64 {
        match part.line {
            Line::Piece(i) => i as f64 + part.t[0],
            Line::Straight(_, s) => s,
        }
    }

    /// The direction at a t of a part.
    fn direction(&self, part: &Part, t: f64, by: f64, side: Side) -> Vector {
        if let Line::Piece(i) = part.line {
            let place = self.section.place(i as f64 + t);
            return self.section.direction(&place, side.sign(), NEAR_CORNER * by);
        }
        let [[a, b], [c, d]] = part.d;
        let length = (a + c).hypot(b + d);
        [(a + c) / length, (b + d) / length]
    }

    fn at(&self, part: &Part, t: f64) -> Point {
        match part.line {
            Line::Piece(i) => self.section.pieces[i].at(t),
            Line::Straight([from, to], _) => {
                Point { r: from.r + t * (to.r - from.r), z: from.z + t * (to.z - from.z) }
            }
        }
    }

    fn stretch(&self, part: &Part) -> Stretch {
        match part.line {
            Line::Piece(i) => Stretch::new(&self.section.pieces[i], part.t),
            Line::Straight([from, to], _) => Stretch::new(&Piece::line(from, to), part.t),
        }
    }

    /// The largest β for which all of a part is known to be on the side, and to which one may pass from the β before
    /// it without leaving that side.
    fn reach(&self, part: &Part, by: f64, side: Side, before: Option<f64>) -> Option<f64> {
        let [a, b] = part.d;
        let is_long = part.t[1] - part.t[0] > LONG;
        if is_long && !(a[0] * b[0] + a[1] * b[1] >= NEAR) {
            return None;
        }
        let stretch = self.stretch(part);
        let sign = by * side.sign();
        // Where parallels fold they do so within B.
        let [from, to] = part.t.map(|t| self.at(part, t));
        // Nor do they in a corner's gap, where the line stands still.
        let is_gap = matches!(part.line, Line::Straight([a, b], _) if a == b);
        let some = if is_gap || is_long || from.distance(to) > 0.5 * by { 1 } else { REACHES.len() };
        REACHES[..some].iter().copied().find(|reach| {
            self.is_on(&stretch.parallel(part.d, sign * reach), &stretch.w, side)
                && before
                    .is_none_or(|before| before == *reach || self.passes(part, [before, *reach], sign, side))
        })
    }

    /// Whether the line from one β to another, at the beginning of a part, stays on the side.
    fn passes(&self, part: &Part, reaches: Vector, sign: f64, side: Side) -> bool {
        let [d, _] = part.d;
        let at = self.at(part, part.t[0]);
        let steps = 16;
        let on = |i: i32| {
            let reach = sign * (reaches[0] + (reaches[1] - reaches[0]) * f64::from(i) / f64::from(steps));
            Point { r: at.r + reach * d[0], z: at.z + reach * d[1] }
        };
        (0..steps).all(|i| {
            let line = Stretch::new(&Piece::line(on(i), on(i + 1)), [0.0, 1.0]);
            self.is_on(&line.parallel([[0.0; 2]; 2], 0.0), &line.w, side)
        })
    }

    /// Whether all of a parallel lies on one side of the continued fitted curve.
    fn is_on(&self, parallel: &Parallel, w: &[Ball], side: Side) -> bool {
        let Range(low, high) = parallel.heights;
        let bottom = self.ends[0].fitted.z;
        let top = self.ends[1].fitted.z;
        if !(low < f64::INFINITY && high > f64::NEG_INFINITY) {
            return false;
        }
        let beside_segments = high < bottom || low > top || {
            let is_in_axis = side == Side::Inside && parallel.radii.1 < 0.0;
            let is_off_axis = parallel.radii.0 > 0.0 || side == Side::Inside;
            is_in_axis
                || is_off_axis
                    && self.at_heights(Range(low, high)).iter().all(|segment| {
                        let Range(least, most) = gap(parallel, w, segment);
                        if side == Side::Inside { least > 0.0 } else { most < 0.0 }
                    })
        };
        let beside = |end: &End| {
            let slope = end.ray[0] / end.ray[1];
            // w·(r − the ray's r at that height).
            let rise = sum(&parallel.z, &scale(w, Ball::exact(-end.fitted.z)));
            let ray = sum(&scale(w, Ball::exact(end.fitted.r)), &scale(&rise, Ball::exact(slope)));
            let Range(least, most) = Range::of(sum(&parallel.radius, &scale(&ray, Ball::exact(-1.0))));
            if side == Side::Inside { most < 0.0 } else { least > 0.0 }
        };
        beside_segments && (low > bottom || beside(&self.ends[0])) && (high < top || beside(&self.ends[1]))
    }

    /// The segments that share heights with a range.
    fn at_heights(&self, Range(low, high): Range) -> &[Segment] {
        let last = self.segments.len() - 1;
        let first = self.segments.partition_point(|segment| segment.z[1] < low).min(last);
        let end = self.segments.partition_point(|segment| segment.z[0] <= high).max(first + 1);
        &self.segments[first..end]
    }
}

/// The distance is measured at this many places less one.
const MEASURED_AT: usize = 200;

/// w³·(F − r²), where F is a segment's cubic.
fn gap(parallel: &Parallel, w: &[Ball], segment: &Segment) -> Range {
    let [b0, b1, b2, b3] = segment.b.map(Ball::exact);
    let three = Ball::exact(3.0);
    let (f1, f2) = (three * (b1 - b0), three * (b2 - b1 - b1 + b0));
    let f3 = b3 - b0 - three * (b2 - b1);
    let [z0, z1] = segment.z.map(Ball::exact);
    let height = z1 - z0;
    // w·u, u the segment's parameter.
    let u = sum(&parallel.z, &scale(w, -z0));
    let u: Vec<Ball> = u.into_iter().map(|u| u.over(height)).collect();
    let (u2, w2) = (product(&u, &u), product(w, w));
    let w3 = product(&w2, w);
    let low = sum(&scale(&w3, b0), &scale(&product(&u, &w2), f1));
    let high = sum(&scale(&product(&u2, w), f2), &scale(&product(&u2, &u), f3));
    Range::of(sum(&sum(&low, &high), &scale(&parallel.square, Ball::exact(-1.0))))
}
