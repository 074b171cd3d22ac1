use crate::color::Shades;

/// The threshold of column x, row y, from 0 to 63: Bayer's 8×8 matrix, whose bits are those of y and x ⊕ y,
/// interleaved, the lowest first (Bayer 1973).
///
/// Over any 8×8 pixels each of the 64 thresholds comes up once, and any share of them is spread as evenly as
/// it can be.
pub(super) const fn threshold(x: u32, y: u32) -> u32 {
    let mixed = x ^ y;
    (mixed & 1) << 5 | (y & 1) << 4 | (mixed & 2) << 2 | (y & 2) << 1 | (mixed & 4) >> 1 | (y & 4) >> 2
}

/// A whole shade for a broken one, such that its mean over 8×8 pixels is that one, within 1/128; given the sum of three
/// channels in shades, each of which carries half a shade more.
#[inline]
pub(super) const fn dithered(biased_sum: u32, x: u32, y: u32) -> u8 {
    let threshold = (2 * threshold(x, y) + 1) * (Shades::ONE / 128);
    ((biased_sum + threshold).saturating_sub(Shades::ONE / 2 * 3) / Shades::ONE) as u8
}
