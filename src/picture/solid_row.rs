//! A solid along a row of pixels: its sweep, and the rays that the sweep leaves to be cast one by one.

use crate::arithmetic::{Seen, Views};
use crate::camera::{Projection, Row};
use crate::hit::Hit;
use crate::lathe::{RayRow, RowPart, Sweep};
use crate::ray::Ray;
use crate::sheet::Sheet;
use crate::solid::Solid;
use crate::solve::Newton;
use crate::vector::vector;

/// A solid along a part of a row.
pub(super) struct SolidRow<'a> {
    pub rays: SolidRays<'a>,
    pub sweep: Sweep<'a>,
}

/// The rays of a row of pixels, cast at a sheet of a solid one by one.
pub(super) struct SolidRays<'a> {
    pub solid: &'a Solid<'a>,
    pub sheet: &'a Sheet<'a>,
    pub row: &'a Row<'a>,
    /// Their directions.
    pub views: Views,
}

impl<'a> SolidRow<'a> {
    /// Sets up the sweep of a solid's sheet along the columns of a row from `start` to before `end`.
    /// `has_depth` is whether distances are compared with those of other sheets and solids.
    #[inline(never)]
    pub fn new(
        solid: &'a Solid<'a>,
        sheet: &'a Sheet<'a>,
        row: &'a Row<'a>,
        (start, end): (u32, u32),
        has_depth: bool,
    ) -> Self {
        let Ray { origin, direction, unit } = ray(solid, row, 0);
        let (change, projection) = row.change();
        let (change, zero) = (solid.direction_into(change), vector([0.0; 3]));
        let (origin_change, direction_change) = match projection {
            Projection::Perspective => (zero, change),
            Projection::Orthographic => (change * unit, zero),
        };
        let rays = RayRow { origin, origin_change, direction, direction_change };
        let part = RowPart { width: row.width, start, end, has_depth };
        let sweep = sheet.lathe().sweep(&rays, unit, row.origin_bound(), &part);
        let views = Views::new(direction, direction_change, end);
        Self { rays: SolidRays { solid, sheet, row, views }, sweep }
    }
}

impl SolidRays<'_> {
    /// Casts the ray of a column, which is that of the i-th pixel or of its mirror image, and tells the sweep
    /// of a hit. Returns what the ray sees of the sheet and at which t; `None` if it misses.
    #[inline(never)]
    pub fn cast(&self, sweep: &mut Sweep, i: u32, column: u32) -> Option<(Seen, f32)> {
        let Self { solid, sheet, .. } = *self;
        let ray = ray(solid, self.row, column);
        // By reference: a copy would stay on the stack.
        let hit = &nearest(sheet, &ray);
        let hit = hit.as_ref()?;
        sweep.found(i, hit);
        Some((seen(sheet, &ray, hit), hit.t))
    }

    /// The t at which a column's ray first meets a sheet of a solid; infinite if it misses.
    #[inline(never)]
    pub fn distance(&self, solid: &Solid, sheet: &Sheet, column: u32) -> f32 {
        let ray = ray(solid, self.row, column);
        nearest(sheet, &ray).map_or(f32::INFINITY, |hit| hit.t)
    }
}

/// The ray of a column of a row in a solid's own space. Not inline: what it computes would stay on the stack
/// of those that cast it.
#[inline(never)]
fn ray(solid: &Solid, row: &Row, column: u32) -> Ray {
    solid.ray_into(&row.ray(column))
}

/// The first hit of a sheet by a ray in its solid's own space, or `None` if it misses. The ray's traversal
/// finds it: so does [`Solid::nearest`] for a body, and for a ray that the fast path leaves undecided.
#[inline(never)]
fn nearest(sheet: &Sheet, ray: &Ray) -> Option<Hit> {
    sheet.lathe().nearest_by::<Newton>(ray, 0.0)
}

/// What a ray in a solid's own space sees where it hits a sheet: the normal on the ray's side, whichever side
/// the material is on.
#[inline(never)]
fn seen(sheet: &Sheet, ray: &Ray, hit: &Hit) -> Seen {
    let side = if hit.enters { 1.0 } else { -1.0 };
    Seen::new(sheet.lathe().gradient(ray, hit) * side)
}
