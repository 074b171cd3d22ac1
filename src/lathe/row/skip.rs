//! Runs of pixels that see nothing: how high g comes along one ray, and for how many more that will do.

use super::sweep::Sweep;
use crate::cubic::{Cubic, quadratic_max_on};
use crate::lathe::ray::LocalRay;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::F32x3;
use crate::vector::dot_xy;

/// How high g comes along a ray.
pub(super) struct Crest {
    /// A bound on it, as far as it is known to be below zero, and where it may not be.
    pub g: f32,
    /// The segment and the place where it may come to zero, and whether from below, 1, or from above, −1.
    pub entry: Option<(usize, f32, f32)>,
}

impl Sweep<'_> {
    /// A bound on g, or on its negative, along a ray between two points of it, by the cubics of the segments, as far as the
    /// first that may bring it to zero.
    #[inline(never)]
    pub(super) fn crest(&self, path: &LocalRay, sign: f32, (near, far): (f32, f32)) -> Crest {
        let segments = self.lathe.segments;
        let mut crest = Crest { g: f32::NEG_INFINITY, entry: None };
        let step = if path.rises() { 1 } else { usize::MAX };
        let mut index = self.lathe.index_at(path.height(near));
        let mut from = near;
        while from <= far
            && let Some(segment) = segments.get(index)
        {
            let (_, to) = path.slab(segment.low, segment.high);
            let to = lesser(far, to);
            let at = path.closest(from, to);
            // As high as it can come in the segment's cylinder, if that tells enough.
            let mut most_here = segment.reach - path.around(at).0;
            if sign < 0.0 || most_here > crest.g && !(most_here < -self.doubt) {
                let g = Cubic::new(path.g_about(segment, at).c.map(|c| sign * c));
                most_here = g.max_on(at - from, to - at);
                if !(most_here < -self.doubt) {
                    let sign = if g.at(from - at) > 0.0 { -1.0 } else { 1.0 };
                    let s = at + zero(&g, sign);
                    if sign > 0.0 || s <= to {
                        crest.entry = Some((index, greater(from, s), sign));
                    }
                }
            }
            crest.g = greater(most_here, crest.g);
            if crest.entry.is_some() || !(to < far) {
                break;
            }
            from = to;
            index = index.wrapping_add(step);
        }
        crest
    }

    /// With no root to follow, the next pixel that may see something, from the i-th on: none before it does. The
    /// i-th itself, if it may; then a root is followed, if it is known where to.
    pub(super) fn clear_until(&mut self, i: u32) -> u32 {
        // The left half begins with the root last looked for, which is mostly that the right one began with.
        if i > 0 || self.entry.is_none() {
            let ray = self.ray(i);
            let path = self.path(ray);
            // Level with an end's plane, it may meet the rim.
            let frame = self.lathe.frame;
            if lesser((path.z - frame.low).abs(), (path.z - frame.high).abs()) + path.dz.abs() < self.doubt {
                return i;
            }
            let reach = self.reach(&path);
            let crest = self.crest(&path, 1.0, reach);
            if crest.g < -self.doubt {
                let clear = self.pixels(&path, ray, 1.0, -crest.g - self.doubt, reach);
                return (i + 1).saturating_add(clear);
            }
            self.entry = crest.entry;
        }
        if let Some((index, s, sign)) = self.entry {
            self.begin(index, s, sign);
        }
        i
    }

    /// How many pixels there are before g, `room` below zero on a ray between two of its points, or, for −1, above, can have
    /// come to zero at any of their heights.
    ///
    /// At a height, the point that a ray has there moves along a line as the pixel's number grows, the row of rays'
    /// own at that height, and always the same way; g is what F is there less the square of its distance from the
    /// axis. So g grows as far as the pixel whose ray is nearest to the axis there, slower and slower, and falls
    /// from there on: in n pixels by n times its pace, less n² times the square of how far the point moves, v².
    #[inline(never)]
    pub(super) fn pixels(
        &self,
        path: &LocalRay,
        (m, d): (F32x3, F32x3),
        sign: f32,
        room: f32,
        (from, to): (f32, f32),
    ) -> u32 {
        let (m1, d1) = (self.rays.origin_step, self.rays.direction_step);
        // The point of height z moves by as much as the ray does, and along it so far that z stays: by `v + v1·x`, x from half
        // way, where the ray has its point p.
        let per_dz = if self.drift > 0.0 { path.per_dz } else { 0.0 };
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (v0, v1) = (m1 - d * (m1.z * per_dz), d1 - d * (d1.z * per_dz));
        let (p, v) = (m + d * middle, v0 + v1 * middle);
        let pace = quadratic_max_on(
            -sign * dot_xy(p, v),
            -sign * (dot_xy(p, v1) + dot_xy(d, v)),
            -sign * dot_xy(d, v1),
            half,
        );
        let square =
            quadratic_max_on(-sign * dot_xy(v, v), -2.0 * sign * dot_xy(v, v1), -sign * dot_xy(v1, v1), half);
        // By what part of itself dz falls from pixel to pixel, or, negative, grows: n of them move the points as far as
        // `n/(1 − n·turn)` did at the pace of the first.
        let turn = -d1.z * per_dz;
        // One over the number of pixels for which the rays go on rising or falling, no less than 7/8 as steeply, and come to
        // a height by no more than four spans elsewhere.
        let level = greater(self.drift * per_dz.abs(), 8.0 * turn);
        // One over the n that takes all the room; nothing, or not a number, if there is no end of room.
        let rate = (pace + Native::sqrt(pace * pace + square * room)) / room;
        (1.0 / greater(level, rate + turn)) as u32
    }
}

/// About where a cubic comes above zero, or, for −1, below: where the parabola of its first terms does, if it does and opens
/// downwards, and two steps of Newton's method on.
fn zero(g: &Cubic, sign: f32) -> f32 {
    let [c0, c1, c2, _] = g.c;
    let mut s = (sign * Native::sqrt(c1 * c1 - 4.0 * c2 * c0) - c1) / (2.0 * c2);
    for _ in 0..2 {
        let (value, slope) = g.with_slope(s);
        s -= value / slope;
    }
    s
}
