//! Runs of pixels that see nothing: how high g comes along one ray, and for how many more that will do.

use super::bound::{highest, most};
use super::path::{Path, flat};
use super::sweep::Sweep;
use crate::cubic::Cubic;
use crate::math::order::{greater, lesser};
use crate::math::{Math, Native};

/// How high g comes along a ray.
pub(super) struct Crest {
    /// A bound on it.
    pub g: f32,
    /// The segment and the place where it may come above zero.
    pub entry: Option<(usize, f32)>,
}

impl Sweep<'_> {
    /// A bound on g along a ray.
    ///
    /// From one point of it, the one nearest to the axis, if g is concave all along the ray but for kinks:
    /// `g ≤ g₀ + (A ± J)·x + K·x²` (`first.rs`). Otherwise from one point in each segment.
    #[inline(always)]
    pub(super) fn crest(&self, path: &Path) -> Crest {
        let segments = self.lathe.segments;
        let (near, far) = path.slab(self.lathe.frame.low, self.lathe.frame.high);
        let (near, far) = (greater(-self.span, near), lesser(self.span, far));
        let mut crest = Crest { g: f32::NEG_INFINITY, entry: None };
        if !(near < far) {
            return crest;
        }
        let all = self.all();
        let k = all.bulge * (self.steep * self.steep) - self.q;
        if k < -0.5 * self.q {
            let at = path.closest(near, far);
            let index = self.at_height(path.height(at));
            if let Some(segment) = segments.get(index) {
                let g = path.g_about(segment, at);
                let [c0, c1, ..] = g.c;
                let j = all.kinks * self.steep;
                let mut rise = highest(c1 + j, k, 0.0, far - at);
                if c1 < j {
                    rise = greater(rise, highest(c1 - j, k, at - near, 0.0));
                }
                crest.g = c0 + rise;
                if !(crest.g < -self.doubt) {
                    crest.entry = Some((index, greater(near, at + entry(&g))));
                }
            }
            return crest;
        }
        for step in 0..segments.len() {
            let index = if path.rises() { step } else { segments.len() - 1 - step };
            let Some(segment) = segments.get(index) else {
                break;
            };
            let (from, to) = path.slab(segment.low, segment.high);
            let (from, to) = (greater(near, from), lesser(far, to));
            let at = path.closest(from, to);
            if from < to && segment.reach - path.around(at).0 > crest.g {
                let g = path.g_about(segment, at);
                let most = most(&g, at - from, to - at);
                if !(most < -self.doubt) && crest.entry.is_none() {
                    crest.entry = Some((index, greater(from, at + entry(&g))));
                }
                crest.g = greater(crest.g, most);
            }
        }
        crest
    }

    /// The segment at a height, looked for from the last one.
    fn at_height(&self, z: f32) -> usize {
        let segments = self.lathe.segments;
        let mut index = self.index;
        while segments.get(index + 1).is_some_and(|next| next.low < z) {
            index += 1;
        }
        while segments.get(index).is_some_and(|this| z < this.low) && index > 0 {
            index -= 1;
        }
        index
    }

    /// How many pixels after the i-th, whose g is at most `crest`, see nothing either.
    ///
    /// From each to the next g grows by Γ at most, within the span: `F′·∂z/∂i − 2⟨P, ∂P/∂i⟩`. Only at the ends
    /// of the profile there comes to be what was not there; as wide as the ends are it could be.
    #[inline(always)]
    pub(super) fn clear_after(&self, i: u32, path: &Path, crest: f32) -> u32 {
        let ((m, d), span) = (self.rays.at(i), self.span);
        let (m1, d1) = (self.rays.origin_step, self.rays.direction_step);
        let frame = self.lathe.frame;
        let most = span * ((flat(m, d1) + flat(d, m1)).abs() + span * flat(d, d1).abs()) - flat(m, m1);
        let growth = greater(0.0, 2.0 * most) + frame.steepest * self.drift;
        let mut n = (self.end - i).min(((-crest - self.doubt) / growth) as u32);
        let (near, far) = path.slab(frame.low, frame.high);
        while n > 0 && self.drift > 0.0 {
            let width = self.drift * n as f32 * path.per_dz.abs();
            let is_clear = |from, to| {
                let (from, to) = (greater(-span, from), lesser(span, to));
                let square = path.around(path.closest(from, to)).0;
                !(from <= to) || frame.ends - square + growth * (n as f32) < -self.doubt
            };
            if is_clear(near - width, near) && is_clear(far, far + width) {
                break;
            }
            n /= 4;
        }
        n
    }
}

/// Where the parabola of a cubic's first terms comes above zero, if it does.
fn entry(g: &Cubic) -> f32 {
    let [c0, c1, c2, _] = g.c;
    (Native::sqrt(c1 * c1 - 4.0 * c2 * c0) - c1) / (2.0 * c2)
}
