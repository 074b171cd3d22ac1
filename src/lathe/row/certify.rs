//! Whether a root is a ray's first: whether g keeps its sign all along the ray before it.
//!
//! An entering root's own slope tells, most often. With A = dg/ds there, no more than J turned at the kinks of
//! what the ray may have passed before it, and `g″ ≤ 2K` between kinks, x before the root
//!
//! `g ≤ −(A − J)·x + K·x²`, K = bulge·dz² − q, J = kinks·|dz|.
//!
//! That is negative where `K ≤ 0 < A − J`: one comparison a pixel, as far back as one segment after another has K ≤ 0.
//! Before a root that leaves, through as many of them, a g that is positive where they begin stays so.
//!
//! That ends with a segment that has K > 0, or a kink that is more than rounding. There a look at the ray's cubics tells
//! that g keeps its sign before, and for how many pixels more.
//!
//! In a root's own segment, whatever its K, g keeps its sign if it has it where the ray comes in, and, going back from the
//! root, does not bend the wrong way first and the right way then: that is for the sign of F‴·dz to tell. Where it may, the
//! slope must be more than `|F‴/6|·h²·|dz|`, h the segment's height, or else the segment's cubic is asked, pixel by pixel.

use super::skip::Crest;
use super::sweep::Sweep;
use crate::lathe::segment::Segment;
use crate::math::minmax::lesser;

/// How a root is known to be the first.
pub(super) struct First {
    /// If its slope is more than this, by that.
    pub slope: f32,
    /// If not, by the cubic in its own segment: c₃, in the segment's u, over that of a ray with du/ds = 1. Zero if that
    /// would not tell more.
    pub bump: f32,
    /// Before this pixel.
    pub until: u32,
}

impl First {
    /// None is known to be.
    pub const UNKNOWN: Self = Self { slope: f32::INFINITY, bump: 0.0, until: u32::MAX };
}

impl Sweep<'_> {
    /// Whether it is known of the root followed, from the i-th ray's on; how, and as far as which ray, is kept.
    pub(super) fn certify(&mut self, i: u32) -> bool {
        let (mut segment, mut index, mut kinks, mut is_all) = (self.segment, self.index, 0.0, false);
        let (enters, is_concave) = (self.sign > 0.0, segment.bulge <= self.bulge);
        let [_, _, _, f3] = segment.f;
        let mut bump = if is_concave { 0.0 } else { f3.abs() };
        if let Some(is_rising) = self.rising {
            if (f3 > 0.0) != (is_rising == enters) {
                bump = 0.0;
            }
            if is_concave || !enters && bump == 0.0 {
                // As far back as g is concave, but for rounding.
                loop {
                    is_all = if is_rising { segment.low <= self.low } else { segment.high >= self.high };
                    index = if is_rising { index.wrapping_sub(1) } else { index + 1 };
                    let Some(next) = self.lathe.segments.get(index).filter(|_| !is_all) else {
                        break;
                    };
                    let passed = kinks + if is_rising { next.kink } else { segment.kink };
                    if !(next.bulge <= self.bulge && passed * self.steep * self.span < 0.25 * self.doubt) {
                        break;
                    }
                    (kinks, segment) = (passed, next);
                }
            }
        }
        let until = if enters && is_all { Some(u32::MAX) } else { self.looked_before(i, segment) };
        let Some(until) = until else {
            return false;
        };
        let slope = (kinks + bump * segment.per_height) * self.steep + self.slack;
        self.first = First { slope, bump, until };
        true
    }

    /// The pixel as far as which g is known to keep its sign before the rays come to a segment, by a look at the i-th. A root
    /// that leaves must come through an open end: then g is positive before it.
    #[inline(always)]
    fn looked_before(&mut self, i: u32, segment: &Segment) -> Option<u32> {
        let ray = self.ray(i);
        let (path, sign) = (self.path(ray), self.sign);
        let frame = self.lathe.frame;
        let end = if path.rises() { &frame.base } else { &frame.top };
        if sign < 0.0 && end.part.is_some() {
            return None;
        }
        let (near, far) = self.reach(&path);
        let far = lesser(far, path.slab(segment.low, segment.high).0);
        // Where that begins, too, however far away, if more than the slope must tell of what follows.
        let by_slope = sign > 0.0 && self.segment.bulge <= self.bulge;
        let before = (if by_slope { near } else { lesser(near, far) }, far);
        let Crest { g, entry } = self.crest(&path, sign, before);
        if g < -self.doubt {
            return Some((i + 1).saturating_add(self.pixels(&path, ray, sign, -g - self.doubt, before)));
        }
        if g < self.doubt {
            return None;
        }
        // An earlier root, or, past a rim, one just behind it. That is followed from here on, as far as no pixel yet.
        let (index, s, turns) = entry.unwrap_or((self.index, far, -1.0));
        let tries = self.tries;
        self.begin(index, s, sign * turns);
        self.tries = tries;
        Some(0)
    }

    /// Whether g keeps its sign from where a ray comes to the segment of a root as far as the root, given the root's
    /// u, the slope at so much beyond it as Newton's last step went back, the ray's q, and its dz in the segment's
    /// u.
    ///
    /// With κ = |du/ds|, A the slope at the root, and y the way back from it in u,
    ///
    /// `κ²·g = −y·(A·κ − c2·y + c3·y²)`,
    ///
    /// and the bracket has no zero on that way.
    #[cold]
    #[inline(never)]
    pub(super) fn is_first_by_cubic(&self, u: f32, slope: f32, back: f32, q: f32, dz: f32) -> bool {
        let [_, _, f2, f3] = self.segment.f;
        let kappa = dz.abs();
        let square = kappa * kappa;
        let curve = (3.0 * f3 * u + f2) * square - q;
        let (c2, slope) = (self.sign * curve, slope - 2.0 * curve * back);
        slope > self.slack && c2 * c2.abs() < 4.0 * (slope - self.doubt) * kappa * (self.first.bump * square)
    }
}
