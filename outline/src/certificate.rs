//! The proof of how far a section and the segments that stand for it are apart, both ways.
//!
//! With H(r, z) = F(z) − r², F the segments' squared radius, the fitted curve is where H = 0. Let C(t) be a
//! point of the section, g = H(C(t)), and d a direction. If H grows along d by at least m per unit of length
//! everywhere within |g|/m of C(t), then on the line through C(t) along d there is exactly one point of the
//! fitted curve as near as that. Where d changes continuously with t, so does that point: if it passes from one
//! end of the fitted curve to the other it passes every point of it, and the largest |g|/m bounds the distance
//! from either curve to the other one.
//!
//! So the section is cut into intervals. At each cut d is the gradient of H; between two cuts it is what lies
//! between theirs, along which H grows by no less than the smaller of the two. g over an interval is a ratio of
//! polynomials, whose Bernstein coefficients enclose it; they are computed in [`Ball`]s, rounded outwards. The
//! interval with the largest bound is halved until that is known to 2 %.
//!
//! Three kinds of places have rules of their own:
//!
//! - Where the curve is steep d is level, towards the axis, and the distance that of the radii at one height,
//!   |g|/(r + √F), with no need to look at H anywhere else.
//! - At a tip with a step the fitted curve goes on along the step, at the height of its end, with H of one sign
//!   between the two: a line that meets no zero of H before that height meets the step there. Beside
//!   the tip itself d is upright, so that the last line meets the end of the step.
//! - At any other tip lines along d might miss the end of the fitted curve. What is left of both curves there
//!   lies in a box. In a box of which both curves cross the whole width no point is farther from the other curve
//!   than the box is high; nor farther than it is wide, if they cross the whole height; nor in any case
//!   than its diagonal.

use crate::{
    ball::Ball,
    bernstein::{lift, product, restrict, scale, sum},
    piece::{Piece, Point, Radius},
    section::Section,
    segment::Segment,
};
use std::collections::BinaryHeap;

/// An upper bound of the distance between the section and the segments, one-sided both ways, whichever is
/// larger. It is computed as closely as it takes to be below the tolerance. The segments stand one on the other;
/// `steps` says whether a step leads from the end of the segments to that of the section, below and above.
pub(crate) fn distance(section: &Section, segments: &[Segment], steps: [bool; 2], tolerance: f64) -> f64 {
    let proof = Proof::new(section, segments, steps, tolerance);
    let length = section.pieces.len() as f64;
    let known = (0..=KNOWN_AT).map(|i| proof.cut(length * f64::from(i) / f64::from(KNOWN_AT)).distance);
    let known = known.fold(0.0, f64::max);
    let tight = proof.bound(known);
    // Where the fitted curve is a needle, lines from anywhere near may miss its end: a larger box may do.
    if tight <= tolerance { tight } else { tight.min(proof.bound(0.9 * tolerance)) }
}

/// In so many steps of s the distance is looked at before anything is proven.
const KNOWN_AT: u32 = 100;

/// The intervals that are not tips, the one with the largest bound first.
struct Search<'a> {
    proof: &'a Proof<'a>,
    intervals: BinaryHeap<Interval>,
    /// The largest bound of a single place so far.
    known: f64,
}

impl Search<'_> {
    fn add(&mut self, a: Cut, b: Cut) {
        self.intervals.push(Interval { bound: self.proof.inner(a, b), a, b });
    }

    /// The largest bound, once it is known to 2 %, or not worth the while.
    fn bound(mut self, small: f64) -> f64 {
        for _ in 0..MOST_HALVINGS {
            let Some(Interval { bound, a, b }) = self.intervals.pop() else { return 0.0 };
            let middle = 0.5 * (a.s + b.s);
            if bound <= (1.02 * self.known).max(small) || !(a.s < middle && middle < b.s) {
                return bound;
            }
            let cut = self.proof.cut(middle);
            let here = self.proof.inner(cut, cut);
            // No halving proves less than what a single place takes.
            if !(here <= self.proof.tolerance) {
                return bound.max(here);
            }
            self.known = self.known.max(here);
            self.add(a, cut);
            self.add(cut, b);
        }
        self.intervals.peek().map_or(0.0, |interval| interval.bound)
    }
}

