//! The rays of neighbouring pixels.

use crate::vector::{F32x3, dot, sum_scaled};

/// The rays of a row of pixels. The ray of pixel i has origin `origin + i·origin_change` and direction
/// `direction + i·direction_change`; i counts from any point of the row, so that it need not be whole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayRow {
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

    /// Counts the rays from pixel i, and moves each origin along its ray by the same multiple of the
    /// direction, which is returned: the one that brings pixel i's origin to the point of its ray that is
    /// nearest to the origin of the coordinates.
    pub fn center_on(&mut self, i: f32) -> f32 {
        let (o, d) = self.at(i);
        let shift = -dot(o, d) / dot(d, d);
        (self.origin, self.direction) = (o + d * shift, d);
        self.origin_change += self.direction_change * shift;
        shift
    }

    /// The origin and the direction of pixel i's ray.
    #[inline(always)]
    pub fn at(&self, i: f32) -> (F32x3, F32x3) {
        (sum_scaled(self.origin, self.origin_change, i), sum_scaled(self.direction, self.direction_change, i))
    }
}
