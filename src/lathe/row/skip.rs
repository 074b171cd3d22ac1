//! Spans of misses: an upper bound of g along one ray, and the number of neighbours for which it still proves
//! a miss.

use super::bounds::SPANS;
use super::sweep::{Start, Sweep};
use crate::cubic::{Cubic, quadratic_max_on};
use crate::lathe::frame::Frame;
use crate::lathe::ray::LocalRay;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::{F32x3, dot_xy};

/// By what part of itself |dz| may fall, at most, within the pixels that one probe certifies: to 7/8.
///
/// The value is a choice: it keeps `n/(1 − n·ε)`, see [`Sweep::certified_run`], near n.
const FALL: f32 = 1.0 / 8.0;

/// What a probe finds of one ray.
pub(super) enum Probe {
    /// The ray misses the solid, and so do those of the next pixels, to before pixel `to`.
    Misses { to: u32 },
    /// The ray may meet the solid, near this place if anywhere.
    MayMeet(Start),
}

/// An upper bound of sign·g along a ray.
pub(super) struct UpperBound {
    /// The bound plus the tolerance of the segment where it is reached. If this is below zero, sign·g is
    /// certain to be. It holds for the whole part asked for; if there is a start, only as far as the end of
    /// the start's segment.
    pub g: f32,
    /// The tolerance of the last segment in which `g` is not below zero.
    pub tolerance: f32,
    /// About where sign·g crosses zero, in the first segment where sign·g may come to within the tolerance of
    /// zero. The start's own sign is 1 where sign·g rises through zero along the ray, −1 where it falls.
    /// It is a plane if sign·g jumps over zero there. `None` if sign·g stays below zero by the tolerance in
    /// every segment, or if it is above zero where the part begins and falls through zero nowhere in it.
    pub start: Option<Start>,
}

