//! The rays of neighbouring pixels.

use crate::vector::{F32x3, sum_scaled};

/// The rays of a row of pixels. The ray of pixel i has origin `origin + i·origin_change` and direction
/// `direction + i·direction_change`; i counts from any point of the row, so that it need not be whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayRow {
    pub origin: F32x3,
    pub origin_change: F32x3,
    pub direction: F32x3,
    pub direction_change: F32x3,
}

impl RayRow {
    /// Counts the rays backwards: pixel i is what pixel −i was.
    pub fn reverse(&mut self) {
        self.origin_change *= -1.0;
        self.direction_change *= -1.0;
    }

    /// The origin and the direction of pixel i's ray.
    #[inline(always)]
    pub fn at(&self, i: f32) -> (F32x3, F32x3) {
        (sum_scaled(self.origin, self.origin_change, i), sum_scaled(self.direction, self.direction_change, i))
    }
}
