//! A scene as a grid of pixels, by reference: what rows are computed from.

use super::aspect::Aspect;
use super::brush::Brush;
use super::canvas::{Canvas, Part};
use super::depth::{Block, Depths};
use super::plan::Plan;
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
/// stack. The numbers are those for colors of one byte, of two, and of more: 160 bytes of stack.
///
/// The value is a choice between stack and time, because each solid is set up anew for every run: the
/// README's vase in `Rgb565` takes half as long again in runs of 80 as in rows of 240, and more than twice as
/// long in runs of 40. All of these divide the usual widths, 240 and 320, or fill a row of 128, and are
/// multiples of 8, the period of the dithering.
pub(crate) const RUNS: [usize; 3] = [160, 80, 40];

/// For how many pixels at most distances are kept in memory at once. This many is a whole row of the usual
/// displays, so that a row is not cut in pieces: if the two halves of a row are mirror images, only one is
/// swept.
const MOST_DEPTHS: usize = 240;

/// The same for parts that are no longer than this.
const FEW_DEPTHS: usize = RUNS[1];

/// A scene, the size of its picture in pixels, and what is computed once for the picture.
///
/// It borrows what a [`Picture`](super::Picture) owns: a frame that is drawn keeps no copy of the scene on
/// the stack.
#[derive(Clone, Copy)]
pub(crate) struct Raster<'a> {
    pub scene: &'a Scene<'a>,
    pub plan: &'a Plan,
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
        let PaintOrder { block, beyond, .. } = self.plan.order;
        let mut part = Part { row: &row, x, run: part, depths: None };
        self.paint(0..block, &mut part);
        if block < beyond {
            // Memory for fewer distances serves a short part: a scene that is drawn run by run may have
            // little stack.
            if part.run.len() > FEW_DEPTHS {
                self.block::<C, MOST_DEPTHS>(&mut part);
            } else {
                self.block::<C, FEW_DEPTHS>(&mut part);
            }
            self.paint(beyond..usize::MAX, &mut part);
        }
    }

    /// Paints the solids of the block on `part`, in pieces of N pixels at most. This function is not inlined,
    /// so that scenes without a block keep no memory for distances on the stack.
    #[cold]
    #[inline(never)]
    fn block<C: Paint, const N: usize>(&self, part: &mut Part<C>) {
        self.by_depth(part, &mut [f32::INFINITY; N]);
    }

    /// Paints the solids of the block on `part`, in pieces of as many pixels as `nearest` has room for
    /// distances: all of them infinite, before and after.
    #[inline(never)]
    fn by_depth<C: Paint>(&self, part: &mut Part<C>, nearest: &mut [f32]) {
        let Self { scene: Scene { solids, .. }, plan: Plan { order, .. }, .. } = *self;
        let mut x = part.x;
        // Chunks of no pixels would be a panic.
        for run in part.run.chunks_mut(nearest.len().max(1)) {
            let len = run.len() as u32;
            let mut depths = Depths::new(run, nearest, Block { solids, order });
            let mut piece = Part { row: part.row, x, run: &mut [], depths: Some(&mut depths) };
            self.paint(order.block..order.beyond, &mut piece);
            nearest.fill(f32::INFINITY);
            x += len;
        }
    }

    /// Fills `part`, which begins in column x of row y, with the background.
    #[inline(never)]
    fn background<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let shades = self.scene.background.row(y, self.height).shades(most_shades::<C>()).rounded();
        if C::IS_UNIFORM {
            return fill(part, C::background(shades, x, y));
        }
        for (pixel, x) in part.iter_mut().zip(x..) {
            *pixel = C::background(shades, x, y);
        }
    }

    /// Paints the solids of some ranks on a part of a row, a body sheet by sheet.
    #[inline(never)]
    fn paint<C: Paint>(&self, ranks: Range<usize>, part: &mut Part<C>) {
        let j = part.row.below_middle();
        for rank in ranks {
            let index = self.plan.order.index(rank);
            let Some(solid) = self.scene.solids.get(index) else { return };
            let mut kept = if part.row.y < self.height { self.plan.aspects.get(index) } else { None };
            for sheet in solid.sheets() {
                let kept = kept.take();
                if !kept.is_some_and(|aspect| aspect.grid.passes_by(j)) {
                    self.sheet(solid, sheet, kept, part);
                }
            }
        }
    }

    /// Paints one sheet of a solid on a part of a row. `kept` is its aspect in the picture, if that is known.
    /// This function is not inlined: in the loop of its caller it would take more stack.
    #[inline(never)]
    fn sheet<C: Paint>(&self, solid: &Solid, sheet: &Sheet, kept: Option<&Aspect>, part: &mut Part<C>) {
        // `along` stays whole: a pattern that moves the sweep and the rays out of it would copy both.
        let mut along = SolidRow::new(solid, sheet, kept, part.row, part.columns(), part.depths.is_some());
        if along.sweep.is_culled() {
            return;
        }
        if let Some(depths) = &mut part.depths {
            depths.begin(&along.sweep);
        }
        let known = kept.map(|aspect| aspect.to_light);
        let finish = Finish::new::<C>(solid, solid.color_of(sheet), &self.scene.light, known);
        let mirror = along.sweep.mirror();
        let mirrored =
            mirror.map(|n| kept.map_or_else(|| finish.to_light.mirrored(n), |aspect| aspect.mirrored));
        let brush =
            Brush::new(finish, &along.rays, mirrored, part.x, solid.is_body() && part.depths.is_none());
        let mut canvas = Canvas { brush, run: part.run, depths: part.depths.as_deref_mut() };
        loop {
            canvas.half_row(&mut along.sweep);
            if !along.sweep.reverse() {
                break;
            }
        }
    }
}

/// Fills pixels with one color.
#[inline(always)]
fn fill<C: Copy>(part: &mut [C], pixel: C) {
    let pair = twice(pixel);
    if let Some(last) = part.last_mut() {
        *last = pixel;
    }
    for pixels in part.chunks_exact_mut(2) {
        pixels.copy_from_slice(&pair);
    }
}

/// A color twice. This is not inlined: so the compiler has two pixels of 16 bits in one register, and stores
/// both at once.
#[inline(never)]
const fn twice<C: Copy>(pixel: C) -> [C; 2] {
    [pixel, pixel]
}
