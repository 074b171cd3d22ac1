use crate::color::Shades;

/// The threshold of column x, row y, from 0 to 63: an entry of Bayer's 8×8 matrix (Bayer 1973), whose bits
/// are those of x ⊕ y and y in turn, the lowest bits of both being the entry's highest.
///
/// In any 8×8 pixels each of the 64 thresholds occurs once, and those below any limit are spread evenly.
pub(super) const fn threshold(x: u32, y: u32) -> u32 {
    let mixed = x ^ y;
    (mixed & 1) << 5 | (y & 1) << 4 | (mixed & 2) << 2 | (y & 2) << 1 | (mixed & 4) >> 1 | (y & 4) >> 2
}

/// The shade below or above a brightness, such that the mean over 8×8 pixels is the brightness to within
/// 1/128 of a shade. The brightness is given as the sum of three channels, each with its bias of half a
/// shade.
#[inline]
pub(super) const fn dithered(biased_sum: u32, x: u32, y: u32) -> u8 {
    let threshold = (2 * threshold(x, y) + 1) * (Shades::ONE / 128);
    ((biased_sum + threshold).saturating_sub(Shades::ONE / 2 * 3) / Shades::ONE) as u8
}
