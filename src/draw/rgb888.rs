//! A display's color as a solid's, in a `const`.

use crate::color::Rgb;
use core::mem::transmute;
use embedded_graphics_core::pixelcolor::Rgb888;

impl Rgb {
    /// A color of embedded-graphics, for a `static` scene: `From` does the same for all of its colors, but
    /// not in a `const`.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, Rgb888, WebColors};
    /// use embedded_lathe::Rgb;
    ///
    /// const TEAL: Rgb = Rgb::from_rgb888(Rgb888::CSS_TEAL);
    /// assert_eq!(TEAL, Rgb::from_u8(0, 128, 128));
    /// assert_eq!(TEAL, Rgb::from(Rgb888::CSS_TEAL));
    /// assert_eq!(Rgb::from(Rgb565::new(31, 0, 0)), Rgb::new(1.0, 0.0, 0.0));
    /// ```
    #[must_use]
    pub const fn from_rgb888(color: Rgb888) -> Self {
        let bits = bits(color);
        Self::from_u8((bits >> 16) as u8, (bits >> 8) as u8, bits as u8)
    }
}

/// Red, green and blue, 8 bits each, red the highest: what the color's own accessors give, which are no
/// `const`.
#[allow(unsafe_code)]
const fn bits(color: Rgb888) -> u32 {
    // SAFETY: any bits are a `u32`. That these are initialized, and mean what is said, is evaluated below.
    unsafe { transmute(color) }
}

/// A release of embedded-graphics-core that keeps its colors in another way does not compile: here each bit
/// is tried.
const _: () = {
    let mut bit = 0;
    while bit < 24 {
        let is = 1_u32 << bit;
        assert!(bits(Rgb888::new((is >> 16) as u8, (is >> 8) as u8, is as u8)) == is);
        bit += 1;
    }
};
