//! A square root, a sine and a cosine as `const fn`s, which neither `core` nor the libraries have yet.
//!
//! They compute what is computed once, when a scene is made. Operations in a fixed order, each correctly
//! rounded, give the same bits in the compiler, on the host and on the target.

/// Returns √x, within one unit in the last place, for positive normal x, and 0 for any other x: also for
/// infinity and NaN.
///
/// Heron's rule, `y ← (y + x/y)/2`, is applied four times. One step turns a relative error e into
/// e²/(2 + 2·e), so that the seed's error of ±3.48 % becomes 6.3·10⁻⁴, 2·10⁻⁷, 2·10⁻¹⁴, and rounding.
///
/// The seed is made of bits: half of those of x, which halves the exponent, plus half of those of 1,
/// 0x1fc0_0000. Since the mantissa is halved, too, that would be up to 6.1 % above √x (for x = 2: 3/2) and
/// never below it; subtracting 0.0366·2²³ makes the largest error the same to both sides.
pub const fn sqrt(x: f32) -> f32 {
    if !(x >= f32::MIN_POSITIVE && x < f32::INFINITY) {
        return 0.0;
    }
    let mut y = f32::from_bits((x.to_bits() >> 1) + 0x1fbb_4f2e);
    let mut step = 0;
    while step < 4 {
        y = 0.5 * (y + x / y);
        step += 1;
    }
    y
}

/// Returns an upper bound of √x, above it by at most 6.1 % and less rounding, for positive normal x. For zero
/// and subnormal x it is positive, for infinity and NaN it is that.
///
/// It is the mean of p and x/p, never less than their geometric mean, √x. The power of two p is between
/// √(x/2) and √(2·x): so the bound is largest for x = 2, 3/2.
pub const fn upper_root(x: f32) -> f32 {
    // Half of the exponent, rounded up; the bias is 127.
    let half = ((x.to_bits() >> 23) as i32 - 126) >> 1;
    let (p, per_p) =
        (f32::from_bits(((127 + half) as u32) << 23), f32::from_bits(((127 - half) as u32) << 23));
    0.5 * (p + x * per_p)
}

/// Returns the sine and the cosine of an angle in radians. Each is within 2·10⁻⁷ for |angle| up to 10 000;
/// both are NaN for |angle| of 10 001 or more, and for NaN; between 10 000 and 10 001 either may be the case.
///
/// First the nearest multiple of π/2 is subtracted, with π/2 as a sum of three parts (Cody and Waite 1980).
/// The first two have 8 and 11 bits: their products with up to 6366, which has 13 bits, are exact, and so are
/// the subtractions. Then Taylor's series are evaluated over [−π/4, π/4]; the first term omitted is below
/// 2·10⁻⁹ for the sine, and below 2.5·10⁻⁸ for the cosine.
pub const fn sin_cos(angle: f32) -> (f32, f32) {
    // The quarter turns in 10 000 radians: 10 000·2/π = 6366.2.
    const MOST_QUARTERS: u32 = 6_366;
    const QUARTER: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];
    let quarters = (angle * core::f32::consts::FRAC_2_PI + if angle < 0.0 { -0.5 } else { 0.5 }) as i32;
    let n = quarters as f32;
    let r = ((angle - n * QUARTER[0]) - n * QUARTER[1]) - n * QUARTER[2];
    let r = if quarters.unsigned_abs() > MOST_QUARTERS { f32::NAN } else { r };
    let square = r * r;
    let sin = r
        * (1.0
            + square
                * (-1.0 / 6.0 + square * (1.0 / 120.0 + square * (-1.0 / 5_040.0 + square / 362_880.0))));
    let cos = 1.0 + square * (-0.5 + square * (1.0 / 24.0 + square * (-1.0 / 720.0 + square / 40_320.0)));
    match quarters & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::upper_root;

    #[test]
    fn an_upper_root_is_just_above_the_root() {
        let mut worst: f32 = 0.0;
        for bits in (f32::MIN_POSITIVE.to_bits()..f32::INFINITY.to_bits()).step_by(99_991) {
            let x = f32::from_bits(bits);
            let ratio = f64::from(upper_root(x)) / f64::from(x).sqrt();
            assert!((1.0 - 1e-7..1.0607).contains(&ratio), "{ratio} for {x}");
            worst = worst.max(ratio as f32);
        }
        assert!(worst > 1.0605, "the bound is slack: {worst}");
        assert!(
            upper_root(f32::INFINITY) == f32::INFINITY
                && upper_root(f32::NAN).is_nan()
                && upper_root(0.0) > 0.0
        );
    }
}