/// Then whatever is proven so far is returned.
const MOST_HALVINGS: usize = 1000;

/// A place where the section is cut, with the direction there, and about how far the fitted curve is.
#[derive(Clone, Copy)]
struct Cut {
    s: f64,
    direction: Direction,
    distance: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Direction {
    /// Towards the axis.
    Level,
    /// A unit vector.
    Along([f64; 2]),
    /// Upright, beside a tip where there is a step.
    Upright,
}

impl Direction {
    /// As a unit vector, where upright lines go the way that H grows.
    fn vector(self, slope: f64) -> [f64; 2] {
        match self {
            Self::Level => [-1.0, 0.0],
            Self::Along(direction) => direction,
            Self::Upright => [0.0, slope.signum()],
        }
    }
}

struct Interval {
    bound: f64,
    a: Cut,
    b: Cut,
}

impl Ord for Interval {
    fn cmp(&self, other: &Self) -> core::cmp::Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

impl PartialOrd for Interval {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Interval {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Interval {}

/// Numbers from the first to the second.
#[derive(Clone, Copy, Debug)]
struct Range(f64, f64);

impl Range {
    const NONE: Self = Self(f64::INFINITY, f64::NEG_INFINITY);

    fn of(balls: &[Ball]) -> Self {
        balls.iter().fold(Self::NONE, |range, ball| range.and(Self(ball.low(), ball.high())))
    }

    fn and(self, other: Self) -> Self {
        Self(self.0.min(other.0), self.1.max(other.1))
    }

    fn wider(self, by: f64) -> Self {
        Self((self.0 - by).next_down(), (self.1 + by).next_up())
    }

    /// The largest magnitude.
    fn magnitude(self) -> f64 {
        self.1.max(-self.0)
    }

    fn width(self) -> f64 {
        (self.1 - self.0).next_up()
    }

    /// The least value of x·a + y·b.
    fn least_sum(x: f64, a: Self, y: f64, b: Self) -> f64 {
        let least = |x: f64, Self(low, high): Self| (x * low).min(x * high).next_down();
        (least(x, a) + least(y, b)).next_down()
    }
}

/// A slope of squared radius over height, in radii: where it is no larger the curve is steep. What is 17° from
/// upright is at most 5 % farther away at one height than it is at all.
const STEEP: f64 = 0.6;

/// A slope in radii: where it is no smaller the curve is near level, 17° at most.
const NEAR_LEVEL: f64 = 6.6;

/// How small tips are tried: 2⁻¹ to 2⁻⁴⁴ of a piece.
const TIPS: i32 = 45;

/// What is proven of what.
struct Proof<'a> {
    section: &'a Section,
    segments: &'a [Segment],
    steps: [bool; 2],
    /// Up to this s below, and from that one above, lines are upright.
    upright: [f64; 2],
    size: f64,
    /// What exceeds it need not be known closely.
    tolerance: f64,
}

/// A piece between two t, in balls.
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
    fn new(piece: &Piece, a: f64, b: f64) -> Self {
        let part = |c: &[f64]| restrict(&lift::<Ball>(c), a, b);
        let radius = match &piece.radius {
            Radius::Plain(r) => Radii::Plain(part(r)),
            Radius::Squared(f) => Radii::Squared(part(f)),
        };
        Self { radius, z: part(&piece.z), w: part(&piece.w) }
    }

    fn over_weights(&self, c: &[Ball]) -> Range {
        if self.w.len() == 1 {
            return Range::of(c);
        }
        Range::of(&c.iter().zip(&self.w).map(|(c, w)| c.over(*w)).collect::<Vec<_>>())
    }

    fn heights(&self) -> Range {
        self.over_weights(&self.z)
    }

    fn radii(&self) -> Range {
        match &self.radius {
            Radii::Plain(r) => self.over_weights(r),
            Radii::Squared(f) => roots(Range::of(f)),
        }
    }

