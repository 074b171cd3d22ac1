//! The rays of neighbouring pixels.

use crate::vector::{F32x3, scale, sum_scaled};

/// The rays of a row of pixels. The ray of pixel i has origin `origin + i·at·right` and direction
/// `direction + i·apart·right`; i counts from any point of the row, so that it need not be whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayRow {
    pub origin: F32x3,
    pub direction: F32x3,
    pub right: F32x3,
    pub at: f32,
    pub apart: f32,
}

impl RayRow {
    /// Counts the rays backwards: pixel i is what pixel −i was.
    pub fn reverse(&mut self) {
        self.right = scale(self.right, -1.0);
    }

    /// The origin and the direction of pixel i's ray.
    #[inline(always)]
    pub fn at(&self, i: f32) -> (F32x3, F32x3) {
        let Self { origin, direction, right, at, apart } = *self;
        (sum_scaled(origin, right, i * at), sum_scaled(direction, right, i * apart))
    }

    /// By how much the origin changes from pixel to pixel.
    #[inline(always)]
    pub fn origin_change(&self) -> F32x3 {
        scale(self.right, self.at)
    }

    /// By how much the direction changes from pixel to pixel.
    #[inline(always)]
    pub fn direction_change(&self) -> F32x3 {
        scale(self.right, self.apart)
    }
}
