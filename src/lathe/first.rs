//! Whether a root is a ray's first: whether g keeps its sign all along the ray before it.
//!
//! An entering root's own slope tells, most often. With A = dg/ds there, no more than J turned at the kinks of
//! what the ray may have passed before it, and `g″ ≤ 2K` between kinks, x before the root
//!
//! `g ≤ −(A − J)·x + K·x²`, K = bulge·dz² − q, J = kinks·|dz|.
//!
//! That is negative where `K ≤ 0 < A − J`: one comparison a pixel, as far back as one segment after another has K ≤ 0.
//!
//! From the first segment back that has K > 0, a look at the ray's cubics tells that g keeps its sign, and for how many
//! pixels more. Is that the root's own, or does the root leave, the look ends where the ray enters the segment, and the
//! segment's cubic tells the rest, pixel by pixel.

use super::clear::Pace;
use super::path::flat;
use super::sweep::Sweep;
use crate::math::order::lesser;
use crate::vector::F32x3;

/// How a root is known to be the first, before the pixel `until`: by its slope, if that is more than `slope`,
/// or, if `by_cubic`, by the cubic in its own segment.
pub(super) struct First {
    pub slope: f32,
    pub by_cubic: bool,
    pub until: u32,
}

impl First {
    /// None is known to be.
    pub const UNKNOWN: Self = Self { slope: f32::INFINITY, by_cubic: false, until: u32::MAX };
}

impl Sweep<'_> {
    /// Whether it is known of the root followed, from the i-th ray's on; how, and as far as which ray, is kept. A root that
    /// leaves must come through an open end: then g is positive before it.
    ///
    /// If its slope is `too_small` for all that it could tell of, it is to tell of the root's own segment only.
    pub(super) fn certify(&mut self, i: u32, too_small: bool) -> bool {
        let is_concave = self.sign > 0.0 && self.segment.bulge <= self.bulge;
        let (mut segment, mut index, mut kinks, mut until) = (self.segment, self.index, 0.0, 0);
        if is_concave
            && !too_small
            && let Some(is_rising) = self.rising
        {
            until = loop {
                let is_all = if is_rising { segment.low <= self.low } else { segment.high >= self.high };
                index = if is_rising { index.wrapping_sub(1) } else { index + 1 };
                let Some(next) = self.lathe.segments.get(index).filter(|_| !is_all) else {
                    break u32::MAX;
                };
                if !(next.bulge <= self.bulge) {
                    break 0;
                }
                kinks += if is_rising { next.kink } else { segment.kink };
                segment = next;
            };
        }
        if until == 0 {
            let (path, sign) = (self.path(i), self.sign);
            let frame = self.lathe.frame;
            let end = if path.rises() { &frame.base } else { &frame.top };
            if sign < 0.0 && end.part.is_some() {
                return false;
            }
            let (near, far) = self.reach(&path);
            let before = (near, lesser(far, path.slab(segment.low, segment.high).0));
            let crest = self.crest(&path, sign, before).g;
            if !(crest < -self.doubt) {
                return false;
            }
            let (pace, room) = (Pace::of(self, i, before), -crest - self.doubt);
            let n = if sign > 0.0 { pace.pixels(room) } else { pace.pixels_within(room) };
            until = i + 1 + n.min(self.end - i);
        }
        let slope = if is_concave { kinks * self.steep + self.slack } else { f32::INFINITY };
        self.first = First { slope, by_cubic: !is_concave, until };
        true
    }

    /// Whether g keeps its sign from where a ray comes to the segment of a root as far as the root, given the root's
    /// u, the slope at so much beyond it as Newton's last step went back, and the ray's D in the segment's u.
    ///
    /// With κ = |du/ds|, A the slope at the root, and y the way back from it in u, of which there is `way`,
    ///
    /// `κ²·g = −y·(A·κ − c2·y + c3·y²)`,
    ///
    /// and the bracket is above doubt where y ends, and at its vertex if that is between.
    #[inline]
    pub(super) fn is_first_by_cubic(&self, u: f32, slope: f32, back: f32, d: F32x3) -> bool {
        let [_, _, f2, f3] = self.segment.f;
        let kappa = d.z.abs();
        let c2 = self.sign * ((3.0 * f3 * u + f2) * (kappa * kappa) - flat(d, d));
        let c3 = self.sign * f3 * (kappa * d.z);
        let way = if d.z > 0.0 { u } else { 1.0 - u };
        let slope = slope - 2.0 * c2 * back;
        let room = (slope - self.doubt) * kappa;
        let has_vertex = c2 > 0.0 && c2 < 2.0 * c3 * way;
        self.first.by_cubic
            && slope > self.slack
            && room > (c2 - c3 * way) * way
            && (!has_vertex || c2 * c2 < 4.0 * room * c3)
    }
}
