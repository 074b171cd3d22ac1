//! Which of several solids that no plane separates a pixel shows: the nearest, by the distances that their
//! sweeps know.

use super::solid_row::{SolidRays, SolidRow};
use crate::math::cold_path;
use crate::math::minmax::{greater, lesser};
use crate::occlusion::PaintOrder;
use crate::solid::Solid;

/// The distance at which a ray sees a solid, in its t.
#[derive(Clone, Copy)]
pub(super) enum Distance {
    /// As a sweep knows it, to within [`Sweep::depth_error`](crate::lathe::Sweep::depth_error).
    Swept(f32),
    /// As the pixel's own ray has found it.
    Cast(f32),
}

/// What decides whether a pixel shows the solid that is being painted, or what was painted before.
pub(super) trait Depth {
    /// Whether distances count: if not, they need not be right.
    const COUNTS: bool;

    /// Begins with another solid.
    fn begin(&mut self, along: &SolidRow);

    /// Whether the pixel of the given column, number `at` of those that are painted on, shows the solid,
    /// which is that far away. If so it is the nearest from now on.
    fn shows(&mut self, rays: &SolidRays, at: usize, column: u32, distance: Distance) -> bool;
}

/// Nothing that was painted before hides this solid.
pub(super) struct Over;

impl Depth for Over {
    const COUNTS: bool = false;

    #[inline(always)]
    fn begin(&mut self, _: &SolidRow) {}

    #[inline(always)]
    fn shows(&mut self, _: &SolidRays, _: usize, _: u32, _: Distance) -> bool {
        true
    }
}

/// The distances of what was painted before, pixel by pixel.
pub(super) struct Depths<'a> {
    /// As found by a sweep, or, negative, by the pixel's own ray; infinite where there is none.
    pub nearest: &'a mut [f32],
    /// The solids painted on these pixels: those ranked from `first` to before `rank` before, now `rank`.
    pub solids: &'a [Solid<'a>],
    pub order: &'a PaintOrder,
    pub first: usize,
    pub rank: usize,
    /// The largest error of a distance that a sweep found, of this solid and of those before.
    pub error: f32,
}

impl Depth for Depths<'_> {
    const COUNTS: bool = true;

    fn begin(&mut self, along: &SolidRow) {
        self.error = greater(self.error, along.sweep.depth_error());
    }

    #[inline(always)]
    fn shows(&mut self, rays: &SolidRays, at: usize, column: u32, distance: Distance) -> bool {
        let Some(nearest) = self.nearest.get_mut(at) else {
            return false;
        };
        let (Distance::Swept(t) | Distance::Cast(t)) = distance;
        let gap = nearest.abs() - t;
        if gap > 2.0 * self.error {
            *nearest = if let Distance::Cast(t) = distance { -t } else { t };
            return true;
        }
        if gap < -2.0 * self.error {
            return false;
        }
        cold_path();
        self.compare(rays, at, column, distance)
    }
}

impl Depths<'_> {
    /// As [`Depth::shows`], where the distances are too near to each other: by those that the pixel's own ray
    /// finds. Of two at the same distance the one painted before is shown, the first in the slice.
    ///
    /// Then the pixel has a distance that its own ray found: whatever else is near there, the solids before
    /// are cast at once only.
    #[cold]
    #[inline(never)]
    fn compare(&mut self, rays: &SolidRays, at: usize, column: u32, distance: Distance) -> bool {
        let Some(nearest) = self.nearest.get_mut(at) else {
            return false;
        };
        let t = match distance {
            Distance::Cast(t) => t,
            Distance::Swept(_) => rays.distance(None, column),
        };
        let mut before = -*nearest;
        if before < 0.0 {
            before = f32::INFINITY;
            for rank in self.first..self.rank {
                before = lesser(before, rays.distance(self.solids.get(self.order.index(rank)), column));
            }
        }
        *nearest = -lesser(before, t);
        t < before
    }
}
