//! A display's colours. Those with 5 bits a channel or more take the nearest shade, those with fewer are
//! dithered.

use super::dither::{dithered, nearest};
use crate::color::{Paint, Rgb};
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};

macro_rules! channels {
    ($($colour:ty),*) => {$(
        impl Paint for $colour {
            #[inline(always)]
            fn paint(colour: Rgb, _: u32, _: u32) -> Self {
                Self::new(
                    nearest(colour.r, Self::MAX_R),
                    nearest(colour.g, Self::MAX_G),
                    nearest(colour.b, Self::MAX_B),
                )
            }
        }
    )*};
}

channels!(Rgb555, Bgr555, Rgb565, Bgr565, Rgb666, Bgr666, Rgb888, Bgr888);

/// How bright a colour is: the weights of ITU-R BT.601.
#[inline(always)]
fn luma(colour: Rgb) -> f32 {
    0.299 * colour.r + 0.587 * colour.g + 0.114 * colour.b
}

impl Paint for Gray8 {
    #[inline(always)]
    fn paint(colour: Rgb, _: u32, _: u32) -> Self {
        Self::new(nearest(luma(colour), 255))
    }
}

impl Paint for Gray4 {
    #[inline(always)]
    fn paint(colour: Rgb, x: u32, y: u32) -> Self {
        Self::new(dithered(luma(colour), 15, x, y))
    }
}

impl Paint for Gray2 {
    #[inline(always)]
    fn paint(colour: Rgb, x: u32, y: u32) -> Self {
        Self::new(dithered(luma(colour), 3, x, y))
    }
}

impl Paint for BinaryColor {
    #[inline(always)]
    fn paint(colour: Rgb, x: u32, y: u32) -> Self {
        Self::from(dithered(luma(colour), 1, x, y) == 1)
    }
}
