//! From a scene to rows of pixels: as many as the caller asks for, where the caller wants them. Nothing else
//! is kept.

use crate::camera::Row;
use crate::color::{Paint, Rgb};
use crate::scene::Scene;
use crate::solid::Solid;
use core::num::NonZeroU32;

/// How many pixels are reckoned at once where a row cannot be: before several solids, for the depths are kept
/// until all have been seen, and on the way to a display.
const RUN: usize = 16;

/// A scene as a picture of so many pixels: reckoned row by row, or pixel by pixel, when asked.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static SCENE: Scene = Scene {
///     solids: &[Solid::new(&BALL, Rgb::WHITE)],
///     camera: valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     light: valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
///     background: Background::Plain(Rgb::BLACK),
/// };
///
/// let picture = SCENE.picture(240, 240);
/// let mut row = [Rgb565::default(); 240];
/// for y in 0..240 {
///     picture.row(y, &mut row);
///     // … hand the row to the display, by DMA for example.
/// }
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Picture<'a> {
    pub(crate) scene: &'a Scene<'a>,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Picture<'_> {
    /// How many pixels a row has.
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// How many rows there are.
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// The pixels of row y, counted from the top, into `row` from its start: as many as the picture is wide,
    /// or as `row` is long.
    pub fn row<C: Paint>(&self, y: u32, row: &mut [C]) {
        self.part_of_row(0, y, row);
    }

    /// The pixels of row y from column x on, into `part`: as many as the row still has, or as `part` is long.
    ///
    /// A long part is cheaper than as many short ones: neighbours share what they can. The picture is the same,
    /// but for less than one pixel in 10 000, where rounding decides between two shades.
    pub fn part_of_row<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let left = self.width.saturating_sub(x) as usize;
        let len = part.len().min(left);
        let Some(part) = part.get_mut(..len) else {
            return;
        };
        self.background(x, y, part);
        let row = Row { camera: &self.scene.camera, y, width: self.width, height: self.height };
        match self.scene.solids {
            [solid] => self.solid(solid, &row, x, part, &mut []),
            solids => {
                for (run, x) in part.chunks_mut(RUN).zip((x..).step_by(RUN)) {
                    let mut depths = [f32::INFINITY; RUN];
                    for solid in solids {
                        self.solid(solid, &row, x, run, &mut depths);
                    }
                }
            }
        }
    }

    /// What there is before any solid is seen.
    #[inline(never)]
    fn background<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let colour = self.scene.background.row(y, self.height);
        for (pixel, x) in part.iter_mut().zip(x..) {
            *pixel = C::paint(colour, x, y);
        }
    }

    /// A solid, where it is nearer than what is there. A lone one needs no depths.
    #[inline(never)]
    fn solid<C: Paint>(&self, solid: &Solid, row: &Row, x: u32, run: &mut [C], depths: &mut [f32]) {
        let end = x + run.len() as u32;
        let mut along = solid.along(row, &self.scene.light, x, end);
        let mut i = x;
        while i < end {
            let seen = match along.see(i) {
                Ok(seen) => seen,
                Err(next) => {
                    i = next;
                    continue;
                }
            };
            let at = (i - x) as usize;
            let is_nearest = match depths.get_mut(at) {
                Some(depth) if seen.t < *depth => {
                    *depth = seen.t;
                    true
                }
                Some(_) => false,
                None => true,
            };
            if is_nearest && let Some(pixel) = run.get_mut(at) {
                *pixel = C::paint(along.colour(i, &seen), i, row.y);
            }
            i += 1;
        }
    }

    /// The pixels of a rectangle, row by row from its upper left corner, reckoned as they are asked for.
    pub(crate) fn pixels<C: Paint>(&self, x: u32, y: u32, width: u32, height: u32) -> Option<Pixels<'_, C>> {
        let blank = C::paint(Rgb::BLACK, 0, 0);
        Some(Pixels {
            picture: self,
            left: x,
            top: y,
            width: NonZeroU32::new(width)?,
            next: 0,
            end: width.checked_mul(height)?,
            run: [blank; RUN],
            run_at: None,
        })
    }
}

/// The pixels of a rectangle of a picture, in the order a display takes them. One run is kept; skipping costs
/// what one run costs.
pub(crate) struct Pixels<'a, C> {
    picture: &'a Picture<'a>,
    left: u32,
    top: u32,
    width: NonZeroU32,
    /// The number of the next pixel, row by row, and how many there are.
    next: u32,
    end: u32,
    run: [C; RUN],
    /// The number of the pixel that the run begins with, if there is one.
    run_at: Option<u32>,
}

impl<C: Paint> Iterator for Pixels<'_, C> {
    type Item = C;

    fn next(&mut self) -> Option<C> {
        if self.next >= self.end {
            return None;
        }
        let (row, column) = (self.next / self.width, self.next % self.width);
        let within = column % RUN as u32;
        let run_at = self.next - within;
        if self.run_at != Some(run_at) {
            self.run_at = Some(run_at);
            let len = (self.width.get() - (column - within)).min(RUN as u32);
            if let Some(run) = self.run.get_mut(..len as usize) {
                self.picture.part_of_row(self.left + column - within, self.top + row, run);
            }
        }
        self.next += 1;
        self.run.get(within as usize).copied()
    }

    fn nth(&mut self, n: usize) -> Option<C> {
        let n = u32::try_from(n).unwrap_or(u32::MAX);
        self.next = self.next.saturating_add(n).min(self.end);
        self.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.end - self.next) as usize;
        (left, Some(left))
    }
}

impl<C: Paint> ExactSizeIterator for Pixels<'_, C> {}
