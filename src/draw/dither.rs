//! Ordered dithering, for displays with few shades.

use crate::color::Shades;

/// The threshold of column x, row y, from 0 to 63: an entry of Bayer's 8×8 matrix (Bayer 1973). Its six bits,
/// from the highest to the lowest, are bit 0 of x ⊕ y, bit 0 of y, bit 1 of x ⊕ y, bit 1 of y, bit 2 of
/// x ⊕ y, bit 2 of y.
///
/// In any 8×8 pixels each of the 64 thresholds occurs once, and the pixels whose threshold is below a limit
/// are spread evenly, for every limit.
pub(super) const fn threshold(x: u32, y: u32) -> u32 {
    let mixed = x ^ y;
    (mixed & 1) << 5 | (y & 1) << 4 | (mixed & 2) << 2 | (y & 2) << 1 | (mixed & 4) >> 1 | (y & 4) >> 2
}

/// A brightness rounded down or up to a whole shade, depending on the pixel's threshold, so that the mean
/// over 8×8 pixels differs from the brightness by at most 1/128 of a shade. The brightness is given as the
/// sum of the three channels, each with the rounding bias of half a shade.
#[inline]
pub(super) const fn dithered(biased_sum: u32, x: u32, y: u32) -> u8 {
    let threshold = (2 * threshold(x, y) + 1) * (Shades::ONE / 128);
    ((biased_sum + threshold).saturating_sub(Shades::ONE / 2 * 3) / Shades::ONE) as u8
}
