//! Drawing onto displays: the only module that uses the drawing traits of embedded-graphics.

mod dither;
mod paint;
mod rgb888;

use crate::camera::Camera;
use crate::color::{Paint, Rgb};
use crate::occlusion::PaintOrder;
use crate::picture::{Picture, Pixels, RUN, Raster};
use crate::ray::Ray;
use crate::scene::Scene;
use core::marker::PhantomData;
use embedded_graphics_core::{
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
    /// 40 at a time at most. No framebuffer is needed.
    ///
    /// If there is memory for a row of pixels, [`Scene::draw_by_rows`] is faster: with a single solid it
    /// takes less than half the time. On a display of 2³² pixels or more `draw` draws no pixel and returns
    /// `Ok`.
    ///
    /// # Errors
    ///
    /// The display's own.
    pub fn draw<D>(&self, display: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Paint>,
    {
        self.draw_through(display, &mut blank())
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

    /// Draws the scene over the whole display, and computes as many pixels at once as fit into `run`, up to a
    /// whole row. `run` must not be empty.
    fn draw_through<D>(&self, display: &mut D, run: &mut [D::Color]) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Paint>,
    {
        let area = display.bounding_box();
        let Size { width, height } = area.size;
        // The raster borrows the scene: a `Picture` would copy it to the stack.
        let order = &PaintOrder::of(self.solids, &self.camera);
        let raster = Raster { scene: self, order, width, height };
        match Pixels::new(&raster, (0, 0), (width, height), run) {
            Some(pixels) => display.fill_contiguous(&area, pixels),
            None => Ok(()),
        }
    }
}

/// Memory for the [`RUN`] pixels that are computed at once, filled with black.
fn blank<C: Paint>() -> [C; RUN] {
    [C::paint(Rgb::BLACK, 0, 0); RUN]
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

/// A [`Picture`] in the colors of a display: an [`ImageDrawable`].
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
        Size::new(self.picture.width(), self.picture.height())
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
        let area = self.bounding_box().intersection(area);
        let (Point { x, y }, Size { width, height }) = (area.top_left, area.size);
        // The intersection lies inside the picture, so x and y are not negative.
        match Pixels::new(&self.picture.raster(), (x as u32, y as u32), (width, height), &mut blank()) {
            Some(pixels) => target.fill_contiguous(&Rectangle::new(Point::zero(), area.size), pixels),
            None => Ok(()),
        }
    }
}
