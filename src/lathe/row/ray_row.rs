//! The rays of neighbouring pixels.

use crate::vector::{F32x3, dot};

/// The rays of a row of pixels, counted from one of them, or from between two: origin and direction are linear in the
/// pixel's number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayRow {
    pub origin: F32x3,
    pub origin_step: F32x3,
    pub direction: F32x3,
    pub direction_step: F32x3,
}

impl RayRow {
    /// The same, counted the other way round.
    pub fn turned(&self) -> Self {
        Self { origin_step: self.origin_step * -1.0, direction_step: self.direction_step * -1.0, ..*self }
    }

    /// The same, counted from pixel i, with every origin moved along its ray to where it is about nearest to zero: pixel i's
    /// exactly so. By how much they are moved, in units of the direction.
    #[inline(always)]
    pub fn about(&self, i: f32) -> (Self, f32) {
        let (o, d) = self.at(i);
        let shift = -dot(o, d) / dot(d, d);
        let origin_step = self.origin_step + self.direction_step * shift;
        (Self { origin: o + d * shift, origin_step, direction: d, ..*self }, shift)
    }

    /// Origin and direction of pixel i.
    #[inline]
    pub fn at(&self, i: f32) -> (F32x3, F32x3) {
        (self.origin + self.origin_step * i, self.direction + self.direction_step * i)
    }
}