impl Sweep<'_> {
    /// Decides by the segments' cubics whether the i-th ray misses the solid by more than the tolerance, and
    /// how many of the next rays do.
    pub(super) fn probe(&self, i: u32) -> Probe {
        let bounds = &self.bounds;
        let path = self.path(i);
        // A ray that runs level in the plane of an end or of a step may meet the rim, where g has a jump.
        if bounds.lathe.is_near_edge(path.z, bounds.tolerance - path.dz.abs()) {
            return Probe::MayMeet(Start { index: usize::MAX, s: 0.0, sign: 0.0 });
        }
        let Frame { len, ref base, ref top, .. } = *bounds.lathe.frame;
        let (exit, entry, end) = if path.rises() { (len, base, top) } else { (0, top, base) };
        let interval = self.interval(&path);
        let start = match self.below_zero(i, &path, 1.0, interval, exit) {
            Ok(to) => return Probe::Misses { to },
            Err(bound) => bound.start,
        };
        // No crossing is known in any segment: the ray may leave the solid through the far end, without meeting
        // it if that end is open, and if the ray begins inside or has come in through an open end.
        let has_come_in = interval.0 == bounds.start || entry.beyond > 0.0;
        if start.is_none()
            && end.beyond > 0.0
            && has_come_in
            && let Ok(to) = self.below_zero(i, &path, -1.0, interval, exit)
        {
            return Probe::Misses { to };
        }
        Probe::MayMeet(start.unwrap_or(Start { index: exit, s: 0.0, sign: 0.0 }))
    }

    /// Whether sign·g stays below zero by more than the tolerance on an interval of the i-th ray. If so, the
    /// first pixel after it for which that is not certified; if not, or if it is not certain, the bound as an
    /// error.
    ///
    /// Where the interval begins on the plane of an end, or ends on the plane of the knot `last`, sign·g must
    /// be below zero on both sides of the plane. If no knot has the number `last`, sign·g is tested only on
    /// the near side of the interval's end.
    #[inline(never)]
    pub(super) fn below_zero(
        &self,
        i: u32,
        path: &LocalRay,
        sign: f32,
        interval: (f32, f32),
        last: usize,
    ) -> Result<u32, UpperBound> {
        let bound = self.upper_bound(path, sign, interval, last);
        if !(bound.g < 0.0) {
            return Err(bound);
        }
        if interval == (self.bounds.start, self.bounds.start) {
            // The interval is the one point where all rays begin: so sign·g is the same for all of them.
            return Ok(u32::MAX);
        }
        Ok((i + 1).saturating_add(self.certified_run(path, self.ray(i), sign, -bound.g, interval)))
    }

    /// An interval of s along a ray. It contains the point of this ray at every height at which this ray, or
    /// any of the next rays that a probe of this ray certifies, can meet the solid. If there is no such
    /// height, it is empty: its end comes before its begin. It begins where the rays begin, if that is later:
    /// at one point, and so at one height, for all of them.
    pub(super) fn interval(&self, path: &LocalRay) -> (f32, f32) {
        let span = (1.0 + SPANS) * self.bounds.span;
        let (near, far) = path.slab(self.bounds.low, self.bounds.high);
        (greater(self.bounds.start, greater(-span, near)), lesser(span, far))
    }

    /// An upper bound of sign·g and its tolerance between two points of a ray, −∞ if the far one comes before
    /// the near one. The segments are bounded one after another, to the one that has the start. `last` is as
    /// in [`Sweep::below_zero`].
    #[inline(always)]
    fn upper_bound(&self, path: &LocalRay, sign: f32, (near, far): (f32, f32), last: usize) -> UpperBound {
        let bounds = &self.bounds;
        let lathe = bounds.lathe;
        let frame = lathe.frame;
        let mut bound = UpperBound { g: f32::NEG_INFINITY, tolerance: 0.0, start: None };
        if !(near <= far) {
            return bound;
        }
        let rises = path.rises();
        let (onward, entry) = if rises { (1, 0) } else { (usize::MAX, frame.len) };
        if frame.has_rings {
            let entry = if near > bounds.start { entry } else { usize::MAX };
            for (t, number, is_behind) in [(near, entry, false), (far, last, true)] {
                if let Some(plane) = lathe.plane(number) {
                    let square = if is_behind == rises { plane.above } else { plane.below };
                    bound.g = greater(sign * (square - path.around(t).0) + bounds.tolerance, bound.g);
                }
            }
        }
        let mut index = lathe.index_at(path.height(near));
        let mut from = near;
        // Whether sign·g is above zero where the next segment begins, as it is at the end of the one before.
        let mut is_above = false;
        while let Some(segment) = lathe.segments.get(index) {
            let (_, to) = path.slab(segment.low, segment.high);
            let to = lesser(far, to);
            let at = path.closest(from, to);
            // The segment's bounding cylinder bounds g as well, and most often suffices.
            let mut most_here = segment.bounding_square - path.around(at).0 + bounds.tolerance;
            if sign < 0.0 || is_above || !(most_here < 0.0) {
                let tolerance = bounds.tolerance_in(segment);
                let g = Cubic::new(path.g_about(segment, at).c.map(|c| sign * c));
                most_here = g.max_on(at - from, to - at) + tolerance;
                if !(most_here < 0.0) {
                    bound.tolerance = tolerance;
                    let mut crosses = if g.at(from - at) > 0.0 { -1.0 } else { 1.0 };
                    let mut s = at + zero(&g, crosses);
                    // Where there is no root, Newton's steps may end anywhere.
                    let is_root = s <= to && g.at(s - at).abs() < tolerance;
                    let mut place = index;
                    if from > near && (crosses < 0.0) != is_above {
                        // Between the two segments sign·g jumps over zero.
                        (crosses, s, place) = (0.0, from, index + usize::from(!rises));
                    }
                    is_above = crosses < 0.0 && !is_root;
                    if !is_above {
                        bound.start = Some(Start { index: place, s: greater(from, s), sign: crosses });
                    }
                }
            }
            bound.g = greater(most_here, bound.g);
            if bound.start.is_some() || !(to < far) {
                break;
            }
            from = to;
            index = index.wrapping_add(onward);
        }
        bound
    }

    /// The number of next pixels for whose rays sign·g is certain to stay below zero, at every height that
    /// the given ray has in an interval of s. `path` is that ray, and `(m, d)` its M and D. On it sign·g plus
    /// the tolerance is at most −`margin`; `margin` is positive. Zero if no next pixel is certain.
    ///
    /// Take one height. The point P where a ray has that height moves, as the pixel's number grows, along the
    /// line in which the row's plane meets that height, and always the same way. At P, g is F less the square
    /// of P's distance from the axis, and F is the same for all pixels, as the height is. If v is the motion
    /// of P from one pixel to the next, n pixels on g has changed by `−2·n·⟨P, v⟩ − n²·v²`. The largest
    /// values of both terms over the interval are those of two quadratics in s.
    #[inline(always)]
    fn certified_run(
        &self,
        path: &LocalRay,
        (m, d): (F32x3, F32x3),
        sign: f32,
        margin: f32,
        (from, to): (f32, f32),
    ) -> u32 {
        let (m1, d1) = (self.direction.rays.origin_change, self.direction.rays.direction_change);
        // The motion v at a height is that of the ray's point at fixed s, and along the ray by so much that z
        // does not change: `v0 + v1·s`. From here on s is counted from the middle of the interval, where the
        // ray has its point p and the motion is v.
        let drift = self.bounds.drift;
        let per_dz = if drift > 0.0 { path.per_dz } else { 0.0 };
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (v0, v1) = (m1 - d * (m1.z * per_dz), d1 - d * (d1.z * per_dz));
        let (p, v) = (m + d * middle, v0 + v1 * middle);
        // The most of −sign·⟨P, v⟩, half the first term of the change, and of −sign·v², the second.
        let pace = quadratic_max_on(
            -sign * dot_xy(p, v),
            -sign * (dot_xy(p, v1) + dot_xy(d, v)),
            -sign * dot_xy(d, v1),
            half,
        );
        let square =
            quadratic_max_on(-sign * dot_xy(v, v), -2.0 * sign * dot_xy(v, v1), -sign * dot_xy(v1, v1), half);
        // ε, the part of itself by which dz falls from pixel to pixel; negative if it grows. v is that of the
        // first pixel; as dz changes, a point moves in n pixels by `v·n/(1 − n·ε)`.
        let fall = -d1.z * per_dz;
        // One over the number of pixels in which the point of a height moves by SPANS spans, or dz falls by
        // FALL of itself.
        let level = greater(drift * per_dz.abs(), fall / FALL);
        // One over the number n with which the change comes to the margin: the larger root of
        // `margin·r² − 2·pace·r − square`. If there is no such root or the margin is infinite, `rate` is NaN;
        // then, as where `rate` is not positive, the change never comes to the margin.
        let rate = (pace + Native::sqrt(pace * pace + square * margin)) / margin;
        // `greater` returns `level` if the other number is NaN. The conversion to u32 saturates.
        (1.0 / greater(level, rate + fall)) as u32
    }
}

/// About where a cubic rises through zero (sign 1) or falls through it (−1): the root of its first three
/// terms, improved by two Newton steps. If there is none, the result may be NaN or any number: it is a
/// guess.
fn zero(g: &Cubic, sign: f32) -> f32 {
    let [c0, c1, c2, _] = g.c;
    let mut s = (sign * Native::sqrt(c1 * c1 - 4.0 * c2 * c0) - c1) / (2.0 * c2);
    for _ in 0..2 {
        let (value, slope) = g.with_slope(s);
        s -= value / slope;
    }
    s
}
