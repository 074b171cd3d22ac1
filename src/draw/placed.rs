//! A picture at a place of the display: what of it is drawn, and where.

use super::with_run;
use crate::color::Paint;
use crate::extent::Extent;
use crate::pick::Pick;
use crate::picture::{Picture, Pixels};
use core::marker::PhantomData;
use core::ops::Range;
use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

impl<'a> Picture<'a> {
    /// The picture at a place of a display: the pixel in column 0 of row 0 is drawn at `position`, which may
    /// be negative. The color C is the display's, and is inferred where the picture is drawn.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*, primitives::Rectangle};
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// static SCENE: Scene = Scene::new(
    ///     &[Solid::new(&BALL, Rgb::WHITE)],
    ///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let mut display = MockDisplay::<Gray4>::new(); // 64×64 pixels
    /// let ball = SCENE.picture(32, 24).at(Point::new(20, 50));
    /// assert_eq!(ball.bounding_box(), Rectangle::new(Point::new(20, 50), Size::new(32, 24)));
    /// ball.draw(&mut display)?; // the lower 10 rows lie below the display, and are not computed
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[must_use]
    pub const fn at<C: Paint + PixelColor>(self, position: Point) -> Placed<'a, C> {
        let part = Extent { left: 0, top: 0, right: self.width(), bottom: self.height() };
        Placed { picture: self, position, part, color: PhantomData }
    }
}

/// A [`Picture`] at a place of a display, in the display's colors: a [`Drawable`]. It is drawn where it is
/// put, and no other pixel is touched: on the display itself and on what embedded-graphics makes of it,
/// `translated`, `clipped` and `cropped`.
///
/// Made by [`Picture::at`], where there is an example. [`Placed::rows`] and [`Placed::only`] choose a part,
/// for a band of a display, or for the rectangle that has changed. What lies outside the target is not
/// computed, however large the picture is; of a target with 2³² pixels or more no pixel is drawn.
///
/// [`Placed::translate`] and [`Placed::translate_mut`] do what the two methods of embedded-graphics'
/// `Transform` do. That trait is not part of embedded-graphics-core, so `Placed` does not implement it. For
/// code that is generic over `Transform`, use an `Image` of [`Picture::image`], which does.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Placed<'a, C> {
    picture: Picture<'a>,
    position: Point,
    /// The columns and rows of the picture that are drawn.
    part: Extent,
    color: PhantomData<C>,
}

