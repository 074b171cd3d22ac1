//! From a scene to rows of pixels: as many as the caller asks for, where the caller wants them. Nothing else
//! is kept.

use crate::camera::Projection;
use crate::color::{Paint, Rgb};
use crate::scene::Scene;
use crate::solid::Rays;
use crate::vector::F32x3;
use core::num::NonZeroU32;

/// How many pixels of a row are reckoned at once: what is common to them is found once, and their depths are
/// kept until all solids have been seen.
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
    pub fn part_of_row<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let mut x = x;
        for run in part.chunks_mut(RUN) {
            let left = self.width.saturating_sub(x) as usize;
            let len = run.len().min(left);
            if let Some(run) = run.get_mut(..len) {
                self.run(x, y, run);
            }
            x = x.saturating_add(RUN as u32);
        }
    }

    /// At most RUN pixels: the background, then every solid where it is nearer than what is there.
    fn run<C: Paint>(&self, x: u32, y: u32, run: &mut [C]) {
        let Scene { solids, light, background, .. } = self.scene;
        let behind = background.row(y, self.height);
        for (pixel, x) in run.iter_mut().zip(x..) {
            *pixel = C::paint(behind, x, y);
        }
        let rays = self.rays(y);
        let mut depths = [f32::INFINITY; RUN];
        for solid in *solids {
            let seen = solid.seen_along(&rays, light);
            for (i, (pixel, depth)) in run.iter_mut().zip(&mut depths).enumerate() {
                if let Some((t, colour)) = seen.pixel(x + i as u32, *depth) {
                    *depth = t;
                    *pixel = C::paint(colour, x + i as u32, y);
                }
            }
        }
    }

    /// The rays through the pixels of row y, from column 0 on: a pixel's is the same whichever run it is in.
    fn rays(&self, y: u32) -> Rays {
        let camera = &self.scene.camera;
        let first = camera.ray(0, y, self.width, self.height);
        let step = camera.right * (2.0 / self.width as f32);
        let none = F32x3::default();
        let (origin_step, direction_step) = match camera.projection {
            Projection::Perspective => (none, step),
            Projection::Orthographic => (step, none),
        };
        Rays { origin: first.origin, origin_step, direction: first.direction, direction_step }
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
                self.picture.run(self.left + column - within, self.top + row, run);
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
