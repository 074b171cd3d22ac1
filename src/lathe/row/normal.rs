//! What a ray sees where it meets the surface.

use super::sweep::Sweep;
use crate::lathe::segment::Segment;
use crate::math::rsqrt;
use crate::vector::{F32x3, Vector, vector};

/// What a ray sees of the surface.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    /// A vector along the normal of the side that is seen, in object space.
    pub gradient: F32x3,
    /// One over its length.
    pub per_length: f32,
}

impl Seen {
    #[inline(always)]
    pub fn new(gradient: F32x3) -> Self {
        Self { gradient, per_length: rsqrt(gradient.dot(gradient)) }
    }
}

/// A segment's wall, as roots followed along it meet it.
pub(crate) struct Wall {
    root_squash: f32,
    /// Half of −F′.
    e: [f32; 3],
}

impl Wall {
    /// What is seen of it there: across the axis, and so far up the segment.
    #[inline(always)]
    pub fn seen(&self, F32x3 { x, y, z: u }: F32x3) -> Seen {
        let [e0, e1, e2] = self.e;
        Seen::new(vector([self.root_squash * x, y, (e2 * u + e1) * u + e0]))
    }
}

impl Sweep<'_> {
    /// The wall that the root followed is in.
    #[inline(always)]
    pub fn wall(&self) -> Wall {
        let Segment { per_height, f: [_, c1, c2, c3], .. } = *self.segment;
        // Half of −F′, as a gradient has it.
        let along = -0.5 * self.sign * per_height;
        let e = [along * c1, along * 2.0 * c2, along * 3.0 * c3];
        Wall { root_squash: self.sign * self.lathe.frame.root_squash, e }
    }
}