impl<'a, C: Paint + PixelColor> Placed<'a, C> {
    /// The picture.
    #[must_use]
    pub const fn picture(&self) -> &Picture<'a> {
        &self.picture
    }

    /// Where column 0 of row 0 is drawn.
    #[must_use]
    pub const fn position(&self) -> Point {
        self.position
    }

    /// This picture moved by `by`, in pixels. A coordinate beyond the range of an `i32` saturates.
    #[must_use]
    pub fn translate(&self, by: Point) -> Self {
        let Point { x, y } = self.position;
        Self { position: Point::new(x.saturating_add(by.x), y.saturating_add(by.y)), ..*self }
    }

    /// Moves the picture by `by`, in pixels, as [`Placed::translate`] does.
    pub fn translate_mut(&mut self, by: Point) -> &mut Self {
        *self = self.translate(by);
        self
    }

    /// Only what lies in the rectangle `area` of the display, in the same place as before.
    #[must_use]
    pub fn only(self, area: &Rectangle) -> Self {
        Self { part: self.within(area), ..self }
    }

    /// Only some rows of the picture, counted from its top, in the same place as before. Rows that the
    /// picture does not have are left out.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*, primitives::Rectangle};
    /// # use embedded_lathe::*;
    /// # static SCENE: Scene = Scene::new(
    /// #     &[],
    /// #     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    /// #     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// # );
    ///
    /// let mut display = MockDisplay::<Gray4>::new();
    /// let picture = SCENE.picture(64, 64).at(Point::zero());
    /// picture.rows(16..32).draw(&mut display)?;
    /// assert_eq!(display.affected_area(), Rectangle::new(Point::new(0, 16), Size::new(64, 16)));
    ///
    /// // The same band, into a target that is a band itself: its first row is row 16.
    /// let mut band = MockDisplay::<Gray4>::new();
    /// picture.rows(16..32).translate(Point::new(0, -16)).draw(&mut band)?;
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[must_use]
    pub fn rows(self, rows: Range<u32>) -> Self {
        let Extent { top, bottom, .. } = self.part;
        let top = rows.start.max(top).min(bottom);
        let bottom = rows.end.max(top).min(bottom);
        Self { part: Extent { top, bottom, ..self.part }, ..self }
    }

    /// The rectangle of the display that the picture's solids cover: [`Picture::covered`], cut to the part
    /// that is drawn. Its size is zero if the two do not overlap, or if no solid is seen.
    #[must_use]
    pub fn covered(&self) -> Rectangle {
        match self.picture.extent(self.picture.scene().solids) {
            Some(covered) => self.on_display(covered.cut_to(self.part)),
            None => Rectangle::zero(),
        }
    }

    /// Which solid lies under a pixel of the display, where a finger touches it for example: see
    /// [`Scene::pick`](crate::Scene::pick). `None` if the pixel is not one of those that are drawn.
    #[must_use]
    pub fn pick(&self, pixel: Point) -> Option<Pick> {
        let one = self.within(&Rectangle::new(pixel, Size::new(1, 1)));
        if one.is_empty() {
            return None;
        }
        self.picture.pick(one.left, one.top)
    }

    /// Draws as [`Drawable::draw`] does, but computes the pixels in memory that the caller lends, as
    /// [`Scene::draw_by_rows`](crate::Scene::draw_by_rows) does. If `row` is empty, it does what `draw` does.
    ///
    /// # Errors
    ///
    /// The target's own.
    pub fn draw_by_rows<D>(&self, target: &mut D, row: &mut [C]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        if row.is_empty() { self.draw(target) } else { self.draw_through(target, row) }
    }

    /// Draws only some columns of each row, those that `columns` returns for the row's number, counted in the
    /// picture: one call of [`fill_contiguous`](DrawTarget::fill_contiguous) for each row that has any.
    /// Pixels are computed in memory that the caller lends, as by [`Placed::draw_by_rows`].
    ///
    /// A round panel shows four fifths of the pixels of its square, and asks for no others:
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
    /// # use embedded_lathe::*;
    /// # static SCENE: Scene = Scene::new(
    /// #     &[],
    /// #     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    /// #     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// # );
    ///
    /// let mut display = MockDisplay::<Rgb565>::new();
    /// let picture = SCENE.picture(64, 64);
    /// let mut row = [Rgb565::BLACK; 64];
    /// picture.at(Point::zero()).draw_spans(&mut display, &mut row, |y| picture.disc_of_row(y))?;
    /// assert_eq!(display.get_pixel(Point::new(0, 0)), None);
    /// assert_eq!(display.get_pixel(Point::new(0, 32)), Some(Rgb565::BLACK));
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The target's own.
    pub fn draw_spans<D>(
        &self,
        target: &mut D,
        row: &mut [C],
        columns: impl Fn(u32) -> Range<u32>,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        if row.is_empty() {
            return with_run(|run| self.draw_spans(target, run, columns));
        }
        let part = self.within(&target.bounding_box());
        (part.top..part.bottom).try_for_each(|y| {
            let Range { start, end } = columns(y);
            let (left, right) = (start.max(part.left), end.min(part.right));
            self.fill(target, Extent { left, top: y, right, bottom: y + 1 }, row)
        })
    }

    /// Draws what the target has room for, and computes as many pixels at once as fit into `run`.
    fn draw_through<D>(&self, target: &mut D, run: &mut [C]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        self.fill(target, self.within(&target.bounding_box()), run)
    }

    /// Draws a part of the picture in one call, and computes as many pixels at once as fit into `run`. Makes
    /// no call if the part has no pixels, or 2³² and more, or if `run` is empty.
    fn fill<D>(&self, target: &mut D, part: Extent, run: &mut [C]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        if part.is_empty() {
            return Ok(());
        }
        let size = (part.right - part.left, part.bottom - part.top);
        match Pixels::new(&self.picture.raster(), (part.left, part.top), size, run) {
            Some(pixels) => target.fill_contiguous(&self.on_display(part), pixels),
            None => Ok(()),
        }
    }

    /// The columns and rows of the picture that are drawn and that lie in a rectangle of the display.
    pub(super) fn within(&self, area: &Rectangle) -> Extent {
        let Extent { left, top, right, bottom } = self.part;
        let Rectangle { top_left: Point { x, y }, size: Size { width, height } } = *area;
        let (left, right) = cut(x, width, self.position.x, left, right);
        let (top, bottom) = cut(y, height, self.position.y, top, bottom);
        Extent { left, top, right, bottom }
    }

    /// The rectangle of the display where `part`, columns and rows of the picture, is drawn. It is cut at the
    /// largest `i32`, so that embedded-graphics can compute with it.
    pub(super) fn on_display(&self, part: Extent) -> Rectangle {
        let (x, width) = placed(part.left, part.right, self.position.x);
        let (y, height) = placed(part.top, part.bottom, self.position.y);
        Rectangle::new(Point::new(x, y), Size::new(width, height))
    }
}

/// Cuts the columns (or rows) from `first` to before `end` to those that are drawn on the `len` pixels of the
/// display from `start` on, if column 0 is at `position`. Returns their first and the one after their last;
/// the two are equal if there are none.
fn cut(start: i32, len: u32, position: i32, first: u32, end: u32) -> (u32, u32) {
    let from = i64::from(start) - i64::from(position);
    let within = |i: i64| i.max(i64::from(first)).min(i64::from(end)) as u32;
    (within(from), within(from + i64::from(len)))
}

/// Where the columns (or rows) from `first` to before `end` begin on the display, if column 0 is at
/// `position`, and how many of them lie below the largest `i32`.
fn placed(first: u32, end: u32, position: i32) -> (i32, u32) {
    let most = i64::from(i32::MAX);
    let start = (i64::from(position) + i64::from(first)).min(most);
    let len = i64::from(end - first).min(most - start).min(most);
    (start as i32, len as u32)
}

impl<C: Paint + PixelColor> Dimensions for Placed<'_, C> {
    fn bounding_box(&self) -> Rectangle {
        self.on_display(self.part)
    }
}

impl<C: Paint + PixelColor> Drawable for Placed<'_, C> {
    type Color = C;
    type Output = ();

    /// Draws in one call of [`fill_contiguous`](DrawTarget::fill_contiguous), with pixels that are computed
    /// as the target takes them, as many at a time as in [`Scene::draw`](crate::Scene::draw).
    fn draw<D>(&self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
    {
        with_run(|run| self.draw_through(target, run))
    }
}
