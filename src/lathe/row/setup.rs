//! From the rays of a row, in object space, to a sweep.

use super::bounds::{RowBounds, RowPart};
use super::ray_row::RayRow;
use super::sweep::{Direction, Sweep, TrackedRoot};
use crate::lathe::Lathe;
use crate::lathe::segment::Segment;

impl Lathe {
    /// Sets up the traversal of a part of a row of rays, at its right half. The rays are given in object
    /// space; pixel i of `rays` is column i of the row. The point of a ray at distance t is its origin plus
    /// `unit·t` times its direction. `rough` bounds the sum of the coordinates, in units of t, to which the
    /// origins of the rays were rounded one by one; it is zero if all rays have the same origin.
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
        // The rays are counted from the whole row's center first, whatever part is asked for, so that the
        // distance of a far eye is rounded in the same way for all parts. Then from the part's own center.
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
