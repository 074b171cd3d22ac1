//! A picture without its background: the solids' pixels alone, over what a display shows already.

use super::placed::Placed;
use super::with_run;
use crate::color::Paint;
use crate::extent::Extent;
use embedded_graphics_core::{
    Drawable, draw_target::DrawTarget, geometry::Dimensions, pixelcolor::PixelColor, primitives::Rectangle,
};

/// A [`Placed`] picture without its background: only the pixels that show a solid are drawn, and no other
/// pixel is touched. Text, an image or another picture stays around the solids and behind them.
///
/// Made by [`Placed::without_background`]. Each run of such pixels in a row is one call of
/// [`fill_contiguous`](DrawTarget::fill_contiguous). All rows of the picture's part are looked at: where most
/// of them are empty, [`Placed::only`] its [`Placed::covered`] rectangle is faster.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static SCENE: Scene = Scene::new(
///     &[Solid::new(&BALL, Rgb::WHITE)],
///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     valid!(Light::new([-1.0, -1.0, 1.0], 0.5)),
/// );
///
/// let mut display = MockDisplay::<Gray4>::new();
/// SCENE.picture(12, 12).at(Point::zero()).without_background().draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(6, 6)), Some(Gray4::new(11)));
/// assert_eq!(display.get_pixel(Point::new(1, 1)), None);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Overlay<'a, C> {
    placed: Placed<'a, C>,
}

impl<'a, C: Paint + PixelColor> Placed<'a, C> {
    /// Only the pixels that show a solid: over what the display shows already.
    #[must_use]
    pub const fn without_background(self) -> Overlay<'a, C> {
        Overlay { placed: self }
    }
}

impl<C: Paint + PixelColor> Overlay<'_, C> {
    /// Draws as [`Drawable::draw`] does, but computes the pixels in memory that the caller lends: as many at
    /// once as fit into `row`, up to a whole row of the part. A longer slice is faster, and makes fewer
    /// calls. If `row` is empty, it does what `draw` does.
    ///
    /// # Errors
    ///
    /// The target's own. The first one ends the drawing: no further pixel is drawn.
    pub fn draw_by_rows<D>(&self, target: &mut D, row: &mut [Option<C>]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        if row.is_empty() { self.draw(target) } else { self.draw_through(target, row) }
    }

    /// Draws the part that lies within the target, row by row, and computes as many pixels at once as fit
    /// into `room`. If `room` is empty, no pixel is drawn.
    fn draw_through<D>(&self, target: &mut D, room: &mut [Option<C>]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        let part = self.placed.within(&target.bounding_box());
        for y in part.top..part.bottom {
            let mut x = part.left;
            while let Some(run) = room.get_mut(..room.len().min((part.right - x) as usize))
                && !run.is_empty()
            {
                self.placed.picture().part_of_row(x, y, run);
                self.draw_run(target, (x, y), run)?;
                x += run.len() as u32;
            }
        }
        Ok(())
    }

    /// Draws `run`, the pixels of row y from column x on, except those that are `None`. Each group of
    /// neighbours is drawn in one call.
    fn draw_run<D>(&self, target: &mut D, (x, y): (u32, u32), run: &[Option<C>]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        let mut at = 0;
        while at < run.len() {
            let pixels = run.iter().skip(at).copied().map_while(|pixel| pixel);
            let len = pixels.clone().count();
            if len > 0 {
                let left = x + at as u32;
                let span = Extent { left, top: y, right: left + len as u32, bottom: y + 1 };
                target.fill_contiguous(&self.placed.on_display(span), pixels)?;
            }
            at += len + 1;
        }
        Ok(())
    }
}

impl<C: Paint + PixelColor> Dimensions for Overlay<'_, C> {
    fn bounding_box(&self) -> Rectangle {
        self.placed.bounding_box()
    }
}

impl<C: Paint + PixelColor> Drawable for Overlay<'_, C> {
    type Color = C;
    type Output = ();

    /// Draws each run of pixels that show a solid in one call, with pixels that are computed as many at a
    /// time as in [`Scene::draw`](crate::Scene::draw).
    fn draw<D>(&self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        with_run(|run| self.draw_through(target, run))
    }
}
