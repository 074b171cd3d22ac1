//! A square root, a sine and a cosine that a `const` can call: `core` has none yet, and neither have the
//! libraries.
//!
//! For what is computed once, when a scene is made. Additions and multiplications in a fixed order, so the
//! compiler, the host and the target find the same bits.

/// √x for positive normal x, within one unit in the last place; 0 for anything else.
///
/// Heron's rule, `y ← (y + x/y)/2`, from half the exponent: 6 % off, then 2·10⁻³, 2·10⁻⁶, 2·10⁻¹², rounding.
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

/// Sine and cosine of an angle in radians, each within 2·10⁻⁷ for |angle| up to 10 000, NaN from 10 001 on.
///
/// The angle less the nearest multiple of π/2 (held in three parts, so that taking the first two off is exact; Cody and
/// Waite 1980), then Taylor's series over [−π/4, π/4], whose first omitted terms are below 2·10⁻⁹ and 2.5·10⁻⁸.
pub const fn sin_cos(angle: f32) -> (f32, f32) {
    // 10 000 is no more than so many.
    const MOST: u32 = 6_366;
    const PARTS: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];
    let quarters = (angle * core::f32::consts::FRAC_2_PI + if angle < 0.0 { -0.5 } else { 0.5 }) as i32;
    let n = quarters as f32;
    let r = ((angle - n * PARTS[0]) - n * PARTS[1]) - n * PARTS[2];
    let r = if quarters.unsigned_abs() > MOST { f32::NAN } else { r };
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
