//! Whether a root is a ray's first: whether g keeps its sign all along the ray before it.
//!
//! An entering root's own slope tells, most often. With A = dg/ds there, no more than J turned at the kinks of
//! what the ray may have passed before it, and `g″ ≤ 2K` between kinks, x before the root
//!
//! `g ≤ −(A − J)·x + K·x²`, K = bulge·dz² − q, J = kinks·|dz|,
//!
//! with the bounds of [`Cover`](super::segment::Cover). That is negative for good where `K ≤ 0 < A − J`: one
//! comparison a pixel. Where K is positive it is as far as `x = (A − J)/K`, and farther off the ray must be
//! outside the cylinder of what it may have passed. Where that does not tell either, or the root leaves, its
//! ray's cubic in each segment before does.

use super::bound::most;
use super::path::{Path, flat};
use super::sweep::Sweep;
use crate::cubic::Cubic;
use crate::math::order::greater;
use crate::vector::F32x3;

impl Sweep<'_> {
    /// Whether g is negative all along the ray before a root of the given slope, though K is positive; `b` is
    /// half the slope of x² + y² there, f the squared radius.
    #[inline(always)]
    pub(super) fn is_first(&self, slope: f32, b: f32, f: f32, d: F32x3) -> bool {
        let (a, k) = (slope - self.j, self.k);
        let is_beyond = || (self.reach - f) * (k * k) <= a * (a * flat(d, d) - 2.0 * b * k);
        k > 0.0 && a > self.slack && b < 0.0 && is_beyond()
    }

    /// The same, segment by segment, of a root that enters or leaves. One that leaves must come through an
    /// open end: then g is positive before it.
    #[inline(never)]
    pub(super) fn is_first_by_segments(&self, i: u32, s: f32) -> bool {
        let (m, d) = self.rays.at(i);
        let path = Path::about(m, d, 0.0, 1.0);
        let (up, sign) = (path.rises(), self.sign);

        // In its own segment g(s − x) = −x·(A − c2·x + c3·x²): the bracket is positive where x ends, and at
        // its vertex if that is between.
        let [_, a, c2, c3] = path.g_about(self.segment, s).c.map(|c| sign * c);
        let l = s - greater(-self.span, path.slab(self.segment.low, self.segment.high).0);
        let has_vertex = c2 > 0.0 && c3 > 0.0 && c2 < 2.0 * c3 * l;
        if !(a > self.slack && a + (c3 * l - c2) * l > self.doubt && (!has_vertex || c2 * c2 < 4.0 * a * c3))
        {
            return false;
        }

        let mut index = self.index;
        loop {
            index = if up { index.wrapping_sub(1) } else { index + 1 };
            let Some(segment) = self.lathe.segments.get(index) else {
                break;
            };
            let (from, to) = path.slab(segment.low, segment.high);
            let from = greater(-self.span, from);
            let cover = if up { segment.below } else { segment.above };
            if sign > 0.0 && cover.reach - path.around(path.closest(-self.span, to)).0 < -self.doubt {
                return true;
            }
            let at = path.closest(from, to);
            let g = Cubic::new(path.g_about(segment, at).c.map(|c| sign * c));
            if !(most(&g, at - from, to - at) < -self.doubt) {
                return false;
            }
        }
        let end = if up { self.lathe.frame.base } else { self.lathe.frame.top };
        sign > 0.0 || end.is_none()
    }
}
