//! Numbers in fixed point, and their scalar products.

use super::words::product;
use crate::vector::F32x3;

/// The scalar product of two vectors of two components.
#[inline(never)]
pub(crate) const fn dot([ax, ay]: [i32; 2], [bx, by]: [i32; 2]) -> i64 {
    product(ax, bx) + product(ay, by)
}

/// The number x in units of 2^−`bits`, rounded to the nearest; a half is rounded away from zero. What is
/// beyond the range of `i32`, infinity and NaN included, becomes `i32::MAX` with the sign of x.
#[inline(never)]
pub(crate) const fn fixed(x: f32, bits: i32) -> i32 {
    let raw = x.to_bits();
    // A normal x is its mantissa times 2^(exponent − 150). For zero and subnormal x this mantissa is wrong,
    // but below half a unit, as long as there are fewer than 126 bits.
    let mantissa = raw as i32 & 0x7f_ffff | 0x80_0000;
    let shift = (raw >> 23 & 0xff) as i32 - 150 + bits;
    let magnitude = if shift > 7 {
        i32::MAX
    } else if shift >= 0 {
        mantissa << shift
    } else if shift > -26 {
        ((mantissa >> (-1 - shift)) + 1) >> 1
    } else {
        0
    };
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

/// The number x in units of 2^−`bits`, its magnitude rounded down. In place of a magnitude beyond 2⁶¹ units
/// it may return any magnitude of 2⁶¹ units or more, with the sign of x.
// As in `fixed`, the mantissa of zero and of a subnormal x is below half a unit.
#[inline(never)]
pub(crate) fn wide(x: f32, bits: i32) -> i64 {
    let raw = x.to_bits();
    let mantissa = i64::from(raw & 0x7f_ffff | 0x80_0000);
    let magnitude = shifted(mantissa, ((raw >> 23 & 0xff) as i32 - 150 + bits).min(38));
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

/// A number times 2^`left`, rounded down. The result must be in the range of `i64`.
#[inline(never)]
pub(crate) const fn shifted(x: i64, left: i32) -> i64 {
    if left >= 0 { x << (left & 63) } else { x >> (if left > -63 { -left } else { 63 }) }
}

/// The components of a vector in units of 2^−`bits`, each as by [`fixed`].
// Always inline: a result that is returned in memory is copied from there by `memcpy`.
#[inline(always)]
pub(crate) const fn fixed_vector(v: F32x3, bits: i32) -> [i32; 3] {
    [fixed(v.x, bits), fixed(v.y, bits), fixed(v.z, bits)]
}

/// The least e with |x| < 2^e, for normal x; −126 for zero and subnormal x.
#[inline(always)]
pub(crate) const fn exponent(x: f32) -> i32 {
    (x.to_bits() >> 23 & 0xff) as i32 - 126
}

/// 2^e; 2⁻¹²⁶ for a lower e, 2¹²⁷ for a higher one.
#[inline(never)]
pub(crate) const fn power_of_two(e: i32) -> f32 {
    let e = if e < -126 {
        -126
    } else if e > 127 {
        127
    } else {
        e
    };
    f32::from_bits(((127 + e) as u32) << 23)
}

#[cfg(test)]
mod tests {
    use super::{exponent, fixed, power_of_two};

    #[test]
    fn a_number_is_rounded_to_the_nearest_unit() {
        assert_eq!([fixed(0.75, 2), fixed(0.374, 2), fixed(-0.376, 2), fixed(0.0, 30)], [3, 1, -2, 0]);
        assert_eq!(
            [fixed(0.1, 20), fixed(-1.0, 30), fixed(1.999_999_9, 30)],
            [104_858, -1 << 30, 0x7fff_ff80]
        );
        assert_eq!(
            [fixed(1.0, 31), fixed(-9e9, 3), fixed(f32::INFINITY, -40)],
            [i32::MAX, -i32::MAX, i32::MAX]
        );
        assert_eq!([fixed(1e-30, 31), fixed(f32::MIN_POSITIVE / 4.0, 100), fixed(9e9, -40)], [0; 3]);
    }

    #[test]
    fn exponents_are_those_of_powers() {
        for (x, e) in [(1.0, 1), (0.999, 0), (-4.0, 3), (3.999, 2), (1e-3, -9)] {
            assert_eq!(exponent(x), e, "{x}");
            assert!(x.abs() < power_of_two(e) && x.abs() >= power_of_two(e - 1));
        }
    }
}
