/// The threshold of column x, row y, from 0 to 63: Bayer's 8×8 matrix, whose bits are those of y and x ⊕ y,
/// interleaved, the lowest first (Bayer 1973).
///
/// Over any 8×8 pixels each of the 64 thresholds comes up once, and any share of them is spread as evenly as
/// it can be.
pub(super) const fn threshold(x: u32, y: u32) -> u32 {
    let mixed = x ^ y;
    (mixed & 1) << 5 | (y & 1) << 4 | (mixed & 2) << 2 | (y & 2) << 1 | (mixed & 4) >> 1 | (y & 4) >> 2
}

/// The shade, of those from 0 to `most`, for a share of light, such that its mean over 8×8 pixels is the
/// share, within 1/128 of a shade.
pub(super) fn dithered(share: f32, most: u8, x: u32, y: u32) -> u8 {
    let exact = share * most as f32;
    let offset = (threshold(x, y) as f32 + 0.5) * (1.0 / 64.0);
    // Conversion cuts off what is negative and makes NaN 0.
    ((exact + offset) as u32).min(most.into()) as u8
}

/// The nearest shade, of those from 0 to `most`.
pub(super) fn nearest(share: f32, most: u8) -> u8 {
    ((share * most as f32 + 0.5) as u32).min(most.into()) as u8
}
