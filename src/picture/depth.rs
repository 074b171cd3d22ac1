//! Which of several solids, or of a body's sheets, a pixel shows if no plane separates them: the nearest, by
//! the distances that their sweeps find.
//!
//! A distance is the t at which a pixel's ray meets a sheet. It is exact if a single ray has found it, and
//! known to within [`Sweep::depth_error`] if a sweep has.

use super::brush::Brush;
use super::solid_row::SolidRays;
use crate::color::Paint;
use crate::lathe::{Scale, Sweep};
use crate::math::cold_path;
use crate::math::minmax::{greater, lesser};
use crate::occlusion::PaintOrder;
use crate::solid::Solid;
use core::ptr;

/// The pixels of a run, and for each the distance of what was painted before.
pub(super) struct Depths<'a, C> {
    pub run: &'a mut [C],
    /// The distance of the nearest sheet so far, for each pixel, negated if it is exact; +∞ if there is none.
    nearest: &'a mut [f32],
    block: Block<'a>,
    /// Twice a bound of the error of any distance that a sweep has found, of this sheet and those before it.
    /// Two distances that differ by more are in the order that single rays find.
    margin: f32,
    /// What converts the s of this sheet's sweep to distances.
    pub scale: Scale,
}

/// The solids of the scene, and the order in which those of the block are painted.
#[derive(Clone, Copy)]
pub(super) struct Block<'a> {
    pub solids: &'a [Solid<'a>],
    pub order: &'a PaintOrder,
}

impl<'a, C: Paint> Depths<'a, C> {
    /// The depths of the pixels `run` before a sheet of the block is painted on them. `nearest` is memory for
    /// their distances, each of which must be +∞.
    #[inline(always)]
    pub fn new(run: &'a mut [C], nearest: &'a mut [f32], block: Block<'a>) -> Self {
        Self { run, nearest, block, margin: 0.0, scale: Scale::default() }
    }

    /// Prepares for the pixels of the next sheet: stores what the distances of its sweep are computed from,
    /// and raises the margin to that of this sweep if it is larger.
    pub fn begin(&mut self, sweep: &Sweep) {
        self.margin = greater(self.margin, 2.0 * sweep.depth_error());
        self.scale = sweep.scale();
    }

    /// Returns the pixel `at` if it shows the sheet that is being painted, of which its ray sees a point at
    /// `distance`, which may be exact; then the sheet counts as the nearest at this pixel from here on.
    /// Returns `None` if what was painted before hides that point, or if there is no pixel `at`.
    // In a build for speed the compiler inlines it. In a build for size it is one function for all callers.
    #[inline]
    pub fn shown(&mut self, brush: &Brush, at: usize, distance: f32, is_exact: bool) -> Option<&mut C> {
        let nearest = self.nearest.get_mut(at)?;
        let gap = nearest.abs() - distance;
        if gap > self.margin {
            *nearest = if is_exact { -distance } else { distance };
        } else if gap + self.margin < 0.0 {
            return None;
        } else {
            cold_path();
            if !self.is_nearer(brush, at, distance, is_exact) {
                return None;
            }
        }
        self.run.get_mut(at)
    }

    /// Whether the sheet that is being painted is nearer at the pixel `at` than what was painted before, where
    /// the two distances are closer together than the margin: by single rays, so far as their order is not
    /// certain otherwise. `distance` and `is_exact` are as in [`Depths::shown`]. A distance that
    /// a single ray has found is stored negated, so that no rays are cast again at the sheets painted so far
    /// where a further sheet comes as near. If the two distances are equal, the pixel shows what was painted
    /// before, which is the first in the slice.
    #[cold]
    #[inline(never)]
    fn is_nearer(&mut self, brush: &Brush, at: usize, distance: f32, is_exact: bool) -> bool {
        let (Some(nearest), rays, column) = (self.nearest.get_mut(at), brush.rays, brush.column(at)) else {
            return false;
        };
        let t = if is_exact { distance } else { rays.distance(rays.solid, rays.sheet, column) };
        // A sweep's error is half of the margin.
        if *nearest >= 0.0 && (*nearest - t).abs() <= 0.5 * self.margin {
            *nearest = -self.block.before(rays, column);
        }
        let is_nearer = t < nearest.abs();
        if is_nearer {
            *nearest = -t;
        }
        is_nearer
    }
}

impl Block<'_> {
    /// The distance that single rays find, at a column, of the nearest sheet painted before that which `rays`
    /// are cast at.
    fn before(&self, rays: &SolidRays, column: u32) -> f32 {
        let mut before = f32::INFINITY;
        for rank in self.order.block.. {
            let Some(solid) = self.solids.get(self.order.index(rank)) else { break };
            for sheet in solid.sheets() {
                if ptr::eq(solid, rays.solid) && ptr::eq(sheet, rays.sheet) {
                    return before;
                }
                before = lesser(before, rays.distance(solid, sheet, column));
            }
        }
        before
    }
}
