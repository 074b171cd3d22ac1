//! Colours as the renderer reckons with them.

use crate::math::order::{greater, lesser};

/// A colour as a display shows it: red, green and blue from 0 to 1. Light scales it; nothing is
/// gamma-corrected.
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
    /// No light.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);
    /// All of it.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0);

    /// From shares, 0 to 1. What lies outside is cut off where it is painted, and NaN is painted black.
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// From bytes, 0 to 255.
    pub const fn from_u8(r: u8, g: u8, b: u8) -> Self {
        Self::new(r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0)
    }

    /// A grey.
    pub const fn gray(share: f32) -> Self {
        Self::new(share, share, share)
    }

    /// Dimmed to a share of itself.
    #[inline(always)]
    pub(crate) const fn dimmed(self, share: f32) -> Self {
        Self { r: self.r * share, g: self.g * share, b: self.b * share }
    }

    /// With a share of another colour added.
    #[inline(always)]
    pub(crate) const fn with(self, other: Self, share: f32) -> Self {
        Self { r: self.r + share * other.r, g: self.g + share * other.g, b: self.b + share * other.b }
    }

    /// No channel more than another colour's.
    pub(crate) const fn least(self, most: Self) -> Self {
        Self { r: lesser(self.r, most.r), g: lesser(self.g, most.g), b: lesser(self.b, most.b) }
    }

    /// In shades, of which there are `most`. What lies outside 0 to 1 is cut off, and nothing is in place of what
    /// is not a number.
    #[inline(never)]
    pub(crate) fn shades(self, most: Self) -> Self {
        let cut = |share: f32| lesser(1.0, greater(0.0, share));
        Self { r: cut(self.r) * most.r, g: cut(self.g) * most.g, b: cut(self.b) * most.b }
    }

    /// From this colour, at 0, to another, at 1.
    pub(crate) const fn towards(self, other: Self, share: f32) -> Self {
        Self {
            r: self.r + share * (other.r - self.r),
            g: self.g + share * (other.g - self.g),
            b: self.b + share * (other.b - self.b),
        }
    }
}

/// A colour that a picture can be painted in.
///
/// Implemented for [`Rgb`] and for the colours of embedded-graphics, those of few shades by ordered
/// dithering.
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
    /// How many shades above black red, green and blue have: what a share of 1 is in shades.
    const SHADES: Rgb;

    /// What stands in column x, row y, for a colour in shades, each from 0 to that of `SHADES`, or beyond by
    /// rounding.
    fn shade(shades: Rgb, x: u32, y: u32) -> Self;

    /// What stands for the colour in column x, row y.
    fn paint(colour: Rgb, x: u32, y: u32) -> Self {
        Self::shade(colour.shades(Self::SHADES), x, y)
    }
}

impl Paint for Rgb {
    const SHADES: Rgb = Rgb::WHITE;

    #[inline(always)]
    fn shade(shades: Rgb, _: u32, _: u32) -> Self {
        shades
    }
}

/// What is seen where no solid is.
///
/// ```
/// use embedded_lathe::{Background, Rgb};
/// const DUSK: Background = Background::Gradient { top: Rgb::BLACK, bottom: Rgb::new(0.2, 0.1, 0.3) };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Background {
    /// One colour.
    Plain(Rgb),
    /// A vertical gradient, from the upper edge of the picture to the lower.
    Gradient {
        /// At the upper edge.
        top: Rgb,
        /// At the lower edge.
        bottom: Rgb,
    },
}

impl Background {
    /// The colour of a row, of so many.
    #[inline(always)]
    pub(crate) fn row(&self, y: u32, rows: u32) -> Rgb {
        match *self {
            Self::Plain(colour) => colour,
            Self::Gradient { top, bottom } => top.towards(bottom, (y as f32 + 0.5) / rows as f32),
        }
    }
}
