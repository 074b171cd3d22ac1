//! Drawing onto displays: the only module that uses the drawing traits of embedded-graphics.

mod bytes;
mod covered;
mod dither;
mod overlay;
mod paint;
mod placed;
mod rgb888;

pub use covered::Redraw;
pub use overlay::Overlay;
pub use placed::Placed;

use crate::camera::Camera;
use crate::color::{Paint, Rgb};
use crate::pick::Pick;
use crate::picture::{Picture, Pixels, Plan, RUNS, Raster};
use crate::ray::Ray;
use crate::scene::Scene;
use core::marker::PhantomData;
use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::{Dimensions, OriginDimensions, Point, Size},
    image::ImageDrawable,
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

impl Camera {
    /// Does what [`Camera::ray`] does, for a pixel that may also lie to the left of the picture or above it.
    #[must_use]
    pub fn ray_at(&self, pixel: Point, picture: Size) -> Ray {
        self.ray_through([pixel.x as f32, pixel.y as f32], picture.width, picture.height)
    }
}

impl<'a> Scene<'a> {
    /// Does what [`Scene::picture`] does, for a size of embedded-graphics.
    ///
    /// ```
    /// use embedded_graphics::prelude::*;
    /// use embedded_lathe::*;
    ///
    /// fn is_portrait(scene: &Scene, display: &impl Dimensions) -> bool {
    ///     let picture = scene.picture_of(display.bounding_box().size);
    ///     picture.height() > picture.width()
    /// }
    /// ```
    #[must_use]
    pub const fn picture_of(&self, size: Size) -> Picture<'a> {
        self.picture(size.width, size.height)
    }

    /// Draws the scene over the whole display, in one call of
    /// [`fill_contiguous`](DrawTarget::fill_contiguous). The pixels are computed as the display takes them,
    /// as many at a time as 160 bytes of stack hold: 160 of one byte each, 80 of two, 40 of more. No
    /// framebuffer is needed.
    ///
    /// It fills the target's bounding box, as `clear` does, so the picture has the size of that box. What
    /// embedded-graphics makes of a display has a box of its own: that of `translated` is still the whole
    /// display, so the scene is not moved; that of `clipped` and of `cropped` is their rectangle, so the
    /// whole scene is drawn smaller, into it. [`Picture::at`] draws a picture of a given size at a given
    /// place.
    ///
    /// If there is memory for a row of pixels that is longer, [`Scene::draw_by_rows`] is faster: with a
    /// single solid in rows of 240 `Rgb565` it takes two thirds of the time. On a display of 2³² pixels or
    /// more `draw` draws no pixel and returns `Ok`.
    ///
    /// # Errors
    ///
    /// The display's own.
    pub fn draw<D>(&self, display: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Paint>,
    {
        with_run(|run| self.draw_through(display, run))
    }

    /// Draws the scene as [`Scene::draw`] does, but computes the pixels in memory that the caller lends: as
    /// many at a time as fit into `row`, up to a whole row of the display. Neighbouring pixels share
    /// computations, so a longer slice is faster. If `row` is empty, it does what [`Scene::draw`] does.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// static SCENE: Scene = Scene::new(
    ///     &[Solid::new(&BALL, Rgb::WHITE)],
    ///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let mut display = MockDisplay::<Rgb565>::new();
    /// SCENE.draw_by_rows(&mut display, &mut [Rgb565::BLACK; 64])?;
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The display's own.
    pub fn draw_by_rows<D>(&self, display: &mut D, row: &mut [D::Color]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Paint>,
    {
        if row.is_empty() { self.draw(display) } else { self.draw_through(display, row) }
    }

    /// Which solid lies under a pixel of a picture of the given size: the first that the pixel's ray hits.
    /// `None` if it hits none, if the pixel lies outside the picture, or if the picture has no pixels.
    ///
    /// A pick casts one ray at each solid, which costs less than a row of pixels. If the picture is not in
    /// the upper left corner of a touch screen, use [`Placed::pick`].
    ///
    /// ```
    /// use embedded_graphics::prelude::*;
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(0.5)));
    /// const fn ball(x: f32) -> Result<Solid<'static>, SceneError> {
    ///     match Pose::new([x, 0.0, 0.0], Rotation::IDENTITY, 1.0) {
    ///         Ok(pose) => Ok(Solid::new(&BALL, Rgb::WHITE).posed(pose)),
    ///         Err(error) => Err(error),
    ///     }
    /// }
    /// static BUTTONS: Scene = Scene::new(
    ///     &[valid!(ball(-0.6)), valid!(ball(0.6))],
    ///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let screen = Size::new(240, 240);
    /// let pick = BUTTONS.pick(Point::new(180, 120), screen).unwrap();
    /// assert_eq!(pick.solid, 1);
    /// let ray = BUTTONS.camera.ray_at(Point::new(180, 120), screen);
    /// let [x, _, _] = BUTTONS.solids[pick.solid].surface(&ray, &pick.hit).point;
    /// assert!((x - 0.6).abs() < 0.01);
    /// assert_eq!(BUTTONS.pick(Point::new(120, 120), screen), None);
    /// ```
    #[must_use]
    pub fn pick(&self, pixel: Point, picture: Size) -> Option<Pick> {
        let (x, y) = (u32::try_from(pixel.x).ok()?, u32::try_from(pixel.y).ok()?);
        let Size { width, height } = picture;
        if x < width && y < height { self.nearest(&self.camera.ray(x, y, width, height), 0.0) } else { None }
    }

    /// Draws the scene over the whole display, and computes as many pixels at once as fit into `run`, up to a
    /// whole row. `run` must not be empty.
    fn draw_through<D>(&self, display: &mut D, run: &mut [D::Color]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Paint>,
    {
        let area = display.bounding_box();
        let Size { width, height } = area.size;
        // The raster borrows the scene: a `Picture` would copy it to the stack.
        let plan = &Plan::of(self, width, height);
        let raster = Raster { scene: self, plan, width, height };
        match Pixels::new(&raster, (0, 0), (width, height), run) {
            Some(pixels) => display.fill_contiguous(&area, pixels),
            None => Ok(()),
        }
    }
}

