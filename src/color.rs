//! The renderer's colors, and the trait of the display colors that it converts them to.

use crate::arithmetic::Share;

/// A color as a display shows it: red, green and blue from 0 to 1. Light scales the three channels; no gamma
/// correction is applied.
///
/// ```
/// use embedded_lathe::Rgb;
///
/// const TERRACOTTA: Rgb = Rgb::from_u8(204, 102, 77);
/// assert_eq!(TERRACOTTA, Rgb::new(0.8, 0.4, 77.0 / 255.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

impl Rgb {
    /// Black.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);
    /// White.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0);

    /// A color of three channels from 0 to 1. When it is painted a channel below 0 or NaN counts as 0, and
    /// one above 1 as 1.
    #[must_use]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// A color of three channels from 0 to 255.
    #[must_use]
    pub const fn from_u8(r: u8, g: u8, b: u8) -> Self {
        Self::new(r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0)
    }

    /// A gray, from black at 0 to white at 1.
    #[must_use]
    pub const fn gray(share: f32) -> Self {
        Self::new(share, share, share)
    }

    /// This color in shades: each channel times that of `most`, its number of shades, which is given four
    /// times. A channel below 0 or NaN counts as 0, and one above 1 as 1.
    #[inline(never)]
    pub(crate) const fn shades(&self, most: &Shades) -> Shades {
        Shades {
            r: Share::up_to_one(self.r).quarter_of(most.r),
            g: Share::up_to_one(self.g).quarter_of(most.g),
            b: Share::up_to_one(self.b).quarter_of(most.b),
        }
    }

    /// Mixes this color with another: `share` 0 gives this one, 1 the other.
    pub(crate) const fn towards(self, other: Self, share: f32) -> Self {
        Self {
            r: self.r + share * (other.r - self.r),
            g: self.g + share * (other.g - self.g),
            b: self.b + share * (other.b - self.b),
        }
    }
}

/// A color in the *shades* of a display, which [`Paint::shade`] receives: red, green and blue in fixed point,
/// in units of 2⁻²¹ of one shade. With it the renderer scales a color by a share of light in three integer
/// multiplications.
///
/// ```
/// use embedded_lathe::{Paint, Rgb, Shades};
///
/// /// Red light only.
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Red(u8);
///
/// impl Paint for Red {
///     const SHADES: Rgb = Rgb::new(255.0, 0.0, 0.0);
///     fn shade(shades: Shades, _x: u32, _y: u32) -> Self {
///         let [red, _, _] = shades.nearest();
///         Self(red)
///     }
/// }
///
/// assert_eq!(Red::paint(Rgb::new(0.5, 1.0, 1.0), 0, 0), Red(128));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shades {
    // The shades that `Paint::shade` receives have half a shade added to each channel, the rounding bias: so
    // the whole part of a channel is its nearest shade. With the bias each channel stays below 256 shades,
    // which are 2²⁹ units: so four times a channel is less than 2³¹, as a `Share` needs it.
    pub(crate) r: u32,
    pub(crate) g: u32,
    pub(crate) b: u32,
}

impl Shades {
    /// One shade, in the units of [`Shades::units`].
    pub const ONE: u32 = 1 << 21;

    /// The nearest whole shade of red, green and blue, of the shades that [`Paint::shade`] receives.
    #[must_use]
    #[inline]
    pub const fn nearest(self) -> [u8; 3] {
        [nearest(self.r), nearest(self.g), nearest(self.b)]
    }

    /// Red, green and blue in units of 1/[`Shades::ONE`] of a shade, not rounded to whole shades, for a
    /// display of few shades to dither. It subtracts the rounding bias that the shades given to
    /// [`Paint::shade`] carry.
    #[must_use]
    #[inline]
    pub const fn units(self) -> [u32; 3] {
        const HALF: u32 = Shades::ONE / 2;
        [self.r.saturating_sub(HALF), self.g.saturating_sub(HALF), self.b.saturating_sub(HALF)]
    }

