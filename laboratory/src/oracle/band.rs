//! How much the surface may be off before the list of crossings changes.
//!
//! Call a point *in* if every point within `eps` of it lies in the solid, *out* if none does. Moving a point by `eps` moves
//! g by no more than `eps·(2·ρ + |df/dz|) + eps²`, ρ² = k·x² + y² and the slope the largest within `eps` in height;
//! so g beyond that bound decides, and the bound exceeds `eps·|∇g|` by no more than √2 where f is nearly straight over `eps`.
//! Within `eps` of the plane of a step or an end a point is on a side if it is so for the squared radii on both sides of the plane.
//! What is neither in nor out is a *band*. Beyond an open end, or the hole of a ring, what was in stays so.
//!
//! Anyone who displaces the ray, its start, the wall or the ends by less than `eps` in all must see the same in and out.
//! A band between out and in is therefore crossed, in all, once, and a hit reported there is right; a band between
//! two outs or two ins (a near tangency), one that wall and plane share (a rim), and one that the start lies in prove nothing.

use super::bernstein::{self, Cubic, lerp};
use super::crossing::{Part, crossings};
use super::line::{Line, Ray};
use super::shape::Shape;
use crate::{PROMISE, ROUNDOFF};
use std::iter;

/// A stretch of the ray that holds a crossing, whoever looks.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    pub from: f64,
    pub to: f64,
    pub enters: bool,
    pub part: Part,
}

impl Band {
    /// Whether a hit at t is in the band, but for the rounding of t itself, which grows with it.
    pub fn holds(&self, t: f32) -> bool {
        let t = f64::from(t);
        let slack = PROMISE * ROUNDOFF * t.abs();
        (self.from - slack..=self.to + slack).contains(&t)
    }
}

/// The bands up to the first doubtful one.
#[derive(Clone, Debug)]
pub struct Bands {
    pub sure: Vec<Band>,
    /// No doubtful one follows: these are all. Empty and complete is a sure miss.
    pub complete: bool,
}

/// Whether no displacement below `eps` changes the list of crossings.
pub fn robust(shape: &Shape, ray: &Ray, eps: f64) -> bool {
    bands(shape, ray, eps).complete
}

/// Whether the list of [`crossings`] is beyond the oracle's own rounding: robust at 1e-12 of the size, one crossing a band.
pub fn certain(shape: &Shape, ray: &Ray) -> bool {
    let bands = bands(shape, ray, 1e-12 * shape.size());
    let list = crossings(shape, ray);
    let agree = |(band, at): (&Band, &super::Crossing)| {
        (band.from..=band.to).contains(&at.t) && band.enters == at.enters && band.part == at.part
    };
    bands.complete && bands.sure.len() == list.len() && bands.sure.iter().zip(&list).all(agree)
}

/// The bands of `t > t_min` at this `eps` in object units, in order.
pub fn bands(shape: &Shape, ray: &Ray, eps: f64) -> Bands {
    let line = Line::new(shape, ray);
    let mut walk = Walk { shape, line: &line, eps, steps: steps(shape), runs: Vec::new() };
    let start = ray.t_min - line.t0;
    walk.push(Run::sure(Side::Out, start.min(0.0)));
    let reach = line.within(shape.widest() + eps).and_then(|span| walk.reach(span));
    if let Some(Reach { span: [from, to], before, behind }) = reach.filter(|reach| reach.span[1] > start) {
        walk.runs.clear();
        if from > start {
            walk.push(Run { side: before, ..Run::sure(Side::Out, from) });
        }
        walk.all(from.max(start), to);
        // A line along the sheet goes on for ever as it is.
        if to.is_finite() {
            walk.push(Run { side: behind, ..Run::sure(Side::Out, to) });
        }
    }
    walk.judge()
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Side {
    In,
    Out,
    Either,
}

/// A stretch of one side; for `Either`, what may be crossed there.
#[derive(Clone, Copy, Debug)]
struct Run {
    side: Side,
    wall: bool,
    /// One bit for each knot's plane.
    planes: u64,
    s: [f64; 2],
}

impl Run {
    fn sure(side: Side, s: f64) -> Self {
        Run { side, wall: false, planes: 0, s: [s, s] }
    }
}

/// Where a line is between the end planes, each moved out by eps, and within the cylinder; and on which side it is beyond.
struct Reach {
    span: [f64; 2],
    before: Side,
    behind: Side,
}

struct Walk<'a> {
    shape: &'a Shape,
    line: &'a Line,
    eps: f64,
    steps: Vec<usize>,
    runs: Vec<Run>,
}

