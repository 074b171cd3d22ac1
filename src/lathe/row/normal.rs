//! What a ray sees where it meets the surface: a normal.

use crate::lathe::segment::Segment;
use crate::math::rsqrt;
use crate::vector::{F32x3, Vector, vector};

/// A visible sample of the surface.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    /// A vector of any length along the surface normal, on the side that is seen, in object space.
    pub gradient: F32x3,
    /// One over the length of `gradient`.
    pub per_length: f32,
}

impl Seen {
    /// The sample whose normal points along `gradient`. The square of that must be a normal number: positive,
    /// and neither subnormal nor infinite.
    #[inline(always)]
    pub fn new(gradient: F32x3) -> Self {
        Self { gradient, per_length: rsqrt(gradient.dot(gradient)) }
    }

    /// The sample as pairs of numbers. A function that is not inlined takes such pairs in registers. A sample
    /// it would take by reference: then the loop would store each sample on the stack, whether it makes the
    /// call or not.
    #[inline(always)]
    pub fn pairs(&self) -> [(f32, f32); 2] {
        let Self { gradient: F32x3 { x, y, z }, per_length } = *self;
        [(x, y), (z, per_length)]
    }

    /// The sample of these [`pairs`](Seen::pairs).
    #[inline(always)]
    pub fn of_pairs([(x, y), (z, per_length)]: [(f32, f32); 2]) -> Self {
        Self { gradient: vector([x, y, z]), per_length }
    }

    /// The sample of a cap or a ring, seen from above if `up` is 1, and from below if it is −1: its normal
    /// points to the side from which it is seen.
    #[inline(always)]
    pub fn flat(up: f32) -> Self {
        Self { gradient: vector([0.0, 0.0, up]), per_length: 1.0 }
    }
}

/// What the normals of a segment's wall are computed from, at the points of a tracked root.
pub(super) struct Wall {
    /// √k times the root's sign.
    signed_squash: f32,
    /// The coefficients of −½·dF/dz times the root's sign, in powers of u, constant term first.
    e: [f32; 3],
}

impl Wall {
    /// The wall of a segment, seen from outside at a root where rays enter the solid (`sign` is 1), from
    /// inside at one where they leave it (−1). `root_squash` is √k.
    #[inline(always)]
    pub fn new(segment: &Segment, sign: f32, root_squash: f32) -> Self {
        let Segment { per_height, f: [_, c1, c2, c3], .. } = *segment;
        let along = -0.5 * sign * per_height;
        Self { signed_squash: sign * root_squash, e: [along * c1, along * 2.0 * c2, along * 3.0 * c3] }
    }

    /// What is seen at a point of the wall, given its x, scaled by √k, its y times the root's sign, and its
    /// parameter u in the segment.
    ///
    /// Half the gradient of `k·x² + y² − F` in object space is `(k·x, y, −F′/2)`, of which √k·x is the given
    /// x. It points outwards. If the wall is seen from inside, all three components change their signs: those
    /// of x and z because `signed_squash` and `e` contain the root's sign, that of y because `signed_y` does.
    #[inline(always)]
    pub fn seen(&self, x: f32, signed_y: f32, u: f32) -> Seen {
        let [e0, e1, e2] = self.e;
        Seen::new(vector([self.signed_squash * x, signed_y, (e2 * u + e1) * u + e0]))
    }
}