    /// Converts numbers of shades to fixed point, rounded down; each channel must be below 256. A negative
    /// number and NaN give 0.
    pub(crate) const fn of(shades: Rgb) -> Self {
        const ONE: f32 = Shades::ONE as f32;
        Self { r: (shades.r * ONE) as u32, g: (shades.g * ONE) as u32, b: (shades.b * ONE) as u32 }
    }

    /// A quarter of each channel of these shades times `share`.
    #[inline(always)]
    pub(crate) const fn quarter(self, share: Share) -> Self {
        Self { r: share.quarter_of(self.r), g: share.quarter_of(self.g), b: share.quarter_of(self.b) }
    }

    /// Four times these shades.
    #[inline(always)]
    pub(crate) const fn times_four(self) -> Self {
        Self { r: self.r << 2, g: self.g << 2, b: self.b << 2 }
    }

    /// The sum of these shades and others. It must be below 256 in each channel.
    #[inline(always)]
    const fn with(self, other: Self) -> Self {
        Self {
            r: self.r.wrapping_add(other.r),
            g: self.g.wrapping_add(other.g),
            b: self.b.wrapping_add(other.b),
        }
    }

    /// These shades with the rounding bias, half a shade more in each channel, for [`Paint::shade`].
    #[inline(always)]
    pub(crate) const fn rounded(self) -> Self {
        self.with(Self { r: Self::ONE / 2, g: Self::ONE / 2, b: Self::ONE / 2 })
    }

    /// The sum of these shades and others, each channel limited to that of `most`.
    pub(crate) fn with_up_to(self, other: Self, most: Self) -> Self {
        Self {
            r: self.r.wrapping_add(other.r).min(most.r),
            g: self.g.wrapping_add(other.g).min(most.g),
            b: self.b.wrapping_add(other.b).min(most.b),
        }
    }
}

/// A color that a picture can be painted in.
///
/// [`Rgb`] and the colors of embedded-graphics implement it; those of few shades use ordered dithering.
///
/// ```
/// use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
/// use embedded_lathe::{Paint, Rgb};
///
/// assert_eq!(Rgb565::paint(Rgb::new(1.0, 0.5, 0.0), 0, 0), Rgb565::new(31, 32, 0));
/// // A fifth of the light: a fifth of the pixels.
/// let on = (0..64).filter(|i| BinaryColor::paint(Rgb::gray(0.2), i % 8, i / 8).is_on());
/// assert_eq!(on.count(), 13);
/// ```
pub trait Paint: Copy {
    /// How many shades above black red, green and blue have: a channel of 1 is this many shades. Each number
    /// must be from 0 to 255; otherwise painting in this color does not compile.
    ///
    /// ```compile_fail
    /// use embedded_lathe::{Paint, Rgb, Shades};
    ///
    /// #[derive(Clone, Copy)]
    /// struct TooFine;
    ///
    /// impl Paint for TooFine {
    ///     const SHADES: Rgb = Rgb::gray(1023.0);
    ///     fn shade(_: Shades, _: u32, _: u32) -> Self {
    ///         Self
    ///     }
    /// }
    ///
    /// TooFine::paint(Rgb::WHITE, 0, 0);
    /// // error: evaluation panicked: `Paint::SHADES` must be from 0 to 255
    /// ```
    const SHADES: Rgb;

    /// Whether [`Paint::shade`] and [`Paint::background`] depend on the shades alone, not on the pixel's
    /// column and row. If so, the background of a row is computed for its first pixel only.
    const IS_UNIFORM: bool = false;

    /// The color of the pixel in column x, row y, for a color in shades. Each of its channels is from 0 to
    /// that of `SHADES`; [`Shades::nearest`] and [`Shades::units`] return them.
    fn shade(shades: Shades, x: u32, y: u32) -> Self;

