//! A scene as a grid of pixels, by reference: what rows are computed from.

use super::canvas::Canvas;
use super::depth::{Depth, Depths, Over};
use super::solid_row::SolidRow;
use crate::camera::Row;
use crate::color::{Paint, most_shades};
use crate::occlusion::PaintOrder;
use crate::scene::Scene;
use crate::shade::Finish;
use crate::sheet::Sheet;
use crate::solid::Solid;

/// How many pixels are computed at once where the caller lends no memory: `Scene::draw` keeps them on its
/// stack.
///
/// The value is a choice between stack and time. Each solid is set up anew for every run, so that the
/// README's vase, drawn in runs of 40, takes 2.7 times as long as in rows of 240. 40 divides the usual
/// widths, 240 and 320, and is a multiple of 8, the period of the dithering.
pub(crate) const RUN: usize = 40;

/// For how many pixels at most distances are kept in memory at once. This many is a whole row of the usual
/// displays, so that a row is not cut in pieces: if the two halves of a row are mirror images, only one is
/// swept.
const MOST_DEPTHS: usize = 240;

/// A scene, the size of its picture in pixels, and the order in which its solids are painted.
///
/// It borrows what a [`Picture`](super::Picture) owns: a frame that is drawn keeps no copy of the scene on
/// the stack.
#[derive(Clone, Copy)]
pub(crate) struct Raster<'a> {
    pub scene: &'a Scene<'a>,
    pub order: &'a PaintOrder,
    pub width: u32,
    pub height: u32,
}

impl Raster<'_> {
    /// Writes the pixels of row y from column x on into `part`: as many as the row has there, or as `part` is
    /// long. Those of `part` beyond the picture's right edge stay as they are, and so do all if the picture
    /// has no columns or no rows.
    #[inline(never)]
    pub fn part_of_row<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let columns = if self.height == 0 { 0 } else { self.width.saturating_sub(x) };
        let len = part.len().min(columns as usize);
        let Some(part) = part.get_mut(..len).filter(|part| !part.is_empty()) else {
            return;
        };
        self.background(x, y, part);
        let row = Row { camera: &self.scene.camera, y, width: self.width, height: self.height };
        let mut rank = 0;
        while let Some(solid) = self.scene.solids.get(self.order.index(rank)) {
            if rank == self.order.block {
                // For a short part fewer distances are kept: a scene that is drawn run by run may have little
                // stack.
                let paint =
                    if part.len() > RUN { Self::block::<C, MOST_DEPTHS> } else { Self::block::<C, RUN> };
                paint(self, &row, x, part);
                rank = self.order.beyond;
            } else {
                self.solid(solid, &row, x, part, &mut Over);
                rank += 1;
            }
        }
    }

    /// Paints the solids of the block on `part`, in pieces of equal length, N pixels at most. This function
    /// is not inlined, so that scenes without a block keep no memory for distances on the stack.
    #[cold]
    #[inline(never)]
    fn block<C: Paint, const N: usize>(&self, row: &Row, x: u32, part: &mut [C]) {
        let mut nearest = [0.0; N];
        let len = part.len().div_ceil(part.len().div_ceil(N).max(1)).max(1);
        for (part, x) in part.chunks_mut(len).zip((x..).step_by(len)) {
            self.by_depth(row, x, part, &mut nearest);
        }
    }

    /// Paints the solids of the block on a piece of a row. `nearest` is memory for the distances, for as many
    /// pixels at least.
    #[inline(never)]
    fn by_depth<C: Paint>(&self, row: &Row, x: u32, part: &mut [C], nearest: &mut [f32]) {
        nearest.fill(f32::INFINITY);
        let Self { scene: Scene { solids, .. }, order, .. } = *self;
        let first = order.block;
        let mut depths = Depths { nearest, solids, order, first, rank: first, error: 0.0 };
        while depths.rank < order.beyond {
            if let Some(solid) = solids.get(order.index(depths.rank)) {
                self.solid(solid, row, x, part, &mut depths);
            }
            depths.rank += 1;
        }
    }

    /// Fills `part`, which begins in column x of row y, with the background.
    #[inline(never)]
    fn background<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let shades = self.scene.background.row(y, self.height).shades(most_shades::<C>()).rounded();
        for (pixel, x) in part.iter_mut().zip(x..) {
            *pixel = C::background(shades, x, y);
        }
    }

    /// Paints a solid, a body sheet by sheet, on the pixels of `run` that see it and that `depth` says show
    /// it. `run` begins in column x.
    #[inline(always)]
    fn solid<C: Paint, D: Depth>(&self, solid: &Solid, row: &Row, x: u32, run: &mut [C], depth: &mut D) {
        let mut number = 0;
        while let Some(sheet) = solid.sheet(number) {
            self.sheet(solid, (number, sheet), row, x, run, depth);
            number += 1;
        }
    }

    /// Paints a sheet of a solid, of the given number. Not inline: in a loop it keeps more on the stack.
    #[inline(never)]
    fn sheet<C: Paint, D: Depth>(
        &self,
        solid: &Solid,
        (number, sheet): (usize, &Sheet),
        row: &Row,
        x: u32,
        run: &mut [C],
        depth: &mut D,
    ) {
        let mut along = SolidRow::new(solid, (number, sheet), row, (x, x + run.len() as u32), D::COUNTS);
        if along.sweep.is_culled() {
            return;
        }
        depth.begin(&along);
        let finish = Finish::new::<C>(solid, sheet.color().unwrap_or(solid.color()), &self.scene.light);
        let mut canvas = Canvas::new(finish, &along, (x, row.y), run, depth);
        canvas.half_row(&mut along);
        if along.sweep.reverse() {
            canvas.half_row(&mut along);
        }
    }
}