/// The knots whose plane is a step's or an end's. A pole is none: the wall closes by itself.
fn steps(shape: &Shape) -> Vec<usize> {
    let last = shape.segments();
    let is_step = |&knot: &usize| {
        let [below, above] = shape.radii(knot);
        below != above || (knot == 0 || knot == last) && below > 0.0
    };
    (0..=last).filter(is_step).collect()
}

impl Walk<'_> {
    fn push(&mut self, run: Run) {
        match self.runs.last_mut() {
            Some(last) if last.side == run.side => {
                last.s[1] = run.s[1];
                last.wall |= run.wall;
                last.planes |= run.planes;
            }
            _ => self.runs.push(run),
        }
    }

    fn reach(&self, [from, to]: [f64; 2]) -> Option<Reach> {
        let (low, high) = (self.shape.base() - self.eps, self.shape.top() + self.eps);
        let all = Reach { span: [from, to], before: Side::Out, behind: Side::Out };
        if self.line.horizontal() {
            return (low..=high).contains(&self.line.near[2]).then_some(all);
        }
        let ((a, below), (b, above)) =
            ((self.line.at_height(low), self.shape.below), (self.line.at_height(high), self.shape.above));
        let ((first, entry), (last, exit)) =
            if a < b { ((a, below), (b, above)) } else { ((b, above), (a, below)) };
        let before = if first > from { self.beyond(first, entry) } else { Side::Out };
        let behind = if last < to { self.beyond(last, exit) } else { Side::Out };
        let span = [from.max(first), to.min(last)];
        (span[0] < span[1]).then_some(Reach { span, before, behind })
    }

    /// The side of a point beyond an end that goes on with that squared radius.
    fn beyond(&self, s: f64, square: f64) -> Side {
        let at = self.line.squared_distance(s);
        let tolerance = self.eps * (2.0 * at.sqrt() + self.eps);
        side([square - at; 2], if square == 0.0 { 0.0 } else { tolerance })
    }

    /// Every height at which g, or what it means, changes its formula.
    fn planes(&self) -> Vec<f64> {
        let steps = self.steps.iter().map(|&knot| self.shape.knots[knot]);
        let mut planes: Vec<f64> = steps.flat_map(|z| [z - self.eps, z + self.eps]).collect();
        planes.extend(&self.shape.knots);
        planes
    }

    fn all(&mut self, from: f64, to: f64) {
        if self.line.horizontal() {
            // Along the sheet all places are alike.
            let [from, to] = if to.is_finite() { [from, to] } else { [0.0, 0.0] };
            return self.piece(from, to, 0);
        }
        let mut cuts: Vec<f64> = self.planes().iter().map(|&z| self.line.at_height(z)).collect();
        cuts.retain(|&s| from < s && s < to);
        cuts.extend([from, to]);
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2).filter(|pair| pair[0] < pair[1]) {
            self.piece(pair[0], pair[1], 0);
        }
    }

    /// How much g may change within eps of the points between two parameters.
    fn tolerance(&self, s0: f64, s1: f64) -> f64 {
        let (z0, z1) = (self.line.point(s0)[2], self.line.point(s1)[2]);
        let slope = self.shape.steepest(z0.min(z1) - self.eps, z0.max(z1) + self.eps);
        // k·x² + y² is convex along the line: largest at an end.
        let rho = self.line.squared_distance(s0).max(self.line.squared_distance(s1)).sqrt();
        self.eps * (2.0 * rho + slope + self.eps)
    }

    fn ordinates(&self, s0: f64, s1: f64) -> Cubic {
        let middle = self.line.point(lerp(s0, s1, 0.5))[2];
        let segment = self.shape.segment_at(middle);
        let (z, h) = (self.shape.knots[segment], self.shape.knots[segment + 1] - self.shape.knots[segment]);
        bernstein::through(std::array::from_fn(|i| {
            let s = lerp(s0, s1, i as f64 / 3.0);
            let u = ((self.line.point(s)[2] - z) / h).clamp(0.0, 1.0);
            bernstein::value(self.shape.squared_radius(segment), u) - self.line.squared_distance(s)
        }))
    }

    /// k·x² + y² below a squared radius, as ordinates.
    fn below(&self, square: f64, s0: f64, s1: f64) -> Cubic {
        bernstein::through(std::array::from_fn(|i| {
            square - self.line.squared_distance(lerp(s0, s1, i as f64 / 3.0))
        }))
    }

    fn piece(&mut self, s0: f64, s1: f64, depth: u32) {
        let range =
            |g: Cubic| g.iter().fold([f64::MAX, f64::MIN], |[low, high], &g| [low.min(g), high.max(g)]);
        let tolerance = self.tolerance(s0, s1);
        let middle = lerp(s0, s1, 0.5);
        let z = self.line.point(middle)[2];
        let wall = range(self.ordinates(s0, s1));
        let wall = (wall, side(wall, tolerance));
        // The planes that are near, and those whose sides differ.
        let (mut near, mut planes, mut rings) = (0, 0, Vec::new());
        let is_near = |knot: &usize| (z - self.shape.knots[*knot]).abs() <= self.eps;
        for knot in self.steps.iter().copied().filter(is_near) {
            let ring = self.shape.radii(knot).map(|square| range(self.below(square, s0, s1)));
            let sides = ring.map(|range| side(range, tolerance));
            // Beyond a cap is nothing, beside the axis, too.
            let sides = match (knot, self.shape.segments() - knot, sides) {
                (0, _, [_, wall]) if self.shape.below == 0.0 => [Side::Out, wall],
                (_, 0, [wall, _]) if self.shape.above == 0.0 => [wall, Side::Out],
                _ => sides,
            };
            near |= 1 << knot;
            if sides[0] != sides[1] {
                planes |= 1 << knot;
            }
            rings.extend(ring.into_iter().zip(sides));
        }
        let run = Run { side: Side::Either, wall: false, planes, s: [s0, s1] };
        let mut all = iter::once(&wall).chain(&rings);
        if all.clone().all(|(_, side)| *side != Side::Either) {
            let first = wall.1;
            let is_one = all.all(|(_, side)| *side == first);
            return self.push(if is_one { Run { side: first, planes: 0, ..run } } else { run });
        }
        // To call a stretch a band is always sound; this is how finely it is worth deciding.
        let about = self.tolerance(middle, middle);
        let is_fine = |&[low, high]: &[f64; 2]| {
            low.abs().max(high.abs()) <= about || (high - low <= about / 4.0 && tolerance <= 1.5 * about)
        };
        let mut unsure = all.filter(|(_, side)| *side == Side::Either);
        if unsure.any(|(range, _)| is_fine(range)) || depth == 40 {
            return self.push(Run { wall: true, planes: near, ..run });
        }
        self.piece(s0, middle, depth + 1);
        self.piece(middle, s1, depth + 1);
    }

    fn judge(self) -> Bands {
        let mut sure = Vec::new();
        let mut complete = self.runs.first().is_some_and(|run| run.side != Side::Either);
        let mut before = self.runs.first().map(|run| run.side);
        let mut rest = self.runs.get(1..).unwrap_or_default();
        while complete && let [band, after, others @ ..] = rest {
            let single = band.wall as u32 + band.planes.count_ones() == 1;
            complete = band.side == Side::Either
                && single
                && after.side != Side::Either
                && Some(after.side) != before;
            if complete {
                let part = match band.planes.trailing_zeros() as usize {
                    _ if band.wall => Part::Wall,
                    0 => Part::Base,
                    knot if knot == self.shape.segments() => Part::Top,
                    _ => Part::Ring,
                };
                let [from, to] = band.s.map(|s| self.line.t0 + s);
                sure.push(Band { from, to, enters: after.side == Side::In, part });
            }
            (before, rest) = (Some(after.side), others);
        }
        Bands { sure, complete: complete && rest.is_empty() }
    }
}

/// The side of points whose g has that range and may be off by the tolerance.
fn side([low, high]: [f64; 2], tolerance: f64) -> Side {
    if high < -tolerance || high <= 0.0 && tolerance == 0.0 {
        Side::Out
    } else if low > tolerance {
        Side::In
    } else {
        Side::Either
    }
}
