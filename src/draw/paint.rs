//! [`Paint`] for the colors of embedded-graphics. Those with 5 bits or more for each channel get the nearest
//! shade; those with fewer are dithered.

use super::dither::dithered;
use crate::color::{Paint, Rgb, Shades, nearest};
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666,
    Rgb888, RgbColor,
};

macro_rules! channels {
    ($($color:ty),*) => {$(
        impl Paint for $color {
            const SHADES: Rgb = Rgb::new(Self::MAX_R as f32, Self::MAX_G as f32, Self::MAX_B as f32);
            const IS_UNIFORM: bool = true;

            #[inline]
            fn shade(shades: Shades, _: u32, _: u32) -> Self {
                let [r, g, b] = shades.nearest();
                Self::new(r, g, b)
            }
        }

        impl From<$color> for Rgb {
            fn from(color: $color) -> Self {
                let [r, g, b] = [color.r(), color.g(), color.b()].map(f32::from);
                let most = <$color>::SHADES;
                Self::new(r / most.r, g / most.g, b / most.b)
            }
        }
    )*};
}

channels!(Rgb555, Bgr555, Rgb565, Bgr565, Rgb666, Bgr666, Rgb888, Bgr888);

/// How many shades each of red, green and blue contributes to the brightness of a gray, given its brightest
/// shade: the weights of ITU-R BT.601 times that.
const fn luma(most: f32) -> Rgb {
    Rgb::new(0.299 * most, 0.587 * most, 0.114 * most)
}

macro_rules! grays {
    ($($color:ty: $most:literal),*) => {$(
        impl From<$color> for Rgb {
            fn from(color: $color) -> Self {
                Self::gray(f32::from(color.luma()) / $most)
            }
        }
    )*};
}

grays!(Gray8: 255.0, Gray4: 15.0, Gray2: 3.0);

impl From<BinaryColor> for Rgb {
    fn from(color: BinaryColor) -> Self {
        if color.is_on() { Self::WHITE } else { Self::BLACK }
    }
}

/// The brightness in shades: the sum of the weighted channels. Because each channel carries the rounding bias
/// of half a shade, the sum is one and a half shades too large. `dithered` subtracts all of the excess;
/// `Gray8` subtracts one shade and keeps half a shade as its own rounding bias.
#[inline]
fn sum(shades: Shades) -> u32 {
    shades.r + shades.g + shades.b
}

impl Paint for Gray8 {
    const SHADES: Rgb = luma(255.0);
    const IS_UNIFORM: bool = true;

    #[inline]
    fn shade(shades: Shades, _: u32, _: u32) -> Self {
        Self::new(nearest(sum(shades).saturating_sub(Shades::ONE)))
    }
}

impl Paint for Gray4 {
    const SHADES: Rgb = luma(15.0);

    #[inline]
    fn shade(shades: Shades, x: u32, y: u32) -> Self {
        Self::new(dithered(sum(shades), x, y))
    }
}

impl Paint for Gray2 {
    const SHADES: Rgb = luma(3.0);

    #[inline]
    fn shade(shades: Shades, x: u32, y: u32) -> Self {
        Self::new(dithered(sum(shades), x, y))
    }
}

impl Paint for BinaryColor {
    const SHADES: Rgb = luma(1.0);

    #[inline]
    fn shade(shades: Shades, x: u32, y: u32) -> Self {
        Self::from(dithered(sum(shades), x, y) == 1)
    }
}
