//! From the rays of a picture to the sweep of a part of one of its rows.

use super::bounds::{RowBounds, RowPart};
use super::grid::{CameraRays, RayGrid};
use super::ray_row::RayRow;
use super::sweep::{Direction, Sweep, TrackedRoot};
use crate::arithmetic::Flat;
use crate::lathe::Lathe;

impl<S: ?Sized> Lathe<S> {
    /// The rays of a picture, or of one row of it, in the lathe's frame.
    #[inline]
    pub(crate) const fn grid(&self, rays: &CameraRays) -> RayGrid {
        RayGrid::new(&self.frame, rays)
    }
}

impl Lathe {
    /// Sets up the traversal of a part of a row of rays, at its right half. `grid` is one that
    /// [`Lathe::grid`] of this lathe returned: that of one row, or of a picture, of which the row j, counted
    /// downwards from the middle, is to be swept, unless its plane [passes](RayGrid::passes_by) the lathe by.
    #[inline]
    pub(crate) fn sweep(&self, grid: &RayGrid, j: Option<f32>, part: &RowPart) -> Sweep<'_> {
        let lathe = self.view();
        let (bounds, rays) = RowBounds::new(lathe, grid, j, part);
        // Counted from the left edge of the right half's first pixel.
        let (mut origin, mut direction) = (rays.origin, rays.direction);
        // In a mirrored row that edge is the part's middle.
        if !bounds.is_mirrored {
            (origin, direction) = rays.at(bounds.middle as f32 - 0.5 - part.center());
        }
        let rays = RayRow { origin, direction, ..rays };
        let numbers = bounds.numbers.rays(
            (origin, direction),
            (rays.origin_change(), rays.direction_change()),
            part.end - part.start,
            &bounds.limits(),
        );
        let direction = Direction { rays, numbers, is_reversed: false, len: part.end - bounds.middle };
        let root = TrackedRoot::none();
        Sweep { bounds, direction, root, flat: Flat::default() }
    }
}
