//! A solid along a row of pixels: its sweep, and the rays that the sweep leaves to be cast one by one.

use crate::camera::{Projection, Row};
use crate::hit::Hit;
use crate::lathe::{RayRow, RowPart, Seen, Sweep};
use crate::occlusion::Painted;
use crate::ray::Ray;
use crate::shade::Views;
use crate::solid::Solid;
use crate::solve::Newton;
use crate::vector::{largest, vector};
use core::ptr;

/// A solid along a part of a row.
pub(super) struct SolidRow<'a> {
    painted: &'a Painted<'a>,
    row: &'a Row<'a>,
    pub views: Views,
    pub sweep: Sweep<'a>,
}

impl<'a> SolidRow<'a> {
    /// Sets up the columns from `start` to before `end` of a row.
    #[inline(never)]
    pub fn new(painted: &'a Painted<'a>, row: &'a Row<'a>, start: u32, end: u32) -> Self {
        let solid = painted.solid;
        let Ray { origin, direction, unit } = solid.ray_into(&row.ray(0));
        let (step, projection) = row.step();
        let (step, none) = (solid.direction_into(step), vector([0.0; 3]));
        let (origin_step, direction_step) = match projection {
            Projection::Perspective => (none, step),
            Projection::Orthographic => (step * unit, none),
        };
        let rays = RayRow { origin, origin_step, direction, direction_step };
        let part = RowPart { width: row.width, start, end, is_shared: painted.candidates.len() > 1 };
        let sweep = solid.lathe().sweep(&rays, unit, row.origin_bound(), &part);
        Self { painted, row, views: Views { first: direction, step: direction_step }, sweep }
    }

    /// Casts the ray of a column, which is that of the i-th pixel or of its mirror image, and tells the sweep
    /// of a hit of its solid. Returns what the ray sees of this solid; `None` if it misses, or if another of
    /// the candidates is nearer, or as near and before this one in the scene.
    #[inline(never)]
    pub fn cast(&mut self, i: u32, column: u32) -> Option<Seen> {
        let Painted { solid, candidates } = *self.painted;
        let ray = self.ray(solid, column);
        let hit = nearest(solid, &ray)?;
        self.sweep.found(i, &hit);
        let mut is_before = true;
        for other in candidates {
            if ptr::eq(other, solid) {
                is_before = false;
            } else if let Some(Hit { t, .. }) = nearest(other, &self.ray(other, column))
                && (t < hit.t || is_before && t == hit.t)
            {
                return None;
            }
        }
        Some(seen(solid, &ray, &hit))
    }

    /// The ray of a column in a solid's own space.
    #[inline(never)]
    fn ray(&self, solid: &Solid, column: u32) -> Ray {
        solid.ray_into(&self.row.ray(column))
    }
}

/// The first hit of a solid by a ray in its own space, by the traversal that a single ray takes, too: what
/// the sweep leaves undecided is decided as by [`Solid::nearest`].
#[inline(never)]
fn nearest(solid: &Solid, ray: &Ray) -> Option<Hit> {
    solid.lathe().nearest_by::<Newton>(ray, 0.0)
}

/// What a ray in a solid's own space sees where it hits it.
#[inline(never)]
fn seen(solid: &Solid, ray: &Ray, hit: &Hit) -> Seen {
    let gradient = solid.lathe().gradient_at(ray.point(hit.t), hit);
    // Of very flat or very tall profiles the gradient's square overflows or vanishes: its largest component
    // becomes 1.
    let side = if hit.enters { 1.0 } else { -1.0 };
    Seen::new(gradient * (side / largest(gradient)))
}
