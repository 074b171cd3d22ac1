//! A scene as a grid of pixels, by reference: what rows are computed from.

use super::brush::Brush;
use super::canvas::Canvas;
use super::depth::{Block, Depths};
use super::solid_row::SolidRow;
use crate::camera::Row;
use crate::color::{Paint, most_shades};
use crate::occlusion::PaintOrder;
use crate::scene::Scene;
use crate::shade::Finish;
use crate::sheet::Sheet;
use crate::solid::Solid;
use core::ops::Range;

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
        let PaintOrder { block, beyond, .. } = *self.order;
        self.paint(0..block, &row, x, part, None);
        if block < beyond {
            // For a short part fewer distances are kept: a scene that is drawn run by run may have little stack.
            if part.len() > RUN {
                self.block::<C, MOST_DEPTHS>(&row, x, part);
            } else {
                self.block::<C, RUN>(&row, x, part);
            }
            self.paint(beyond..usize::MAX, &row, x, part, None);
        }
    }

    /// Paints the solids of the block on `part`, in pieces of N pixels at most. This function is not inlined,
    /// so that scenes without a block keep no memory for distances on the stack.
    #[cold]
    #[inline(never)]
    fn block<C: Paint, const N: usize>(&self, row: &Row, x: u32, part: &mut [C]) {
        for (run, x) in part.chunks_mut(N).zip((x..).step_by(N)) {
            self.by_depth(row, x, run, &mut [f32::INFINITY; N]);
        }
    }

    /// Paints the solids of the block on a piece of a row. `nearest` has a distance for each pixel, all of them
    /// infinite.
    #[inline(never)]
    fn by_depth<C: Paint>(&self, row: &Row, x: u32, run: &mut [C], nearest: &mut [f32]) {
        let Self { scene: Scene { solids, .. }, order, .. } = *self;
        let mut depths = Depths::new(run, nearest, Block { solids, order });
        self.paint(order.block..order.beyond, row, x, &mut [], Some(&mut depths));
    }

    /// Fills `part`, which begins in column x of row y, with the background.
    #[inline(never)]
    fn background<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let shades = self.scene.background.row(y, self.height).shades(most_shades::<C>()).rounded();
        for (pixel, x) in part.iter_mut().zip(x..) {
            *pixel = C::background(shades, x, y);
        }
    }

    /// Paints the solids of some ranks, a body sheet by sheet: without `depths` on all pixels of `run` that
    /// see them. With `depths` `run` is to be empty; the solids are painted on those pixels of `depths` that
    /// see them and show them. The first pixel is in column x.
    #[inline(never)]
    fn paint<C: Paint>(
        &self,
        ranks: Range<usize>,
        row: &Row,
        x: u32,
        run: &mut [C],
        mut depths: Option<&mut Depths<C>>,
    ) {
        for rank in ranks {
            let Some(solid) = self.scene.solids.get(self.order.index(rank)) else { return };
            for sheet in solid.sheets() {
                self.sheet(solid, sheet, row, x, run, depths.as_deref_mut());
            }
        }
    }

    /// Paints one sheet of a solid, as [`Raster::paint`] does. Not inline: in a loop it keeps more on the stack.
    #[inline(never)]
    fn sheet<C: Paint>(
        &self,
        solid: &Solid,
        sheet: &Sheet,
        row: &Row,
        x: u32,
        run: &mut [C],
        mut depths: Option<&mut Depths<C>>,
    ) {
        let len = depths.as_ref().map_or(run.len(), |depths| depths.run.len());
        let columns = (x, x + len as u32);
        // Not taken apart: that would copy its parts.
        let mut along = SolidRow::new(solid, sheet, row, columns, depths.is_some());
        if along.sweep.is_culled() {
            return;
        }
        if let Some(depths) = &mut depths {
            depths.begin(&along.sweep);
        }
        let finish = Finish::new::<C>(solid, sheet.color().unwrap_or(solid.color()), &self.scene.light);
        let brush = Brush::new(finish, &along.rays, &along.sweep, (x, row.y));
        let mut canvas = Canvas { brush, run, depths };
        canvas.half_row(&mut along.sweep);
        if along.sweep.reverse() {
            canvas.half_row(&mut along.sweep);
        }
    }
}
