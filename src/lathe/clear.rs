//! Runs of pixels that see nothing: how high g comes along one ray, and for how many more that will do.

use super::bound::{highest, most};
use super::path::{Path, flat};
use super::sweep::Sweep;
use crate::cubic::Cubic;
use crate::math::order::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::F32x3;

/// How high g comes along a ray.
pub(super) struct Crest {
    /// A bound on it.
    pub g: f32,
    /// The segment and the place where it may come to zero, and whether from below, 1, or from above, −1.
    pub entry: Option<(usize, f32, f32)>,
}

impl Sweep<'_> {
    /// A bound on g, or on its negative, along a ray between two points of it, by the cubics of the segments.
    #[inline(never)]
    pub(super) fn crest(&self, path: &Path, sign: f32, (near, far): (f32, f32)) -> Crest {
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
                most_here = most(&g, at - from, to - at);
                if !(most_here < -self.doubt) && crest.entry.is_none() {
                    let sign = if g.at(from - at) > 0.0 { -1.0 } else { 1.0 };
                    let s = at + zero(&g, sign);
                    if sign > 0.0 || s <= to {
                        crest.entry = Some((index, greater(from, s), sign));
                    }
                }
            }
            crest.g = greater(most_here, crest.g);
            if !(to < far) {
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
        // The left half begins where the right one did.
        if i > 0 || self.entry.is_none() {
            let ray = self.ray(i);
            let path = self.path(ray);
            // Level with an end's plane, it may meet the rim.
            if (path.z.abs() - self.lathe.frame.high).abs() + path.dz.abs() < self.doubt {
                return i;
            }
            let reach = self.reach(&path);
            let crest = self.crest(&path, 1.0, reach);
            if crest.g < -self.doubt {
                let clear = Pace::of(self, ray, path.per_dz, reach).pixels(1.0, -crest.g - self.doubt);
                return (i + 1).saturating_add(clear);
            }
            self.entry = crest.entry;
        }
        if let Some((index, s, sign)) = self.entry {
            self.begin(index, s, sign);
        }
        i
    }
}

/// How fast g grows from pixel to pixel at the heights of one ray.
///
/// At a height, the point that a ray has there moves along a line as the pixel's number grows, the row of rays'
/// own at that height, and always the same way; g is what F is there less the square of its distance from the
/// axis. So g grows as far as the pixel whose ray is nearest to the axis there, slower and slower, and falls
/// from there on.
pub(super) struct Pace {
    /// How far the point at the height of s moves, `v0 + v1·s`.
    v: [F32x3; 2],
    /// The derivative of g by the pixel's number there, `p0 + p1·s + p2·s²`.
    p: [f32; 3],
    /// The heights are those of s from here to there.
    from: f32,
    to: f32,
    /// By what part of itself dz falls from pixel to pixel, or, negative, grows.
    turn: f32,
    /// One over the number of pixels for which the rays go on rising or falling, no less than 7/8 as steeply, and come to
    /// a height by no more than four spans elsewhere.
    level: f32,
}

impl Pace {
    /// From the i-th ray on, at the heights that it has between two points.
    pub fn of(sweep: &Sweep, (m, d): (F32x3, F32x3), per_dz: f32, (from, to): (f32, f32)) -> Self {
        let (m1, d1) = (sweep.rays.origin_step, sweep.rays.direction_step);
        // The point of height z moves by as much as the ray does, and along it so far that z stays.
        let per_dz = if sweep.drift > 0.0 { per_dz } else { 0.0 };
        let turn = -d1.z * per_dz;
        let level = greater(sweep.drift * per_dz.abs(), 8.0 * turn);
        let (v0, v1) = (m1 - d * (m1.z * per_dz), d1 - d * (d1.z * per_dz));
        let p = [flat(m, v0), flat(m, v1) + flat(d, v0), flat(d, v1)].map(|p| -2.0 * p);
        Self { v: [v0, v1], p, from, to, turn, level }
    }

    /// At the height of s.
    fn at(&self, s: f32) -> f32 {
        let [p0, p1, p2] = self.p;
        (p2 * s + p1) * s + p0
    }

    /// The square of how far the point at the height of s moves.
    fn square_at(&self, s: f32) -> f32 {
        let [v0, v1] = self.v;
        let v = v0 + v1 * s;
        flat(v, v)
    }

    /// The greatest of it, or of its negative.
    #[inline]
    fn most(&self, sign: f32) -> f32 {
        let [_, p1, p2] = self.p;
        let (from, to) = (self.from, self.to);
        sign * self.at(from) + highest(sign * (p1 + 2.0 * p2 * from), sign * p2, 0.0, to - from)
    }

    /// How many pixels there are before g, `room` below zero now, or, for −1, above, can have come to zero anywhere.
    ///
    /// In n of them it grows by n times its pace, or less; it falls by as much, and by n² times the square of how far
    /// the point moves, v². Where dz turns, n of them move the points as far as `n/(1 − n·turn)` did at the pace of the
    /// first.
    pub fn pixels(&self, sign: f32, room: f32) -> u32 {
        let pace = self.most(sign);
        let square =
            if sign < 0.0 { greater(self.square_at(self.from), self.square_at(self.to)) } else { 0.0 };
        // One over the n that takes all the room, nothing if there is no end of room.
        let rate = (pace + Native::sqrt(pace * pace + 4.0 * square * room)) / (2.0 * room);
        (1.0 / greater(self.level, rate + self.turn)) as u32
    }
}

/// Where the parabola of a cubic's first terms comes above zero, or, for −1, below, if it does and opens downwards.
fn zero(g: &Cubic, sign: f32) -> f32 {
    let [c0, c1, c2, _] = g.c;
    (sign * Native::sqrt(c1 * c1 - 4.0 * c2 * c0) - c1) / (2.0 * c2)
}