    /// F − r², where F is the segment's cubic.
    fn gap(&self, segment: &Segment) -> Range {
        let [b0, b1, b2, b3] = segment.b.map(Ball::exact);
        let three = Ball::exact(3.0);
        let (f1, f2) = (three * (b1 - b0), three * (b2 - b1 - b1 + b0));
        let f3 = b3 - b0 - three * (b2 - b1);
        let [z0, z1] = segment.z.map(Ball::exact);
        let height = z1 - z0;
        // w·u, u the segment's parameter.
        let u = sum(&self.z, &scale(&self.w, -z0));
        let u: Vec<Ball> = u.into_iter().map(|u| u.over(height)).collect();
        let (u2, w2) = (product(&u, &u), product(&self.w, &self.w));
        let w3 = product(&w2, &self.w);
        let low = sum(&scale(&w3, b0), &scale(&product(&u, &w2), f1));
        let high = sum(&scale(&product(&u2, &self.w), f2), &scale(&product(&u2, &u), f3));
        let square = match &self.radius {
            Radii::Plain(r) => product(&product(r, r), &self.w),
            Radii::Squared(f) => f.clone(),
        };
        let gap = sum(&sum(&low, &high), &scale(&square, Ball::exact(-1.0)));
        if w3.len() == 1 {
            return Range::of(&gap);
        }
        Range::of(&gap.iter().zip(&w3).map(|(gap, w)| gap.over(*w)).collect::<Vec<_>>())
    }
}

/// The square roots of what is not below zero.
fn roots(range: Range) -> Range {
    Range(range.0.max(0.0).sqrt().next_down().max(0.0), range.1.max(0.0).sqrt().next_up())
}

impl<'a> Proof<'a> {
    fn new(section: &'a Section, segments: &'a [Segment], steps: [bool; 2], tolerance: f64) -> Self {
        let radius = segments.iter().flat_map(|s| s.b).fold(0.0, |f: f64, b| f.max(b)).sqrt();
        let height = segments[segments.len() - 1].z[1] - segments[0].z[0];
        let pieces = &section.pieces;
        // Where the section is near level, and so near to its tip that the step is near, too.
        let near = |s: f64, tip: Point| {
            let place = section.place(s);
            (place.z - tip.z).abs() <= 0.5 * tolerance && place.slope.abs() >= NEAR_LEVEL * place.r
        };
        let length = pieces.len() as f64;
        let part = (1..TIPS).map(|k| (-f64::from(k)).exp2());
        let low = part.clone().find(|s| near(*s, section.low.at)).filter(|_| steps[0]);
        let high = part.map(|s| length - s).find(|s| near(*s, section.high.at)).filter(|_| steps[1]);
        let upright = [low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY)];
        Self { section, segments, steps, upright, size: radius + height, tolerance }
    }

    /// The bound, with boxes at tips as large as they may be without exceeding `small` (or else as good as they
    /// get).
    fn bound(&self, small: f64) -> f64 {
        let pieces = &self.section.pieces;
        let length = pieces.len() as f64;
        let small = small.max((-23f64).exp2() * self.size);
        let tip = |upper: bool| {
            let at = |k: i32| if upper { length - (-f64::from(k)).exp2() } else { (-f64::from(k)).exp2() };
            // With a step upright lines reach the very end, but not if the segments turn before.
            let step = self.steps[usize::from(upper)];
            let mut best = if step {
                (if upper { length } else { 0.0 }, self.overshoot(upper))
            } else {
                (at(1), f64::INFINITY)
            };
            let largest = 1 - (length.log2() as i32);
            for k in largest..TIPS {
                let bound = self.tip(self.cut(at(k)), upper);
                if bound <= small || bound < best.1 {
                    best = (at(k), bound);
                }
                if bound <= small || step && k > 20 {
                    break;
                }
            }
            best
        };
        let [(low, low_bound), (high, high_bound)] = [tip(false), tip(true)];
        let tips = low_bound.max(high_bound);
        if !(low < high) {
            return if low == high { tips } else { f64::INFINITY };
        }
        let mut cuts: Vec<f64> = (0..=pieces.len()).map(|i| i as f64).collect();
        for segment in &self.segments[1..] {
            let z = segment.z[0];
            if let Some(i) = pieces.iter().position(|piece| piece.start().z < z && z < piece.end().z) {
                cuts.push(i as f64 + pieces[i].at_height(z));
            }
        }
        cuts.extend(self.upright);
        cuts.retain(|s| *s > low && *s < high);
        cuts.extend([low, high]);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let cuts: Vec<Cut> = cuts.into_iter().map(|s| self.cut(s)).collect();
        let mut search = Search { proof: self, intervals: BinaryHeap::new(), known: 0.0 };
        for pair in cuts.windows(2) {
            search.add(pair[0], pair[1]);
        }
        search.bound(small.max(0.98 * tips)).max(tips)
    }

