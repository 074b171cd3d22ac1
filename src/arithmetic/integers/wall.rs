//! A segment's cubic in integers.

use super::{exponent, fixed, high};

/// A segment's cubic about the middle of its height, `a0 + a1·v + a2·v² + a3·v³`.
///
/// The parameter v is (z − m)/2^height, in units of 2⁻³¹, where m is the middle of the segment's height; in
/// the segment it is between −1/2 and 1/2, and the cubic may be computed for all v between −1 and 1. So
/// Newton's method may go beyond the segment's ends, by half of its height at least.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Wall {
    /// The coefficients, in units of 2^(2·block − 26).
    pub a: [i32; 4],
    /// The least number, zero or more, for which |a0| + |a1| + 2·|a2| + 3·|a3| is less than 2³⁰ of
    /// these units.
    pub block: i16,
    /// 2^height is more than the segment's height, and at most twice that.
    pub height: i16,
}

impl Wall {
    /// The cubic of a spare segment, which no ray meets.
    pub const EMPTY: Self = Self { a: [0; 4], block: 0, height: 0 };

    /// The cubic of a segment with the coefficients f in powers of u, and with `per_height`, one over its
    /// height.
    pub const fn new(f: [f32; 4], per_height: f32) -> Self {
        // 1/h is less than 2^e, and at least half of it; so h is more than 2^−e, and at most 2^(1 − e). It is
        // 2^(1 − e) if the mantissa of 1/h is 1: then 2^height must be the next power of two.
        let is_power = per_height.to_bits() << 9 == 0;
        let height = 1 - exponent(per_height) + is_power as i32;
        let per_height = fixed(per_height, 29 + height);
        let [c0, c1, c2, c3] = f;
        let most = c0.abs().max(c1.abs()).max(c2.abs().max(c3.abs()));
        // |c| < 2²⁴ units. About the middle the coefficients are at most 1.875, 5.5, 10 and 8 times that. So
        // the sum is less than 52 times that, and less than 2³⁰.
        let fine = 24 - exponent(most);
        let sum = sum(about_middle(f, per_height, fine));
        let excess = 32 - sum.leading_zeros() as i32 - fine + 26 - 30;
        let block = (if excess > 0 { excess } else { 0 } + 1) >> 1;
        Self { a: about_middle(f, per_height, 26 - 2 * block), block: block as i16, height: height as i16 }
    }

    /// Returns this cubic itself. (In floats a segment has no cubic in integers.)
    #[inline(always)]
    pub fn in_integers(&self) -> &Self {
        self
    }

    /// f at v, and its derivative over v, both in the units of `a`.
    #[inline]
    pub fn with_slope(&self, v: i32) -> (i32, i32) {
        let [a0, a1, a2, a3] = self.a;
        let third = high(a3, v) << 1;
        let second = third + a2;
        let first = (high(second, v) << 1) + a1;
        ((high(first, v) << 1) + a0, (high(third + second, v) << 1) + first)
    }

    /// A bound of the magnitude of f's derivative over v, for |v| ≤ 1/2, in the units of `a`.
    #[inline(always)]
    pub fn steepest(&self) -> u32 {
        let [_, a1, a2, a3] = self.a;
        a1.unsigned_abs() + a2.unsigned_abs() + a3.unsigned_abs()
    }
}

/// The coefficients about the middle, in units of 2^−`bits`, of the cubic with the coefficients f in powers
/// of u. `per_height` is du/dv, from 1 to 2, in units of 2⁻²⁹.
const fn about_middle([c0, c1, c2, c3]: [f32; 4], per_height: i32, bits: i32) -> [i32; 4] {
    const fn scaled(c: i32, per_height: i32) -> i32 {
        ((c as i64 * per_height as i64) >> 29) as i32
    }
    let (c0, c1, c2, c3) = (fixed(c0, bits), fixed(c1, bits), fixed(c2, bits), fixed(c3, bits));
    [
        c0 + (c1 >> 1) + (c2 >> 2) + (c3 >> 3),
        scaled(c1 + c2 + c3 - (c3 >> 2), per_height),
        scaled(scaled(c2 + c3 + (c3 >> 1), per_height), per_height),
        scaled(scaled(scaled(c3, per_height), per_height), per_height),
    ]
}

/// A bound of |f| and of the magnitude of its derivative over v, for |v| < 1, given the coefficients of f.
const fn sum([a0, a1, a2, a3]: [i32; 4]) -> u32 {
    a0.unsigned_abs() + a1.unsigned_abs() + 2 * a2.unsigned_abs() + 3 * a3.unsigned_abs()
}
