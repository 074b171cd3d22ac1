//! The innermost loop: a root is tracked from ray to ray, predicted from its last changes and corrected by
//! Newton's method. It exists twice, see [`arithmetic`](crate::arithmetic): the same computation, tests
//! and decisions in both.

// One of the two is not used.
#[allow(dead_code)]
mod floats;
#[allow(dead_code)]
mod integers;

use super::sweep::Sweep;
use crate::arithmetic::{Length, Seen};

/// How many pixels at most are tracked in one call.
///
/// From pixel to pixel M and D are changed by an addition. In floats, after 64 additions, they are off by
/// 64·2⁻²⁴ of the solid's size at most, and g by four times that, 2⁻¹⁶, which is a sixteenth of the
/// tolerance. In integers the additions are exact; how far rounding of what is added can move a point is part
/// of the row's slip.
const MOST_PIXELS: u32 = 64;

impl Sweep<'_> {
    /// The pixel before which a call of [`Sweep::track`] that begins with the i-th must end. It is i or less
    /// if the root has no certificate for the i-th pixel.
    #[inline(always)]
    pub(super) fn limit(&self, i: u32) -> u32 {
        (i + MOST_PIXELS.min(self.direction.len - i)).min(self.root.certificate.until)
    }

    /// Tracks the root from the i-th pixel to before pixel `to`, which is at most [`Sweep::limit`]. Calls
    /// `see` for each of these pixels, with what it sees and the s of the root. Returns the first pixel for
    /// which `see` was not called: `to`, or an earlier one if tracking ended there. The reason is noted for
    /// [`Sweep::next`], which returns the span that begins with that pixel.
    #[inline(always)]
    pub fn track(&mut self, i: u32, to: u32, see: impl FnMut(&Seen, Length)) -> u32 {
        let rays = self.direction.numbers;
        self.bounds.numbers.track(self, &rays, i, to, see)
    }
}
