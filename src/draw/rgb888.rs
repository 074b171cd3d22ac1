//! The conversion of `Rgb888` to [`Rgb`] in a `const`.

use crate::color::Rgb;
use core::mem::transmute;
use embedded_graphics_core::pixelcolor::Rgb888;

impl Rgb {
    /// Converts a color of embedded-graphics in a `const`, for a `static` scene. `From` converts all of its
    /// colors, but not in a `const`.
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

/// Red, green and blue in 8 bits each, red in the highest of the 24. The color's own accessors return the
/// same, but are not `const`.
#[allow(unsafe_code)]
const fn bits(color: Rgb888) -> u32 {
    // SAFETY: every bit pattern is a valid `u32`. The check below proves at compile time that all 32 bits are
    // initialized and that each of the 24 stands where this function's doc says.
    unsafe { transmute(color) }
}

/// Checks `bits` for each single bit of a color. With a release of embedded-graphics-core that stores its
/// colors in another way the crate does not compile.
const _: () = {
    let mut bit = 0;
    while bit < 24 {
        let is = 1_u32 << bit;
        assert!(bits(Rgb888::new((is >> 16) as u8, (is >> 8) as u8, is as u8)) == is);
        bit += 1;
    }
};