    /// How far the segments end beyond the end of the section, to which a step leads back.
    fn overshoot(&self, upper: bool) -> f64 {
        let ends = self.ends();
        let (end, z) = if upper { (self.section.high.at, ends.1) } else { (self.section.low.at, ends.0) };
        let near = self.section.pieces[if upper { self.section.pieces.len() - 1 } else { 0 }].at(0.5).r;
        let fitted = self.radii(Range(z, z));
        if near < end.r { fitted.1 - end.r } else { end.r - fitted.0 }.max(0.0)
    }

    fn ends(&self) -> Range {
        Range(self.segments[0].z[0], self.segments[self.segments.len() - 1].z[1])
    }

    fn piece(&self, s: f64) -> (usize, f64) {
        let i = (s as usize).min(self.section.pieces.len() - 1);
        (i, s - i as f64)
    }

    fn cut(&self, s: f64) -> Cut {
        let (i, t) = self.piece(s);
        let Point { r, z } = self.section.pieces[i].at(t);
        let above = self.segments.partition_point(|segment| segment.z[1] < z);
        let segment = &self.segments[above.min(self.segments.len() - 1)];
        let (f, slope) = segment.at(z);
        let gradient = (2.0 * r).hypot(slope);
        let direction = if s <= self.upright[0] || s >= self.upright[1] {
            Direction::Upright
        } else if slope.abs() <= STEEP * r || !(gradient > 0.0 && gradient.is_finite()) {
            Direction::Level
        } else {
            Direction::Along([-2.0 * r / gradient, slope / gradient])
        };
        // Where lines are upright the step may be nearer.
        let distance = match direction {
            Direction::Upright => 0.0,
            _ => ((f - r * r).abs() / gradient).min((f.max(0.0).sqrt() - r).abs()),
        };
        Cut { s, direction, distance: if distance.is_finite() { distance } else { 0.0 } }
    }

    /// The segments that share heights with a range; the first and the last one stand for what lies beyond.
    fn at_heights(&self, heights: Range) -> &[Segment] {
        let last = self.segments.len() - 1;
        let first = self.segments.partition_point(|segment| segment.z[1] < heights.0).min(last);
        let end = self.segments.partition_point(|segment| segment.z[0] <= heights.1).max(first + 1);
        &self.segments[first..end]
    }

    /// A range of heights in a segment's parameter, rounded outwards; cut off at its ends, but not at the
    /// whole curve's.
    fn parameters(&self, segment: &Segment, heights: Range) -> Range {
        let [z0, z1] = segment.z;
        let u = |z: f64| (z - z0) / (z1 - z0);
        let outwards = |u: f64| 4.0 * f64::EPSILON * (1.0 + u.abs());
        let ends = self.ends();
        let (low, high) = (u(heights.0) - outwards(u(heights.0)), u(heights.1) + outwards(u(heights.1)));
        Range(if z0 == ends.0 { low } else { low.max(0.0) }, if z1 == ends.1 { high } else { high.min(1.0) })
    }

    /// The slopes of F at heights.
    fn slopes(&self, heights: Range) -> Range {
        self.at_heights(heights).iter().fold(Range::NONE, |range, segment| {
            let [z0, z1] = segment.z.map(Ball::exact);
            let b = segment.b.map(Ball::exact);
            let third = (z1 - z0) / 3.0;
            let slope = [b[1] - b[0], b[2] - b[1], b[3] - b[2]].map(|difference| difference.over(third));
            let Range(low, high) = self.parameters(segment, heights);
            range.and(Range::of(&restrict(&slope, low, high)))
        })
    }

    /// The radii of the segments at heights that are within their ends.
    fn radii(&self, heights: Range) -> Range {
        let ends = self.ends();
        let heights = Range(heights.0.max(ends.0), heights.1.min(ends.1));
        let squares = self.at_heights(heights).iter().fold(Range::NONE, |range, segment| {
            let Range(low, high) = self.parameters(segment, heights);
            range.and(Range::of(&restrict(&segment.b.map(Ball::exact), low.max(0.0), high.min(1.0))))
        });
        roots(squares)
    }

