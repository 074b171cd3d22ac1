use super::Frame;
use super::path::flat;
use crate::ray::Ray;
use crate::vector::{F32x3, dot};

/// A ray in the lathe's frame, x scaled by √k: there every lathe is round.
///
/// Its own point lies near the solid, so that what follows has the size of the solid however far away the ray comes
/// from.
#[derive(Clone, Copy)]
pub(super) struct Line {
    /// Where the ray is nearest to the frame's origin, but for rounding.
    pub point: F32x3,
    pub direction: F32x3,
    /// dx² + dy².
    pub q: f32,
    /// How far behind the ray's origin the point lies, in units of `direction`.
    pub back: f32,
    /// Distances along the ray, in units of its own direction, are those over this.
    pub unit: f32,
}

impl Line {
    #[inline(always)]
    pub fn new(frame: &Frame, ray: &Ray) -> Self {
        let (o, d) = (frame.squashed(frame.point(ray.origin)), frame.squashed(ray.direction));
        let back = dot(o, d) / dot(d, d);
        Self { point: o - d * back, direction: d, q: flat(d, d), back, unit: frame.scale * ray.unit }
    }
}