    /// The color of a pixel that shows no solid, given the background's color in shades: the same as a
    /// solid's. [`Option`] returns `None` instead.
    #[inline(always)]
    #[must_use]
    fn background(shades: Shades, x: u32, y: u32) -> Self {
        Self::shade(shades, x, y)
    }

    /// The color of the pixel in column x, row y, for a color of the renderer.
    #[must_use]
    fn paint(color: Rgb, x: u32, y: u32) -> Self {
        Self::shade(color.shades(most_shades::<Self>()).rounded(), x, y)
    }
}

impl Paint for Rgb {
    // A power of two: dividing by it is exact.
    const SHADES: Rgb = Rgb::gray(128.0);
    const IS_UNIFORM: bool = true;

    #[inline(always)]
    fn shade(shades: Shades, _: u32, _: u32) -> Self {
        let share = |units: u32| units as f32 * (1.0 / (128.0 * Shades::ONE as f32));
        let [r, g, b] = shades.units().map(share);
        Rgb::new(r, g, b)
    }
}

/// A color where a solid is seen, and `None` where the background is: for what is drawn over something else.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use embedded_lathe::*;
/// # static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// # static SCENE: Scene = Scene::new(
/// #     &[Solid::new(&BALL, Rgb::WHITE)],
/// #     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
/// #     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
/// # );
///
/// // A row of something else, and a ball over it.
/// let mut row = [Rgb565::new(0, 20, 0); 60];
/// let mut ball = [None; 60];
/// SCENE.picture(60, 60).row(30, &mut ball);
/// for (pixel, ball) in row.iter_mut().zip(ball) {
///     *pixel = ball.unwrap_or(*pixel);
/// }
/// assert!(row[4] == Rgb565::new(0, 20, 0) && row[5] != row[4]);
/// ```
impl<C: Paint> Paint for Option<C> {
    const SHADES: Rgb = C::SHADES;
    const IS_UNIFORM: bool = C::IS_UNIFORM;

    #[inline(always)]
    fn shade(shades: Shades, x: u32, y: u32) -> Self {
        Some(C::shade(shades, x, y))
    }

    #[inline(always)]
    fn background(_: Shades, _: u32, _: u32) -> Self {
        None
    }
}

/// Four times [`Paint::SHADES`], after a check at compile time that each channel is from 0 to 255.
pub(crate) const fn most_shades<C: Paint>() -> &'static Shades {
    const {
        let Rgb { r, g, b } = C::SHADES;
        assert!(
            0.0 <= r && r <= 255.0 && 0.0 <= g && g <= 255.0 && 0.0 <= b && b <= 255.0,
            "`Paint::SHADES` must be from 0 to 255"
        );
        &Shades::of(C::SHADES).times_four()
    }
}

/// The nearest shade of a channel that carries the rounding bias: the whole part of the channel.
#[inline]
pub(crate) const fn nearest(biased: u32) -> u8 {
    (biased / Shades::ONE) as u8
}

/// The background of a scene: what a pixel shows where no solid is.
///
/// ```
/// use embedded_lathe::{Background, Rgb};
/// const DUSK: Background = Background::Gradient { top: Rgb::BLACK, bottom: Rgb::new(0.2, 0.1, 0.3) };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Background {
    /// One color.
    Plain(Rgb),
    /// A vertical gradient, from the upper edge of the picture to the lower.
    Gradient {
        /// At the upper edge.
        top: Rgb,
        /// At the lower edge.
        bottom: Rgb,
    },
}

impl Default for Background {
    /// Black.
    fn default() -> Self {
        Self::BLACK
    }
}

impl Background {
    /// Black.
    pub const BLACK: Self = Self::Plain(Rgb::BLACK);

    /// The background's color at the middle of row y, of a picture that has `rows` rows.
    #[inline(always)]
    pub(crate) fn row(&self, y: u32, rows: u32) -> Rgb {
        match *self {
            Self::Plain(color) => color,
            Self::Gradient { top, bottom } => top.towards(bottom, (y as f32 + 0.5) / rows as f32),
        }
    }
}
