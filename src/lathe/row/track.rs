//! A root, followed from ray to ray: the innermost loop.

use super::sweep::Sweep;
use crate::math::cold_path;
use crate::math::minmax::greater;
use crate::vector::dot_xy;
use crate::vector::{F32x3, vector};

/// How often Newton's method, or a change of segment, is tried before the ray goes alone.
pub(super) const STEPS: u32 = 4;

/// For how many pixels rays may be added up, and so how many are followed in one go.
pub(super) const FRESH: u32 = 64;

/// Why a root is followed no farther.
pub(crate) enum Stop {
    /// So far, and no farther, was asked for.
    End,
    /// It is not known to be the first.
    Uncertain,
    /// It has left the segment for the one so many farther up.
    Left(usize),
    /// There is none.
    Lost,
}

impl Sweep<'_> {
    /// The pixel as far as which the root, if there is one, can be followed from the i-th.
    #[inline(always)]
    pub fn followed(&self, i: u32) -> Option<u32> {
        self.following.then(|| (i + FRESH.min(self.end - i)).min(self.first.until))
    }

    /// Follows the root from the i-th pixel on, up to another, and hands over where on the wall each is. The first pixel
    /// that it is not certain of, if any, is the one returned.
    #[inline(always)]
    pub fn follow(&mut self, mut i: u32, to: u32, mut see: impl FnMut(F32x3)) -> (u32, Stop) {
        let segment = self.segment;
        // A root that leaves is one that enters if the ray is turned round. In the mirror, too, y is the other way: then the
        // normal is that of the other side.
        let sign = self.sign;
        let point = |p: F32x3, low: f32| vector([p.x, sign * p.y, (p.z - low) * segment.per_height]);
        let toward = |d: F32x3| vector([sign * d.x, d.y, d.z * (sign * segment.per_height)]);
        let (m, d) = self.ray(i);
        let (mut m, mut d) = (point(m, segment.low), toward(d));
        let (m1, d1) = (point(self.rays.origin_step, 0.0), toward(self.rays.direction_step));
        let [c0, c1, c2, c3] = segment.f;
        let certain = self.first.slope;
        let tolerance = self.tolerance;
        // At the solid's ends roots are in doubt.
        let pad = self.doubt * segment.per_height;
        let from = if self.index == 0 { pad } else { 0.0 };
        let to_end = if self.index + 1 == self.lathe.segments.len() { pad } else { 0.0 };
        let width = greater(0.0, 1.0 - from - to_end).to_bits();
        let (mut s, mut step, mut bend) = (self.s, self.step, self.bend);
        let start = i;

        let mut stop = Stop::End;
        'pixels: while i < to {
            let guess = s;
            let mut tries = STEPS;
            loop {
                let (x, y, u) = (m.x + s * d.x, m.y + s * d.y, m.z + s * d.z);
                let c3u = c3 * u;
                let p2 = c3u + c2;
                let p1 = p2 * u + c1;
                let f = p1 * u + c0;
                let f1 = (c3u + p2) * u + p1;
                let b = x * d.x + y * d.y;
                let steep = f1 * d.z - (b + b);
                let back = (f - (x * x + y * y)) / steep;
                s -= back;
                if !(back * back <= tolerance * steep) {
                    cold_path();
                    tries -= 1;
                    if tries == 0 || !(steep > 0.0) {
                        stop = Stop::Lost;
                        break 'pixels;
                    }
                    continue;
                }
                let (x, y, u) = (x - back * d.x, y - back * d.y, u - back * d.z);
                if (u - from).to_bits() > width {
                    stop = Stop::Left(if u > 0.5 { 1 } else { usize::MAX });
                    break 'pixels;
                }
                if !(steep > certain || self.is_first_by_cubic(u, steep, back, dot_xy(d, d), d.z)) {
                    stop = Stop::Uncertain;
                    break 'pixels;
                }
                see(vector([x, y, u]));
                break;
            }
            // As far again, and by how much that grew again.
            bend += s - guess;
            step += bend;
            s += step + bend;
            m += m1;
            d += d1;
            i += 1;
        }
        (self.s, self.step, self.bend) = (s, step, bend);
        if i > start {
            self.tries = STEPS;
        }
        (i, stop)
    }

    /// Where a root is followed no farther, it may still be certain: in the next segment, or by a look at what comes before.
    #[inline(never)]
    pub fn stopped(&mut self, i: u32, stop: Stop) {
        self.tries -= 1;
        let step = match stop {
            Stop::End if i < self.first.until => return,
            Stop::Lost => {
                self.following = false;
                return;
            }
            Stop::Uncertain => None,
            Stop::End => Some(0),
            Stop::Left(step) => Some(step),
        };
        let may_be =
            step.filter(|_| self.tries > 0).is_some_and(|step| self.enter(self.index.wrapping_add(step)));
        if !(may_be && self.certify(i)) {
            // Looking would find the same root.
            (self.following, self.looked) = (false, i);
        }
    }
}
