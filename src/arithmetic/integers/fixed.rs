//! Numbers in fixed point, and their products.

use crate::vector::F32x3;

/// The high word of a signed product: `a·b/2³²`, rounded down.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) const fn high(a: i32, b: i32) -> i32 {
    ((a as i64 * b as i64) >> 32) as i32
}

/// The high word of a signed product: `a·b/2³²`, rounded down. On ARMv6-M a product has 32 bits only; there
/// four products of halves give the same bits in half of the time that the compiler's 64-bit product takes.
/// `cfg` shows by the lack of atomic exchanges that an Arm core is an ARMv6-M.
// Not `inline(always)`: in a build for size, flash should contain it only once.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline]
pub(crate) const fn high(a: i32, b: i32) -> i32 {
    let (a1, a0, b1, b0) = (a >> 16, a & 0xffff, b >> 16, b & 0xffff);
    let low = (a0 as u32 * b0 as u32) >> 16;
    let middle = a1 * b0 + low as i32;
    let rest = a0 * b1 + (middle & 0xffff);
    a1 * b1 + (middle >> 16) + (rest >> 16)
}

/// The square of a number, all 64 bits of it.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) const fn wide_square(x: i32) -> u64 {
    (x as i64 * x as i64) as u64
}

/// The square of a number, all 64 bits of it: by the number's halves on ARMv6-M, as in [`high`].
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline]
pub(crate) const fn wide_square(x: i32) -> u64 {
    let x = x.unsigned_abs();
    let (x1, x0) = (x >> 16, x & 0xffff);
    (((x1 * x1) as u64) << 32 | (x0 * x0) as u64) + (((x1 * x0) as u64) << 17)
}

/// The product of two numbers, all 64 bits of it.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    a as i64 * b as i64
}

/// The product of two numbers, all 64 bits of it: by their halves on ARMv6-M, as in [`high`].
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(never)]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    ((high(a, b) as i64) << 32) | (a.wrapping_mul(b) as u32 as i64)
}

/// The number of leading zeros of a number; 31 or 32 for zero.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) const fn leading_zeros(x: u32) -> u32 {
    x.leading_zeros()
}

/// The number of leading zeros of a number; 31 or 32 for zero. By halves on ARMv6-M, which has no instruction
/// for it: in half of the time that the compiler's function takes.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(never)]
pub(crate) const fn leading_zeros(mut x: u32) -> u32 {
    let mut zeros = 0;
    if x >> 16 == 0 {
        (x, zeros) = (x << 16, 16);
    }
    if x >> 24 == 0 {
        (x, zeros) = (x << 8, zeros + 8);
    }
    if x >> 28 == 0 {
        (x, zeros) = (x << 4, zeros + 4);
    }
    if x >> 30 == 0 {
        (x, zeros) = (x << 2, zeros + 2);
    }
    zeros + (!x >> 31)
}

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
    use super::{exponent, fixed, high, power_of_two};

    /// The function for the machine that runs the test: on ARMv6-M products of halves, elsewhere whole ones.
    #[test]
    fn the_high_word_is_that_of_the_product() {
        for a in [0, 1, -1, 77, -123_456, 0x7fff_ffff, -0x8000_0000, 0x1234_5678, -0x7654_ffff] {
            for b in [0, 1, -1, 0xffff, -0x1_0000, 0x7fff_ffff, -0x8000_0000, 0x0fed_cba9, -0x0000_8000] {
                assert_eq!(i64::from(high(a, b)), (i64::from(a) * i64::from(b)) >> 32, "{a}·{b}");
            }
        }
    }

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
