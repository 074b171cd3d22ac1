/// Returns 1/√(2·x) within 10⁻⁶, for positive normal x; for any other x the result is unspecified, and may be
/// NaN. It takes additions and multiplications only: the same bits everywhere, and less than half of the time
/// of a square root and a division on a Cortex-M4F.
///
/// For 1/√x the seed y is computed from the bits of x, as Walsh did it. Of all constants 0x5f37_642f makes
/// the best seed, within 3.422 % (Lomont, “Fast inverse square root”, 2003). The constant here is that one
/// rounded to 0x5f37_6800, with which the seed is within 3.431 %.
///
/// Two steps `y ← y·(3/2 + d − x/2·y²)` follow. One step turns a relative error e into
/// `d·(1 + e) − (3·e² + e³)/2`. With d = 0 it would be Newton's step, whose errors are all to one side; with
/// d = 8.8·10⁻⁴ the first step leaves ±8.8·10⁻⁴ (`laboratory/tests/fits.rs`). Of an error of that size
/// Newton's step would leave 3·e²/2 = 1.2·10⁻⁶. The second step, whose d is 3.6·10⁻⁷, leaves 8·10⁻⁷, to which
/// rounding adds.
///
/// With 2·x in place of x, x/2 in the steps is x itself, which spares a product. The bits of 2·x are those of
/// x plus [`EXPONENT`]; half of that is taken from the seed's constant.
pub(crate) fn rsqrt_of_double(x: f32) -> f32 {
    let y = f32::from_bits((0x5f37_6800 - EXPONENT / 2).wrapping_sub(x.to_bits() >> 1));
    let y = y * (1.500_879_8 - x * (y * y));
    y * (1.500_000_4 - x * (y * y))
}

/// One in the exponent of a number, among its bits.
const EXPONENT: u32 = 1 << 23;

#[cfg(test)]
mod tests {
    use super::rsqrt_of_double;

    #[test]
    fn is_as_close_as_it_says() {
        // Two octaves are all that differ by more than an exponent.
        let worst =
            (0.5f32.to_bits()..2f32.to_bits()).step_by(7).map(f32::from_bits).fold(0.0, |worst, x| {
                let error = f64::from(rsqrt_of_double(x)) * (2.0 * f64::from(x)).sqrt() - 1.0;
                f64::max(worst, error.abs())
            });
        assert!((0.25e-6..=1e-6).contains(&worst), "{worst}");
        for x in [f32::MIN_POSITIVE, 1e-30, 1e30, f32::MAX] {
            let error = f64::from(rsqrt_of_double(x)) * (2.0 * f64::from(x)).sqrt() - 1.0;
            assert!(error.abs() <= 1e-6, "{x}: {error}");
        }
    }
}
