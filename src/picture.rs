//! From a scene to rows of pixels: as many as the caller asks for, where the caller wants them. No pixel is
//! kept.

mod aspect;
mod brush;
mod canvas;
mod depth;
mod pixels;
mod plan;
mod raster;
mod solid_row;

pub(crate) use pixels::Pixels;
pub(crate) use plan::Plan;
pub(crate) use raster::{RUNS, Raster};

use crate::color::Paint;
use crate::pick::Pick;
use crate::scene::Scene;
use core::ops::Range;

/// A scene and the size of its picture in pixels. Rows are computed when they are asked for.
///
/// A picture owns its scene, a copy of some 100 bytes, and borrows the solids. It finds the order in which
/// they are painted when it is made, at compile time in a `const`: make one picture of a scene, not one for
/// each row. Without a floating-point unit it is 800 bytes larger, because it also keeps what is the same for
/// all rows of its first six solids.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static SCENE: Scene = Scene::new(
///     &[Solid::new(&BALL, Rgb::WHITE)],
///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
/// );
///
/// let picture = SCENE.picture(240, 240);
/// let mut row = [Rgb565::default(); 240];
/// for y in 0..240 {
///     picture.row(y, &mut row);
///     // … hand the row to the display, by DMA for example.
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Picture<'a> {
    scene: Scene<'a>,
    plan: Plan,
    width: u32,
    height: u32,
}

impl<'a> Scene<'a> {
    /// The scene as a picture of `width` columns and `height` rows. Both may be zero: then it has no pixels.
    #[must_use]
    #[inline]
    pub const fn picture(&self, width: u32, height: u32) -> Picture<'a> {
        Picture { scene: *self, plan: Plan::of(self, width, height), width, height }
    }
}

impl Picture<'_> {
    /// How many pixels a row has.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// How many rows there are.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// The columns of row y that a round panel of the picture's size shows: those whose pixels lie within the
    /// circle about the middle of the picture that touches its nearer two edges, or partly within it. Rows
    /// outside the circle have none.
    ///
    /// ```
    /// # use embedded_lathe::*;
    /// # static SCENE: Scene = Scene::new(
    /// #     &[],
    /// #     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    /// #     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// # );
    /// let picture = SCENE.picture(240, 240);
    /// let asked: u32 = (0..240).map(|y| picture.disc_of_row(y).len() as u32).sum();
    /// assert_eq!((picture.disc_of_row(0), picture.disc_of_row(120)), (104..136, 0..240));
    /// assert!(asked < 240 * 240 * 4 / 5);
    /// ```
    #[must_use]
    pub fn disc_of_row(&self, y: u32) -> Range<u32> {
        // In halves of a pixel: the radius, and the distances of the row's upper and lower edge from the
        // middle.
        let radius = u64::from(self.width.min(self.height));
        let (middle, upper) = (u64::from(self.height), 2 * u64::from(y));
        let nearest = upper.saturating_sub(middle).max(middle.saturating_sub(upper + 2));
        if nearest >= radius {
            return 0..0;
        }
        // Half of the chord at the nearer edge, rounded up.
        let square = radius * radius - nearest * nearest;
        let root = square.isqrt();
        let half = root + u64::from(root * root < square);
        // `half` is at most the radius, and so at most the width.
        let left = ((u64::from(self.width) - half) / 2) as u32;
        left..self.width - left
    }

    /// Which solid the pixel in column x of row y shows, and where its ray hits it; `None` if it shows none,
    /// or if the picture has no columns.
    #[must_use]
    pub fn pick(&self, x: u32, y: u32) -> Option<Pick> {
        let ray = self.scene.camera.ray(x, y, self.width, self.height);
        if self.width == 0 { None } else { self.scene.nearest(&ray, 0.0) }
    }

    /// Writes the pixels of row y, counted from the top, into `row` from its start: as many as the picture is
    /// wide, or as `row` is long. What `row` has beyond the picture's width stays as it is.
    ///
    /// A row below the last one continues the scene below the picture's lower edge. A picture without columns
    /// or without rows has no pixels: all of `row` stays as it is.
    pub fn row<C: Paint>(&self, y: u32, row: &mut [C]) {
        self.part_of_row(0, y, row);
    }

    /// Writes the pixels of row y from column x on into `part`, as [`Picture::row`] does those from column 0
    /// on: as many as the row still has there, or as `part` is long.
    ///
    /// A long part costs less than many short ones, since neighbouring pixels share work. Into whatever parts
    /// a row is cut, its pixels are the same, except where rounding decides between two shades, or between
    /// the two sides of a crease. If the eye is at most 200 sizes of the solids away, fewer than one pixel of
    /// 10000 differs in `Rgb565`, and fewer than one of 5000 in `Rgb888`. With parts of a single pixel, where
    /// more rays are cast one by one, it is one of 1000 at most.
    pub fn part_of_row<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        self.raster().part_of_row(x, y, part);
    }

    /// The scene that it shows.
    #[must_use]
    pub const fn scene(&self) -> &Scene<'_> {
        &self.scene
    }

    /// What the picture's rows are computed from, by reference.
    pub(crate) const fn raster(&self) -> Raster<'_> {
        let Self { scene, plan, width, height } = self;
        Raster { scene, plan, width: *width, height: *height }
    }
}
