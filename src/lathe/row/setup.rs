//! From the rays of a row, in object space, to a sweep.

use super::bounds::{RowBounds, RowPart};
use super::ray_row::RayRow;
use super::sweep::{Direction, Sweep, TrackedRoot};
use crate::lathe::Lathe;
use crate::lathe::segment::Segment;

impl Lathe {
    /// Sets up the traversal of a part of a row of rays in object space, of which column 0 is counted as 0. A
    /// distance t along a ray is `unit·t` times its direction. `rough` is the size of the numbers as which
    /// the rays' origins were rounded, each by itself, or zero if all rays have one origin.
    #[inline(always)]
    pub(crate) fn sweep(&self, rays: &RayRow, unit: f32, rough: f32, part: &RowPart) -> Sweep<'_> {
        let lathe = self.view();
        let frame = lathe.frame;
        let rays = RayRow {
            origin: frame.squashed(frame.point(rays.origin)),
            origin_step: frame.squashed(rays.origin_step * frame.scale),
            direction: frame.squashed(rays.direction),
            direction_step: frame.squashed(rays.direction_step),
        };
        // About the whole row's center first, whatever part is asked for: so a far eye's distance is rounded
        // in the same way for all parts. Then about the part's own.
        let center = part.center();
        let row_center = 0.5 * part.width as f32 - 0.5;
        let (rays, row_shift) = rays.about(row_center);
        let is_whole = center == row_center;
        let (rays, part_shift) = if is_whole { (rays, 0.0) } else { rays.about(center - row_center) };

        let unit = frame.scale * unit;
        let bounds = RowBounds::new(lathe, &rays, row_shift + part_shift, unit, rough * unit, part);
        let RayRow { origin, origin_step, direction, direction_step } = rays;
        let middle = bounds.middle as f32 - 0.5 - center;
        let (origin, direction) = (origin + origin_step * middle, direction + direction_step * middle);
        let direction = Direction {
            rays: RayRow { origin, origin_step, direction, direction_step },
            is_reversed: false,
            len: part.end - bounds.middle,
        };
        let root = TrackedRoot::none(lathe.segments.first().unwrap_or(&Segment::EMPTY));
        Sweep { bounds, direction, root }
    }
}
