//! From the rays of a row, in object space, to a sweep.

use super::bounds::{RowBounds, RowPart};
use super::ray_row::RayRow;
use super::sweep::{Direction, Sweep, TrackedRoot};
use crate::arithmetic::Flat;
use crate::lathe::Lathe;
use crate::lathe::segment::Segment;

impl Lathe {
    /// Sets up the traversal of a part of a row of rays, at its right half. The rays are given in object
    /// space; pixel i of `rays` is column i of the row. The point of a ray at distance t is its origin plus
    /// `unit·t` times its direction. `rough` is an upper bound of |x| + |y| + |z| over the origins of the
    /// rays, measured in the world, where each of them was rounded by itself; it is zero if all rays have the
    /// same origin.
    #[inline(always)]
    pub(crate) fn sweep(&self, rays: &RayRow, unit: f32, rough: f32, part: &RowPart) -> Sweep<'_> {
        let lathe = self.view();
        let frame = lathe.frame;
        let mut rays = RayRow {
            origin: frame.point(rays.origin),
            origin_change: frame.squashed(rays.origin_change * frame.scale),
            direction: frame.squashed(rays.direction),
            direction_change: frame.squashed(rays.direction_change),
        };
        // The rays are counted from the whole row's center first, whatever part is asked for, so that the
        // distance of a far eye is rounded in the same way for all parts. Then they are counted from the
        // part's own center.
        let center = part.center();
        let row_center = 0.5 * part.width as f32 - 0.5;
        let (mut shift, mut from, mut to) = (0.0, 0.0, row_center);
        loop {
            shift += rays.center_on(to - from);
            if to == center {
                break;
            }
            (from, to) = (to, center);
        }

        let unit = frame.scale * unit;
        let mut bounds = RowBounds::new(lathe, &rays, shift, unit, rough * unit, part);
        if bounds.start > f32::NEG_INFINITY {
            // Rounding must not decide on which side of the plane of an end or of a step the rays begin.
            let height = rays.origin.z + bounds.start * rays.direction.z;
            bounds.is_usable &= !lathe.is_near_edge(height, bounds.tolerance);
        }
        let (origin, direction) = rays.at(bounds.middle as f32 - 0.5 - center);
        let RayRow { origin_change, direction_change, .. } = rays;
        let rays = RayRow { origin, origin_change, direction, direction_change };
        let numbers = bounds.numbers.rays(
            (origin, direction),
            (origin_change, direction_change),
            part.end - part.start,
        );
        let direction = Direction { rays, numbers, is_reversed: false, len: part.end - bounds.middle };
        let root = TrackedRoot::none(lathe.segments.first().unwrap_or(&Segment::EMPTY));
        Sweep { bounds, direction, root, flat: Flat::default() }
    }
}
