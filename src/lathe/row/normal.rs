//! What a ray sees where it meets the surface.

use crate::lathe::segment::Segment;
use crate::math::rsqrt;
use crate::vector::{F32x3, Vector, vector};

/// A visible sample of the surface.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    /// A vector along the normal of the side that is seen, in object space, of any length.
    pub gradient: F32x3,
    /// One over its length.
    pub per_length: f32,
}

impl Seen {
    /// The sample whose normal lies along a vector, whose square must be a normal number.
    #[inline(always)]
    pub fn new(gradient: F32x3) -> Self {
        Self { gradient, per_length: rsqrt(gradient.dot(gradient)) }
    }

    /// A cap, whose normal is that of the upper end (1) or of the lower one (−1).
    #[inline(always)]
    pub fn cap(up: f32) -> Self {
        Self { gradient: vector([0.0, 0.0, up]), per_length: 1.0 }
    }
}

/// The normals of a segment's wall, at points of a tracked root.
pub(super) struct Wall {
    /// The sign of the root's crossing, times √k.
    root_squash: f32,
    /// The powers of u in −½·dF/dz, times the sign.
    e: [f32; 3],
}

impl Wall {
    /// The wall of a segment, as a root that enters (sign 1) or leaves the solid (−1) sees it. `root_squash`
    /// is √k.
    #[inline(always)]
    pub fn new(segment: &Segment, sign: f32, root_squash: f32) -> Self {
        let Segment { per_height, f: [_, c1, c2, c3], .. } = *segment;
        let along = -0.5 * sign * per_height;
        Self { root_squash: sign * root_squash, e: [along * c1, along * 2.0 * c2, along * 3.0 * c3] }
    }

    /// What is seen at a point of the frame with coordinates x (scaled by √k) and `sign·y`, u its parameter
    /// in the segment.
    ///
    /// Half the gradient of `k·x² + y² − F` in object space is `(k·x, y, −F′/2)`; √k·x of it comes from the
    /// frame's x. A root that leaves sees the other side: its gradient has the opposite sign, which the given
    /// y has already.
    #[inline(always)]
    pub fn seen(&self, x: f32, signed_y: f32, u: f32) -> Seen {
        let [e0, e1, e2] = self.e;
        Seen::new(vector([self.root_squash * x, signed_y, (e2 * u + e1) * u + e0]))
    }
}
