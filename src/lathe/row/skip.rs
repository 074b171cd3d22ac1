//! Spans of misses: an upper bound of g along one ray, and the number of neighbours for which it still proves
//! a miss.

use super::bounds::SPANS;
use super::sweep::{RootStart, Sweep};
use crate::cubic::{Cubic, quadratic_max_on};
use crate::lathe::ray::LocalRay;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::{F32x3, dot_xy};

/// By what part of itself dz may fall within those pixels: to 7/8. A choice as well: it keeps `n/(1 − n·ε)`,
/// see [`Sweep::certified_run`], near n.
const FALL: f32 = 1.0 / 8.0;

/// What a probe of one ray says.
pub(super) enum Probe {
    /// It misses, and so do its neighbours up to pixel `to`.
    Misses { to: u32 },
    /// It may meet the solid: there, if that is known.
    MayMeet(Option<RootStart>),
}

/// An upper bound of sign·g along a ray.
pub(super) struct UpperBound {
    /// The bound, over the part of the ray in front of `start`'s segment if there is a start, else over all
    /// of it.
    pub g: f32,
    /// In the first segment where sign·g may come to the tolerance below zero, about where it comes to zero:
    /// its sign is 1 if it does so from below, −1 from above.
    pub start: Option<RootStart>,
}

impl Sweep<'_> {
    /// Decides by the cubics of the segments whether the i-th ray clearly misses.
    pub(super) fn probe(&self, i: u32) -> Probe {
        let bounds = &self.bounds;
        let ray = self.ray(i);
        let path = self.path(ray);
        // Level with an end's plane the ray may meet the rim, where g has a jump.
        let frame = bounds.lathe.frame;
        let from_ends = lesser((path.z - frame.low).abs(), (path.z - frame.high).abs());
        if from_ends + path.dz.abs() < bounds.tolerance {
            return Probe::MayMeet(None);
        }
        let interval = self.interval(&path);
        let UpperBound { g, start } = self.upper_bound(&path, 1.0, interval);
        if !(g < -bounds.tolerance) {
            return Probe::MayMeet(start);
        }
        let run = self.certified_run(&path, ray, 1.0, -g - bounds.tolerance, interval);
        Probe::Misses { to: (i + 1).saturating_add(run) }
    }

    /// The interval in s in which a ray, or one of the neighbours that a probe of it may certify, can meet
    /// the solid at the height that this ray has there.
    pub(super) fn interval(&self, path: &LocalRay) -> (f32, f32) {
        let span = (1.0 + SPANS) * self.bounds.span;
        let (near, far) = path.slab(self.bounds.low, self.bounds.high);
        (greater(-span, near), lesser(span, far))
    }

    /// An upper bound of sign·g along a ray between two of its points, from segment to segment; it ends at
    /// the first that may bring sign·g to within the tolerance of zero.
    #[inline(never)]
    pub(super) fn upper_bound(&self, path: &LocalRay, sign: f32, (near, far): (f32, f32)) -> UpperBound {
        let lathe = self.bounds.lathe;
        let tolerance = self.bounds.tolerance;
        let mut bound = UpperBound { g: f32::NEG_INFINITY, start: None };
        let step = if path.rises() { 1 } else { usize::MAX };
        let mut index = lathe.index_at(path.height(near));
        let mut from = near;
        while from <= far
            && let Some(segment) = lathe.segments.get(index)
        {
            let (_, to) = path.slab(segment.low, segment.high);
            let to = lesser(far, to);
            let at = path.closest(from, to);
            // The segment's cylinder bounds g, too, and most often says enough.
            let mut most_here = segment.bounding_square - path.around(at).0;
            if sign < 0.0 || most_here > bound.g && !(most_here < -tolerance) {
                let g = Cubic::new(path.g_about(segment, at).c.map(|c| sign * c));
                most_here = g.max_on(at - from, to - at);
                if !(most_here < -tolerance) {
                    let sign = if g.at(from - at) > 0.0 { -1.0 } else { 1.0 };
                    let s = at + zero(&g, sign);
                    if sign > 0.0 || s <= to {
                        bound.start = Some(RootStart { index, s: greater(from, s), sign });
                    }
                }
            }
            bound.g = greater(most_here, bound.g);
            if bound.start.is_some() || !(to < far) {
                break;
            }
            from = to;
            index = index.wrapping_add(step);
        }
        bound
    }

    /// The number of pixels after a ray for which sign·g stays below zero at every height of an interval of
    /// the ray, given that it is at least `margin` below zero there.
    ///
    /// At a height, the point that a ray has there moves along a line as the pixel's number grows, the row's
    /// plane at that height, and always the same way; g is F there less the square of the point's distance
    /// from the axis. So n pixels on it has grown by n times its pace, `−2·⟨P, v⟩` with v the point's motion
    /// from pixel to pixel, less n²·v². Bounds of both over the interval are the maxima of two quadratics in
    /// s.
    #[inline(never)]
    pub(super) fn certified_run(
        &self,
        path: &LocalRay,
        (m, d): (F32x3, F32x3),
        sign: f32,
        margin: f32,
        (from, to): (f32, f32),
    ) -> u32 {
        let (m1, d1) = (self.direction.rays.origin_step, self.direction.rays.direction_step);
        // The point of height z moves as the ray does there, and along it by so much that z stays. That is
        // `v0 + v1·x`, with x counted from the middle of the interval, where the ray has its point p.
        let drift = self.bounds.drift;
        let per_dz = if drift > 0.0 { path.per_dz } else { 0.0 };
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (v0, v1) = (m1 - d * (m1.z * per_dz), d1 - d * (d1.z * per_dz));
        let (p, v) = (m + d * middle, v0 + v1 * middle);
        // Half the pace.
        let pace = quadratic_max_on(
            -sign * dot_xy(p, v),
            -sign * (dot_xy(p, v1) + dot_xy(d, v)),
            -sign * dot_xy(d, v1),
            half,
        );
        let square =
            quadratic_max_on(-sign * dot_xy(v, v), -2.0 * sign * dot_xy(v, v1), -sign * dot_xy(v1, v1), half);
        // The part ε of itself by which dz falls from pixel to pixel, or, negative, grows: n pixels move the
        // points as far as `n/(1 − n·ε)` would at the first one's pace.
        let fall = -d1.z * per_dz;
        // One over the number of pixels for which SPANS and FALL hold.
        let level = greater(drift * per_dz.abs(), fall / FALL);
        // One over the n that uses up the margin: the positive root of `margin·r² − 2·pace·r − square`. Zero,
        // or NaN where it is not real, if no n does.
        let rate = (pace + Native::sqrt(pace * pace + square * margin)) / margin;
        // NaN loses; the conversion saturates.
        (1.0 / greater(level, rate + fall)) as u32
    }
}

/// About where a cubic comes to zero from below (sign 1) or from above (−1): where the parabola of its first
/// terms does, and two of Newton's steps on. NaN or anything if it does not; what uses it checks.
fn zero(g: &Cubic, sign: f32) -> f32 {
    let [c0, c1, c2, _] = g.c;
    let mut s = (sign * Native::sqrt(c1 * c1 - 4.0 * c2 * c0) - c1) / (2.0 * c2);
    for _ in 0..2 {
        let (value, slope) = g.with_slope(s);
        s -= value / slope;
    }
    s
}
