//! The innermost loop: a root is tracked from ray to ray, predicted from its last changes and corrected by
//! Newton's method. It exists twice, see [`arithmetic`](crate::arithmetic): the same computation, tests
//! and decisions in both.

// One of the two is not used.
#[allow(dead_code)]
mod floats;
#[allow(dead_code)]
mod integers;

use super::sweep::Sweep;
use crate::arithmetic::{Length, Normal, Numbers};

/// How many pixels at most are tracked in one call where distances are compared. In twice as many the
/// additions of [`Numbers::MOST_PIXELS`] would make twice as large an error of a distance.
const MOST_COMPARED: u32 = 64;

impl Sweep<'_> {
    /// The pixel before which a call of [`Sweep::track`] that begins with the i-th must end. It is i or less
    /// if the root has no certificate for the i-th pixel.
    #[inline(always)]
    pub(super) fn limit(&self, i: u32) -> u32 {
        let most = if self.has_depth() { MOST_COMPARED } else { Numbers::MOST_PIXELS };
        (i + most.min(self.direction.len - i)).min(self.root.certificate.until)
    }

    /// Tracks the root from the i-th pixel to before pixel `to`, which is at most [`Sweep::limit`]. Calls
    /// `see` for each of these pixels, with the normal that it sees and the s of the root. Returns the first
    /// pixel for which `see` was not called: `to`, or an earlier one if tracking ended there. The reason is
    /// noted for [`Sweep::next`], which returns the span that begins with that pixel.
    #[inline(always)]
    pub fn track(&mut self, i: u32, to: u32, see: impl FnMut(&Normal, Length)) -> u32 {
        let rays = self.direction.numbers;
        self.bounds.numbers.track(self, &rays, i, to, see)
    }
}