/// Calls `draw` with memory for the pixels that are computed at once, see [`RUNS`].
#[inline(always)]
fn with_run<C: Paint, R>(draw: impl FnOnce(&mut [C]) -> R) -> R {
    let black = C::paint(Rgb::BLACK, 0, 0);
    match size_of::<C>() {
        ..=1 => draw(&mut [black; RUNS[0]]),
        2 => draw(&mut [black; RUNS[1]]),
        _ => draw(&mut [black; RUNS[2]]),
    }
}

impl<'a> Picture<'a> {
    /// The picture in colors C, for the `Image` of embedded-graphics.
    ///
    /// ```
    /// use embedded_graphics::{image::Image, mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// static SCENE: Scene = Scene::new(
    ///     &[Solid::new(&BALL, Rgb::WHITE)],
    ///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let mut display = MockDisplay::<Gray4>::new();
    /// let ball = SCENE.picture(32, 32).image::<Gray4>();
    /// Image::new(&ball, Point::new(20, 10)).draw(&mut display)?;
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    #[must_use]
    pub const fn image<C: Paint + PixelColor>(self) -> PictureImage<'a, C> {
        PictureImage { picture: self, color: PhantomData }
    }
}

/// A [`Picture`] in the colors of a display: an [`ImageDrawable`]. If the picture has more than 2³¹ − 1
/// columns or rows, the first 2³¹ − 1 are drawn: as many as embedded-graphics can number.
///
/// Made by [`Picture::image`], where there is an example.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PictureImage<'a, C> {
    picture: Picture<'a>,
    color: PhantomData<C>,
}

impl<C> OriginDimensions for PictureImage<'_, C> {
    fn size(&self) -> Size {
        const MOST: u32 = i32::MAX as u32;
        Size::new(self.picture.width().min(MOST), self.picture.height().min(MOST))
    }
}

impl<C: Paint + PixelColor> ImageDrawable for PictureImage<'_, C> {
    type Color = C;

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.draw_sub_image(target, &self.bounding_box())
    }

    fn draw_sub_image<D: DrawTarget<Color = C>>(
        &self,
        target: &mut D,
        area: &Rectangle,
    ) -> Result<(), D::Error> {
        // The upper left corner of what lies inside the picture is drawn at the origin.
        let part = self.picture.at(Point::zero()).only(area);
        let Point { x, y } = part.bounding_box().top_left;
        part.translate(Point::new(-x, -y)).draw(target)
    }
}
