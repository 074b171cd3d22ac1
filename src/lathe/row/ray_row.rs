//! The rays of neighbouring pixels.

use crate::vector::{F32x3, dot};

/// The rays of a row of pixels. The ray of pixel i has origin `origin + i·origin_step` and direction
/// `direction + i·direction_step`; i counts from any point of the row, so that it need not be whole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayRow {
    pub origin: F32x3,
    pub origin_step: F32x3,
    pub direction: F32x3,
    pub direction_step: F32x3,
}

impl RayRow {
    /// The same rays counted backwards: pixel i is what pixel −i was.
    pub fn reversed(&self) -> Self {
        Self { origin_step: self.origin_step * -1.0, direction_step: self.direction_step * -1.0, ..*self }
    }

    /// The same rays counted from pixel i, with other origins, and a number. Each origin is moved along its
    /// ray by that number times the ray's direction, so that pixel i's origin comes to where its ray is
    /// nearest to zero.
    #[inline(always)]
    pub fn about(&self, i: f32) -> (Self, f32) {
        let (o, d) = self.at(i);
        let shift = -dot(o, d) / dot(d, d);
        let origin_step = self.origin_step + self.direction_step * shift;
        (Self { origin: o + d * shift, origin_step, direction: d, ..*self }, shift)
    }

    /// The origin and the direction of pixel i's ray.
    #[inline]
    pub fn at(&self, i: f32) -> (F32x3, F32x3) {
        (self.origin + self.origin_step * i, self.direction + self.direction_step * i)
    }
}
