use super::Math;
use micromath::F32Ext;

/// The [micromath](https://docs.rs/micromath) crate: small, fast, and within a few percent.
///
/// Its cube root, arc cosine and cosine serve as they are, as seeds. Its reciprocal square root y is brought
/// to full accuracy by three Newton steps, `y ← y·(3/2 − x/2·y²)`, without a division. Each step leaves 3/2
/// of the square of the relative error: 3.5 %, 0.2 %, 5·10⁻⁶, rounding.
///
/// ```
/// use embedded_lathe::math::{Math, Micromath};
/// assert!((Micromath::sqrt(2.0) - 2_f32.sqrt()).abs() < 2e-7);
/// assert!((Micromath::acos(0.5) - 0.5_f32.acos()).abs() < 0.03); // a seed
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Micromath;

impl Math for Micromath {
    fn sqrt(x: f32) -> f32 {
        // Below 10⁻³⁰ intermediate results would underflow: x is multiplied by 2⁴⁸, and its root divided by
        // 2²⁴.
        let (x, back) = if x < 1.0e-30 { (x * SCALE, 1.0 / ROOT_SCALE) } else { (x, 1.0) };
        if !(x > 0.0 && x < f32::INFINITY) {
            // ±0 and +∞ are their own roots. The root of a negative number or NaN is NaN.
            return if x >= 0.0 { x } else { f32::NAN };
        }
        let half = 0.5 * x;
        let mut y = F32Ext::invsqrt(x);
        for _ in 0..3 {
            y *= 1.5 - half * y * y;
        }
        let root = x * y;
        // y is 1/√x. One Newton step on the root itself removes the rounding of x·y.
        (root + 0.5 * y * (x - root * root)) * back
    }

    fn cbrt(x: f32) -> f32 {
        F32Ext::copysign(F32Ext::powf(F32Ext::abs(x), 1.0 / 3.0), x)
    }

    fn acos(x: f32) -> f32 {
        F32Ext::acos(x)
    }

    fn cos(x: f32) -> f32 {
        F32Ext::cos(x)
    }
}

/// By what a small root is scaled, 2²⁴, and by what its square is.
const ROOT_SCALE: f32 = (1_u32 << 24) as f32;
const SCALE: f32 = ROOT_SCALE * ROOT_SCALE;
