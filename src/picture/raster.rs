//! A scene as a grid of pixels, by reference: what rows are computed from.

use super::canvas::Canvas;
use super::solid_row::SolidRow;
use crate::camera::{Camera, Row};
use crate::color::{Background, Paint, most_shades};
use crate::light::Light;
use crate::occlusion::{FIRST, PaintOrder, Painted};
use crate::shade::Finish;
use crate::solid::Solid;

/// The parts of a scene, the size of its picture in pixels, and the order in which its solids are painted.
///
/// It borrows what a [`Picture`](super::Picture) owns: a frame that is drawn keeps no copy of the scene on
/// the stack.
#[derive(Clone, Copy)]
pub(crate) struct Raster<'a> {
    pub solids: &'a [Solid<'a>],
    pub camera: &'a Camera,
    pub light: &'a Light,
    pub background: &'a Background,
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
        let row = Row { camera: self.camera, y, width: self.width, height: self.height };
        let (mut rank, mut last) = (0, FIRST);
        while let Some(painted) = self.order.painted(self.solids, self.camera, rank, &mut last) {
            self.solid(&painted, &row, x, part);
            rank += 1;
        }
    }

    /// Fills `part`, which begins in column x of row y, with the background.
    #[inline(never)]
    fn background<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let shades = self.background.row(y, self.height).shades(most_shades::<C>()).rounded();
        for (pixel, x) in part.iter_mut().zip(x..) {
            *pixel = C::shade(shades, x, y);
        }
    }

    /// Paints a solid over what `run`, which begins in column x, holds already: the farther solids.
    #[inline(never)]
    fn solid<C: Paint>(&self, painted: &Painted, row: &Row, x: u32, run: &mut [C]) {
        let mut along = SolidRow::new(painted, row, x, x + run.len() as u32);
        if along.sweep.is_culled() {
            return;
        }
        let finish = Finish::new::<C>(painted.solid, self.light);
        let mut canvas = Canvas::new(finish, &along, (x, row.y), run);
        canvas.half_row(&mut along);
        if along.sweep.reverse() {
            canvas.half_row(&mut along);
        }
    }
}
