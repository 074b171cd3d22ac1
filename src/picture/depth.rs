//! Which of several solids, or of a body's sheets, a pixel shows if no plane separates them: the nearest, by
//! the distances that their sweeps find.

use super::solid_row::{SolidRays, SolidRow};
use crate::math::cold_path;
use crate::math::minmax::{greater, lesser};
use crate::occlusion::PaintOrder;
use crate::solid::Solid;

/// The distance at which a ray meets a solid: the ray's t.
#[derive(Clone, Copy)]
pub(super) enum Distance {
    /// As a sweep finds it, to within [`Sweep::depth_error`](crate::lathe::Sweep::depth_error).
    Swept(f32),
    /// As a single ray finds it.
    Cast(f32),
}

/// What decides whether a pixel shows the solid that is being painted, or what was painted before.
pub(super) trait Depth {
    /// Whether distances are used. If not, [`Depth::shows`] ignores its `distance`.
    const COUNTS: bool;

    /// To be called before the pixels of each solid: takes note of how exact the distances of its sweep are.
    fn begin(&mut self, along: &SolidRow);

    /// Whether a pixel shows the solid, of which its ray sees a point at `distance`. `at` is the pixel's
    /// index in the run that is painted on. If it does, the solid counts as the nearest at this pixel from
    /// here on.
    fn shows(&mut self, rays: &SolidRays, at: usize, column: u32, distance: Distance) -> bool;
}

/// No solid that was painted before hides this one: every pixel that sees it shows it.
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

/// The distances of what was painted before, for each pixel of a run.
pub(super) struct Depths<'a> {
    /// The distance of the nearest solid so far. It is positive if a sweep has found it, negated if single
    /// rays have, and infinite if there is none.
    pub nearest: &'a mut [f32],
    /// The solids of the scene. In `order`, those ranked from `first` to before `rank` have been painted, and
    /// the one ranked `rank` is being painted.
    pub solids: &'a [Solid<'a>],
    pub order: &'a PaintOrder,
    pub first: usize,
    pub rank: usize,
    /// A bound of the error of any distance that a sweep has found, for this solid and those before it.
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
    /// Does what [`Depth::shows`] does where the two distances are too close for their errors: it compares
    /// those that single rays find. If they are equal, the pixel shows what was painted before, which is the
    /// first in the slice.
    ///
    /// Afterwards the pixel's distance is one that single rays have found. So if another solid comes as near
    /// at this pixel, no rays are cast again at the solids before it.
    #[cold]
    #[inline(never)]
    fn compare(&mut self, rays: &SolidRays, at: usize, column: u32, distance: Distance) -> bool {
        let Some(nearest) = self.nearest.get_mut(at) else {
            return false;
        };
        let t = match distance {
            Distance::Cast(t) => t,
            Distance::Swept(_) => rays.distance(column),
        };
        let mut before = -*nearest;
        if before < 0.0 {
            before = rays.distance_before(column);
            let ranks = self.first..self.rank;
            for solid in ranks.filter_map(|rank| self.solids.get(self.order.index(rank))) {
                before = lesser(before, rays.distance_of(solid, column));
            }
        }
        *nearest = -lesser(before, t);
        t < before
    }
}