    /// A bound of the distance over the interval, or infinity if none is found.
    fn inner(&self, a: Cut, b: Cut) -> f64 {
        // An interval ends where its piece does: the middle lies in it.
        let (i, _) = self.piece(0.5 * (a.s + b.s));
        let stretch = Stretch::new(&self.section.pieces[i], a.s - i as f64, b.s - i as f64);
        match (a.direction, b.direction) {
            (Direction::Level, Direction::Level) => self.level(&stretch),
            _ => self.along(&stretch, [a.direction, b.direction]),
        }
    }

    /// g = F − r² over a stretch.
    fn gap(&self, stretch: &Stretch) -> Range {
        let segments = self.at_heights(stretch.heights());
        segments.iter().map(|segment| stretch.gap(segment)).fold(Range::NONE, Range::and)
    }

    /// At one height: |g|/(r + √F), or either radius.
    fn level(&self, stretch: &Stretch) -> f64 {
        let (heights, radii) = (stretch.heights(), stretch.radii());
        let ends = self.ends();
        if !(heights.0 >= ends.0 && heights.1 <= ends.1) {
            return f64::INFINITY;
        }
        let fitted = self.radii(heights);
        let by_gap = (self.gap(stretch).magnitude() / (radii.0 + fitted.0).next_down()).next_up();
        let either = radii.1.max(fitted.1);
        if by_gap >= 0.0 { by_gap.min(either) } else { either }
    }

    /// Along lines between two directions: |g|/m, or as far as it is to a step.
    fn along(&self, stretch: &Stretch, directions: [Direction; 2]) -> f64 {
        let (heights, radii, gap, ends) =
            (stretch.heights(), stretch.radii(), self.gap(stretch), self.ends());
        let mut bound = 0.0;
        for _ in 0..7 {
            let Some(found) = self.within(bound, directions, heights, radii, gap) else {
                return f64::INFINITY;
            };
            if found <= bound {
                // What lies beyond the ends by rounding.
                let beyond = (ends.0 - heights.0).max(heights.1 - ends.1).max(0.0);
                return (found + beyond).next_up();
            }
            bound = if bound == 0.0 { found * (1.0 + 1e-9) } else { 1.1 * found };
        }
        f64::INFINITY
    }

    /// The bound that holds as long as it is not above `by`, if lines so long stay where the rules hold.
    fn within(
        &self,
        by: f64,
        directions: [Direction; 2],
        heights: Range,
        radii: Range,
        gap: Range,
    ) -> Option<f64> {
        let ends = self.ends();
        let reach = heights.wider(by);
        let beyond = [reach.0 < ends.0, reach.1 > ends.1];
        let at_step = [0, 1].map(|tip| beyond[tip] && self.steps[tip]);
        let first = &self.segments[0];
        let last = &self.segments[self.segments.len() - 1];
        // Beyond a pole F falls through zero, and H has no zero any more.
        let low =
            !beyond[0] || at_step[0] || first.b[0] == 0.0 && self.slopes(Range(reach.0, ends.0)).0 > 0.0;
        let high =
            !beyond[1] || at_step[1] || last.b[3] == 0.0 && self.slopes(Range(ends.1, reach.1)).1 < 0.0;
        if !(low && high) {
            return None;
        }
        let clipped = Range(
            if at_step[0] { reach.0.max(ends.0) } else { reach.0 },
            if at_step[1] { reach.1.min(ends.1) } else { reach.1 },
        );
        let slopes = self.slopes(clipped);
        let rises = slopes.0 > 0.0;
        if (at_step[0] || at_step[1]) && !rises && !(slopes.1 < 0.0) {
            return None;
        }
        // The gradient of H is (−2r, F′).
        let vectors = directions.map(|direction| direction.vector(slopes.0));
        let wider = radii.wider(by);
        let growth = vectors.map(|[dr, dz]| Range::least_sum(-2.0 * dr, wider, dz, slopes));
        // Directions are unit vectors to within rounding.
        let least = growth[0].min(growth[1]) * (1.0 - 8.0 * f64::EPSILON);
        if !(least > 0.0) {
            return (gap.0 == 0.0 && gap.1 == 0.0).then_some(0.0);
        }
        // Lines along d where H < 0, against it where H > 0: upwards or downwards as F rises or falls.
        let [mut along, mut against] = [-gap.0, gap.1].map(|gap| (gap.max(0.0) / least).next_up());
        for tip in [0, 1] {
            if !at_step[tip] {
                continue;
            }
            // Lines to the step must not lean away from it.
            let upright = vectors.map(|[_, dz]| if rises { dz } else { -dz });
            let least = upright[0].min(upright[1]);
            if !(least >= 0.0) {
                return None;
            }
            let height = if tip == 0 { heights.1 - ends.0 } else { ends.1 - heights.0 };
            // To the step, or no farther than the corner where the segments end: what lines meet is as near.
            let to_end =
                self.radii(if tip == 0 { Range(ends.0, heights.1) } else { Range(heights.0, ends.1) });
            let across = (radii.1 - to_end.0).max(to_end.1 - radii.0).max(0.0);
            let along_line = if least > 0.0 { height / least } else { f64::INFINITY };
            let to_step = along_line.min(height.hypot(across)).next_up();
            let goes = if (tip == 1) == rises { &mut along } else { &mut against };
            *goes = goes.min(to_step);
            // The step ends with the section, which must not lie beyond.
            let end = if tip == 0 { self.section.low.at.r } else { self.section.high.at.r };
            let inwards = (tip == 1) != rises;
            let past = if inwards { end - radii.0 } else { radii.1 - end };
            *goes += past.max(0.0);
        }
        Some(along.max(against))
    }

