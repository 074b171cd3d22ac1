//! Which solids may hide which: far ones are painted before near ones.
//!
//! Where a plane parts two of them, with the eye on the near one's side, the far one never hides the near one. Only
//! where none is found must pixels ask which is nearer. Any order is right; a good one is cheap.

use crate::camera::{Camera, Projection};
use crate::math::{Math, Native};
use crate::scene::Scene;
use crate::solid::Solid;
use crate::vector::{F32x3, dot};
use core::{ptr, slice};

/// What rounding may do to a distance: one solid may stand on another, and the eye must not be on a cap's very
/// plane.
const ROUNDING: f32 = 1.0 + 1.0 / 2_097_152.0;

/// Of two solids' radii, squared: so little more is asked for that a normal which is nothing but rounding parts nothing. Its own
/// square may vanish.
const LEAST: f32 = 1e-12;

/// As far away as parallel rays come from, in radii. What counts is only on which side of a plane.
const FAR: f32 = 1_048_576.0;

impl Solid<'_> {
    /// How far the cylinder around it reaches from its centre in a direction, times the length of that.
    #[inline(never)]
    fn reach(&self, n: F32x3) -> f32 {
        let along = dot(n, self.axis());
        let across = n - self.axis() * along;
        self.half_height() * along.abs() + self.radius() * Native::sqrt(dot(across, across))
    }
}

impl Scene<'_> {
    /// The solids that a solid, painted after all that are farther, must be compared with: it alone, or, if one of
    /// those may yet hide it, all.
    #[inline(never)]
    pub(crate) fn among<'s>(&'s self, solid: &'s Solid, distance: u32) -> &'s [Solid<'s>] {
        let may_hide = |far: &Solid| {
            !ptr::eq(far, solid)
                && self.camera.distance(far) >= distance
                && !self.camera.sees_behind(far, solid)
        };
        if self.solids.iter().any(may_hide) { self.solids } else { slice::from_ref(solid) }
    }
}

impl Camera {
    /// How far away a solid is, its radius added, in numbers that grow with that. So of two in one place the one that
    /// is painted last, and must ask, tends to be the smaller.
    #[inline(never)]
    pub(crate) fn distance(&self, solid: &Solid) -> u32 {
        let away = solid.centre_from(self.eye);
        (Native::sqrt(dot(away, away)) + solid.radius()).to_bits()
    }

    /// Whether a plane is found between two solids, with the eye on the near one's side: then no ray meets the far one
    /// first.
    #[inline(never)]
    pub(crate) fn sees_behind(&self, far: &Solid, near: &Solid) -> bool {
        let origin = near.position();
        let between = far.centre_from(origin) - near.centre_from(origin);
        let (radius, away) = (far.radius(), far.centre_from(self.eye));
        let radii = radius + near.radius();
        let least = LEAST * radii * radii;
        let away = match self.projection {
            Projection::Perspective => away,
            Projection::Orthographic => self.forward * (FAR * radii),
        };
        // Normals of planes: across the far one's axis, along it, and across the view of a place between the two.
        let axial = far.axis() * dot(between, far.axis());
        let flat = between - axial;
        let view = away - between * (radius / radii);
        let beside = flat - view * (dot(flat, view) / dot(view, view));
        [flat, axial, beside].into_iter().any(|n| {
            let reach = far.reach(n);
            ROUNDING * dot(between, n) > reach + near.reach(n) + least && dot(away, n) > ROUNDING * reach
        })
    }
}
