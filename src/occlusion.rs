//! Which solids may hide which: far ones are painted before near ones.
//!
//! Where a plane parts two of them, with the eye on one side, the far one never hides the near one. Only if there is none
//! must pixels ask which is nearer.

use crate::camera::{Camera, Projection};
use crate::math::{Math, Native};
use crate::scene::Scene;
use crate::solid::Solid;
use crate::vector::{F32x3, dot};
use core::{ptr, slice};

/// What rounding may do to the distance between two solids, and more: one may stand on the other.
const WIDER: f32 = 1.0 + 1.0 / 65_536.0;

/// As far away as parallel rays come from.
const FAR: f32 = 1_048_576.0;

impl Solid<'_> {
    /// How far the cylinder around it reaches from its centre in a direction, times the length of that.
    #[inline(never)]
    fn reach(&self, n: F32x3) -> f32 {
        let (half_height, radius) = self.cylinder();
        let along = dot(n, self.axis());
        let across = n - self.axis() * along;
        half_height * along.abs() + radius * Native::sqrt(dot(across, across))
    }
}

impl Scene<'_> {
    /// The solids that a solid, painted after all that are farther, must be compared with: it alone, or, if one of those may
    /// yet hide it, all.
    #[inline(never)]
    pub(crate) fn among<'s>(&'s self, solid: &'s Solid) -> &'s [Solid<'s>] {
        let distance = self.camera.distance(solid);
        let may_hide = |far: &Solid| {
            !ptr::eq(far, solid)
                && self.camera.distance(far) >= distance
                && !self.camera.sees_behind(far, solid)
        };
        if self.solids.iter().any(may_hide) { self.solids } else { slice::from_ref(solid) }
    }
}

impl Camera {
    /// How far away the far end of a solid is, in numbers that grow with that: so that one within another's cylinder is
    /// painted after it, and of the two the small one asks.
    #[inline(never)]
    pub(crate) fn distance(&self, solid: &Solid) -> u32 {
        let away = solid.centre() - self.eye;
        (Native::sqrt(dot(away, away)) + solid.cylinder().1).to_bits()
    }

    /// Whether no ray can meet the far solid before the near one: whether there is a plane between them, with the eye on
    /// the near one's side.
    #[inline(never)]
    pub(crate) fn sees_behind(&self, far: &Solid, near: &Solid) -> bool {
        let (far_centre, radius) = (far.centre(), far.cylinder().1);
        let between = far_centre - near.centre();
        let radii = radius + near.cylinder().1;
        let away = match self.projection {
            Projection::Perspective => far_centre - self.eye,
            Projection::Orthographic => self.forward * (FAR * radii),
        };
        // A plane along the far one's axis, one across it, and one through the eye, each across the way between as far as
        // can be.
        let axial = far.axis() * dot(between, far.axis());
        let flat = between - axial;
        let view = away - between * (radius / radii);
        let beside = flat - view * (dot(flat, view) / dot(view, view));
        [flat, axial, beside].into_iter().any(|n| {
            let reach = far.reach(n);
            WIDER * dot(between, n) > reach + near.reach(n) && dot(away, n) > reach
        })
    }
}
