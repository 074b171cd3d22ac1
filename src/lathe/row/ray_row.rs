//! The rays of neighbouring pixels.

use crate::vector::F32x3;

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

    /// Origin and direction of pixel i.
    #[inline]
    pub fn at(&self, i: f32) -> (F32x3, F32x3) {
        (self.origin + self.origin_step * i, self.direction + self.direction_step * i)
    }
}
