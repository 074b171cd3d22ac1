//! A solid along a row of pixels: its sweep, and the rays that the sweep leaves to be cast one by one.

use crate::camera::{Projection, Row};
use crate::hit::Hit;
use crate::lathe::{RayRow, RowPart, Seen, Sweep};
use crate::ray::Ray;
use crate::shade::Views;
use crate::solid::Solid;
use crate::solve::Newton;
use crate::vector::vector;

/// A solid along a part of a row.
pub(super) struct SolidRow<'a> {
    pub rays: SolidRays<'a>,
    pub views: Views,
    pub sweep: Sweep<'a>,
}

/// The rays of a row of pixels, cast at a solid one by one.
pub(super) struct SolidRays<'a> {
    solid: &'a Solid<'a>,
    row: &'a Row<'a>,
}

impl<'a> SolidRow<'a> {
    /// Sets up a solid's sweep along the columns of a row from `start` to before `end`. `has_depth` is
    /// whether distances are compared with those of other solids.
    #[inline(never)]
    pub fn new(solid: &'a Solid<'a>, row: &'a Row<'a>, (start, end): (u32, u32), has_depth: bool) -> Self {
        let Ray { origin, direction, unit } = solid.ray_into(&row.ray(0));
        let (step, projection) = row.step();
        let (step, none) = (solid.direction_into(step), vector([0.0; 3]));
        let (origin_step, direction_step) = match projection {
            Projection::Perspective => (none, step),
            Projection::Orthographic => (step * unit, none),
        };
        let rays = RayRow { origin, origin_step, direction, direction_step };
        let part = RowPart { width: row.width, start, end, has_depth };
        let sweep = solid.lathe().sweep(&rays, unit, row.origin_bound(), &part);
        let views = Views { first: direction, step: direction_step };
        Self { rays: SolidRays { solid, row }, views, sweep }
    }

    /// Casts the ray of a column, which is that of the i-th pixel or of its mirror image, and tells the sweep
    /// of a hit. Returns what the ray sees of the solid and at which t; `None` if it misses.
    #[inline(never)]
    pub fn cast(&mut self, i: u32, column: u32) -> Option<(Seen, f32)> {
        let SolidRays { solid, row } = self.rays;
        let ray = solid.ray_into(&row.ray(column));
        let hit = nearest(solid, &ray)?;
        self.sweep.found(i, &hit);
        Some((seen(solid, &ray, &hit), hit.t))
    }
}

impl SolidRays<'_> {
    /// The t at which a column's ray meets a solid first, this one or another; infinite if it misses.
    #[inline(never)]
    pub fn distance(&self, other: Option<&Solid>, column: u32) -> f32 {
        let solid = other.unwrap_or(self.solid);
        nearest(solid, &solid.ray_into(&self.row.ray(column))).map_or(f32::INFINITY, |hit| hit.t)
    }
}

/// The first hit of a solid by a ray in the solid's own space, or `None`. It is found as [`Solid::nearest`]
/// finds it, so that where the sweep is undecided both agree.
#[inline(never)]
fn nearest(solid: &Solid, ray: &Ray) -> Option<Hit> {
    solid.lathe().nearest_by::<Newton>(ray, 0.0)
}

/// What a ray in a solid's own space sees where it hits it.
#[inline(never)]
fn seen(solid: &Solid, ray: &Ray, hit: &Hit) -> Seen {
    let side = if hit.enters { 1.0 } else { -1.0 };
    Seen::new(solid.lathe().gradient(ray, hit) * side)
}
