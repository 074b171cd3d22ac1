//! A solid along a row of pixels: its sweep, and the rays that the sweep leaves to be cast one by one.

use super::aspect::{Aspect, grid, ray};
use crate::arithmetic::{Seen, Views};
use crate::camera::Row;
use crate::hit::Hit;
use crate::lathe::{RowPart, Sweep};
use crate::ray::Ray;
use crate::sheet::Sheet;
use crate::solid::Solid;
use crate::solve::Newton;

/// A sheet of a solid along a part of a row.
pub(super) struct SolidRow<'a> {
    pub rays: SolidRays<'a>,
    pub sweep: Sweep<'a>,
}

/// The rays of a row of pixels, cast at a sheet of a solid one by one.
pub(super) struct SolidRays<'a> {
    pub solid: &'a Solid<'a>,
    pub sheet: &'a Sheet<'a>,
    pub row: &'a Row<'a>,
    /// The directions of these rays; of no use if the solid is matt.
    pub views: Views,
}

impl<'a> SolidRow<'a> {
    /// Sets up the sweep of a solid's sheet along the columns of a row from `start` to before `end`. `kept`
    /// is the sheet's aspect in the picture, if that is known; then the row's plane must not pass the solid
    /// by. `has_depth` is whether distances are compared with those of other sheets and solids.
    #[inline(never)]
    pub fn new(
        solid: &'a Solid<'a>,
        sheet: &'a Sheet<'a>,
        kept: Option<&Aspect>,
        row: &'a Row<'a>,
        (start, end): (u32, u32),
        has_depth: bool,
    ) -> Self {
        let own;
        let (grid, j) = match kept {
            Some(aspect) => (&aspect.grid, Some(row.below_middle())),
            None => {
                own = grid(solid, sheet.lathe(), row, row.y as f32, 0.0);
                (&own, None)
            }
        };
        let columns = RowPart { width: row.width, start, end, has_depth };
        let sweep = sheet.lathe().sweep(grid, j, &columns);
        let views = if solid.shininess() == 0 { Views::NONE } else { grid.views(j, row.width, end) };
        Self { rays: SolidRays { solid, sheet, row, views }, sweep }
    }
}

impl SolidRays<'_> {
    /// Casts the ray of a column, which is that of the i-th pixel or of its mirror image, and tells the sweep
    /// of a hit. Returns what the ray sees of the sheet, at which t, and whether it enters the lathe there;
    /// `None` if it misses.
    #[inline(never)]
    pub fn cast(&self, sweep: &mut Sweep, i: u32, column: u32) -> Option<(Seen, f32, bool)> {
        let Self { solid, sheet, .. } = *self;
        let ray = ray(solid, self.row, column as f32, self.row.y as f32);
        // By reference: a copy would stay on the stack.
        let hit = &nearest(sheet, &ray);
        let hit = hit.as_ref()?;
        sweep.found(i, hit);
        Some((seen(sheet, &ray, hit), hit.t, hit.enters))
    }

    /// The t at which a column's ray first meets a sheet of a solid; infinite if it misses.
    #[inline(never)]
    pub fn distance(&self, solid: &Solid, sheet: &Sheet, column: u32) -> f32 {
        let ray = ray(solid, self.row, column as f32, self.row.y as f32);
        nearest(sheet, &ray).map_or(f32::INFINITY, |hit| hit.t)
    }
}

/// The first hit of a sheet by a ray in its solid's own space, or `None` if it misses. The hit is found by
/// the traversal of segments, as [`Solid::nearest`] finds it for a body, and for a ray that the fast path
/// leaves undecided.
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
