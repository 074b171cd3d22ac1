//! The solid, by the numbers that describe it.

use super::bernstein::{self, Cubic};

/// Normals that turn by less than this at a join, in radians, are rounding and no crease.
const CREASE: f64 = 1e-5;

/// `k·x² + y² < f(z)`: n segments between n + 1 knots, each with four control values of the squared radius. Where two neighbours
/// differ at their knot, a flat ring lies between the two radii; at an end, between that of the wall and the one beyond. So an end
/// with nothing beyond has a cap, and one that goes on as wide as it is has no surface.
#[derive(Clone, Debug)]
pub struct Shape {
    pub knots: Vec<f64>,
    pub segments: Vec<Cubic>,
    pub k: f64,
    /// The squared radii beyond the ends.
    pub below: f64,
    pub above: f64,
}

impl Shape {
    /// From knots and ordinates as a profile takes them: a knot that stands twice is a step, and has two ordinates.
    pub fn new(knots: &[f64], ordinates: &[f64], k: f64) -> Self {
        let mut shape = Self {
            knots: vec![knots[0]],
            segments: Vec::new(),
            k,
            below: ordinates[0],
            above: ordinates[ordinates.len() - 1],
        };
        let mut at = 0;
        for pair in knots.windows(2) {
            if pair[0] == pair[1] {
                at += 1;
            } else {
                shape.knots.push(pair[1]);
                shape.segments.push(std::array::from_fn(|j| ordinates[at + j]));
                at += 3;
            }
        }
        assert_eq!(at + 1, ordinates.len(), "{knots:?} {ordinates:?}");
        shape
    }

    pub fn segments(&self) -> usize {
        self.segments.len()
    }

    pub fn squared_radius(&self, segment: usize) -> Cubic {
        self.segments[segment]
    }

    /// The same with both ends open.
    pub fn opened(mut self) -> Self {
        let last = self.segments();
        (self.below, self.above) = (self.radii(0)[1], self.radii(last)[0]);
        self
    }

    /// The same with both ends capped.
    pub fn closed(self) -> Self {
        Self { below: 0.0, above: 0.0, ..self }
    }

    /// The squared radii just below a knot and just above.
    pub fn radii(&self, knot: usize) -> [f64; 2] {
        let below = knot.checked_sub(1).map_or(self.below, |segment| self.segments[segment][3]);
        [below, self.segments.get(knot).map_or(self.above, |segment| segment[0])]
    }

    /// The radii of the wall's circles at a knot, but for those of no radius.
    fn circles(&self, knot: usize) -> impl Iterator<Item = f64> {
        self.radii(knot).into_iter().filter(|&square| square > 0.0).map(f64::sqrt)
    }

    pub fn base(&self) -> f64 {
        self.knots[0]
    }

    pub fn top(&self) -> f64 {
        self.knots[self.segments()]
    }

    pub fn middle(&self) -> f64 {
        (self.base() + self.top()) / 2.0
    }

    /// No radius exceeds this one.
    pub fn widest(&self) -> f64 {
        let ordinates = self.segments.iter().flatten().copied();
        ordinates.chain([self.below, self.above]).fold(0.0, f64::max).sqrt()
    }

    /// Height or largest diameter, whichever is more: the unit for tolerances.
    pub fn size(&self) -> f64 {
        (self.top() - self.base()).max(2.0 * self.widest())
    }

    /// The unit in which a ray from this origin may be off.
    pub fn unit(&self, [x, y, z]: [f64; 3]) -> f64 {
        crate::unit(self.size(), x.hypot(y).hypot(z - self.middle()))
    }

    /// The segment at a height; below the profile it is the first, above the last.
    pub fn segment_at(&self, z: f64) -> usize {
        self.knots.partition_point(|&knot| knot <= z).clamp(1, self.segments()) - 1
    }

    /// Segment and parameter of a height, both clamped to the profile.
    pub fn locate(&self, z: f64) -> (usize, f64) {
        let segment = self.segment_at(z);
        let (low, high) = (self.knots[segment], self.knots[segment + 1]);
        (segment, ((z - low) / (high - low)).clamp(0.0, 1.0))
    }

    /// `df/dz` at a parameter of a segment.
    pub fn slope(&self, segment: usize, u: f64) -> f64 {
        bernstein::slope(self.squared_radius(segment), u) / (self.knots[segment + 1] - self.knots[segment])
    }

    /// Largest `|df/dz|` between two heights; beyond the ends f is constant.
    pub fn steepest(&self, low: f64, high: f64) -> f64 {
        let (first, last) = (self.segment_at(low), self.segment_at(high));
        let within = |segment: usize| {
            let (z, h) = (self.knots[segment], self.knots[segment + 1] - self.knots[segment]);
            let u = |height: f64| ((height - z) / h).clamp(0.0, 1.0);
            bernstein::steepest(self.squared_radius(segment), u(low), u(high)) / h
        };
        (first..=last).map(within).fold(0.0, f64::max)
    }

    pub fn inside(&self, [x, y, z]: [f64; 3]) -> bool {
        let (segment, u) = self.locate(z);
        let f = bernstein::value(self.squared_radius(segment), u);
        (self.base()..=self.top()).contains(&z) && self.k * x * x + y * y < f
    }

    /// Outward unit normal of the wall: along `(2·k·x, 2·y, −df/dz)`. On a conical pole it is vertical for want of better.
    pub fn wall_normal(&self, segment: usize, u: f64, [x, y, _]: [f64; 3]) -> [f64; 3] {
        let n = [2.0 * self.k * x, 2.0 * y, -self.slope(segment, u)];
        let length = n.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length > 0.0 { n.map(|c| c / length) } else { [0.0, 0.0, if u < 0.5 { -1.0 } else { 1.0 }] }
    }

    /// Whether the wall's normal jumps or ends at a knot: a crease, a rim or a conical pole. A rounded pole is smooth.
    pub fn creased(&self, knot: usize) -> bool {
        let [square, other] = self.radii(knot);
        let r = square.max(other).sqrt();
        let below = knot.checked_sub(1).map(|segment| self.slope(segment, 1.0));
        let above = (knot < self.segments()).then(|| self.slope(knot, 0.0));
        match (below, above) {
            (Some(_), Some(_)) if square != other => true,
            (Some(below), Some(above)) => (below.atan2(2.0 * r) - above.atan2(2.0 * r)).abs() > CREASE,
            (Some(slope), None) | (None, Some(slope)) => r > 0.0 || slope == 0.0,
            (None, None) => true,
        }
    }

    /// A lower bound on the distance from a point of the wall to the nearest knot where its normal jumps.
    pub fn to_crease(&self, [x, y, z]: [f64; 3]) -> f64 {
        let r = (self.k * x * x + y * y).sqrt();
        let away = |knot: usize| {
            let radii = self.radii(knot).map(f64::sqrt);
            radii.into_iter().map(move |radius| (r - radius).hypot(z - self.knots[knot]))
        };
        let creased = (0..self.knots.len()).filter(|&knot| self.creased(knot));
        creased.flat_map(away).fold(f64::INFINITY, f64::min)
    }

    /// The distance from a point of the ring at a knot to the nearest of its rims.
    pub fn to_rim(&self, knot: usize, r: f64) -> f64 {
        self.circles(knot).map(|radius| (r - radius).abs()).fold(f64::INFINITY, f64::min)
    }
}