    /// A bound for what lies between a cut and the section's upper or lower end.
    fn tip(&self, cut: Cut, upper: bool) -> f64 {
        let near = self.inner(cut, cut);
        if !near.is_finite() {
            return f64::INFINITY;
        }
        let (i, t) = self.piece(cut.s);
        let pieces = &self.section.pieces;
        let stretches: Vec<Stretch> = if upper {
            let whole = pieces[i + 1..].iter().map(|piece| Stretch::new(piece, 0.0, 1.0));
            core::iter::once(Stretch::new(&pieces[i], t, 1.0)).chain(whole).collect()
        } else {
            let whole = pieces[..i].iter().map(|piece| Stretch::new(piece, 0.0, 1.0));
            whole.chain([Stretch::new(&pieces[i], 0.0, t)]).collect()
        };
        let around = |range: fn(&Stretch) -> Range| stretches.iter().map(range).fold(Range::NONE, Range::and);
        let (drawn_z, drawn_r) = (around(Stretch::heights), around(Stretch::radii));
        let point = Stretch::new(&pieces[i], t, t);
        let (cut_z, cut_r) = (point.heights().wider(near), point.radii().wider(near));
        let ends = self.ends();
        let end_z = if upper { ends.1 } else { ends.0 };
        let fitted_z = cut_z.and(Range(end_z, end_z));
        let end = if upper { self.section.high.at } else { self.section.low.at };
        let end_r = Range(end.r, end.r);
        // A step leads from the end of the segments to that of the section.
        let step = self.steps[usize::from(upper)];
        let fitted_end_r = if step { end_r } else { self.radii(Range(end_z, end_z)) };
        let fitted_r = self.radii(fitted_z).and(fitted_end_r).and(cut_r);

        let (all_z, all_r) = (drawn_z.and(fitted_z), drawn_r.and(fitted_r));
        // What each curve is sure to cross, from the far end of the cut to its own end.
        let across = |cut: Range, end: Range| Range(cut.1.min(end.1), cut.0.max(end.0));
        let beyond =
            |all: Range, crossed: Range| (all.1 - crossed.1).max(crossed.0 - all.0).max(0.0).next_up();
        let crossed_r =
            beyond(drawn_r, across(cut_r, fitted_end_r)).max(beyond(fitted_r, across(cut_r, end_r)));
        let crossed_z = beyond(drawn_z, across(cut_z, Range(end_z, end_z)))
            .max(beyond(fitted_z, across(cut_z, Range(end.z, end.z))));
        let flat = crossed_r.hypot(all_z.width());
        let steep = crossed_z.hypot(all_r.width());
        let small = all_r.width().hypot(all_z.width());
        flat.min(steep).min(small) * (1.0 + 4.0 * f64::EPSILON)
    }
}
