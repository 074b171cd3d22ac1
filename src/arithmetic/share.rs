//! Shares: the numbers from 0 to 1 by which colors are multiplied, in both arithmetics.

use super::integers::high;

/// A number from 0 to 1, or a sum of such numbers that is less than 2, in fixed point: in units of 2⁻³⁰. It
/// is a signed integer, since it is multiplied as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Share(i32);

impl Share {
    /// The number 0.
    pub const NONE: Self = Self(0);
    /// How many units make the number 1.
    pub const UNITS: f32 = 1_073_741_824.0;

    /// The share of that many units, rounded down. There must be fewer than 2³¹; a negative number and NaN
    /// give the share 0.
    #[inline(always)]
    pub const fn new(units: f32) -> Self {
        Self(units as u32 as i32)
    }

    /// The share of that many whole units.
    #[inline(always)]
    pub const fn of_units(units: i32) -> Self {
        Self(units)
    }

    /// How many whole units the share has.
    #[inline(always)]
    #[cfg(test)]
    pub const fn units(self) -> i32 {
        self.0
    }

    /// The share x, from 0 to 1. A negative x and NaN give 0.
    pub const fn of_one(x: f32) -> Self {
        Self::new(x * Self::UNITS)
    }

    /// The share x; a negative x and NaN give 0, an x above 1 gives 1.
    #[inline]
    pub const fn up_to_one(x: f32) -> Self {
        let units = (x * Self::UNITS) as u32;
        Self(if units < 1 << 30 { units as i32 } else { 1 << 30 })
    }

    /// The sum of this share and another, which must be less than 2.
    #[inline(always)]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }

    /// A quarter of this share of a number, rounded down: the high word of a product. The number must be less
    /// than 2³¹.
    #[inline(always)]
    pub const fn quarter_of(self, number: u32) -> u32 {
        high(number as i32, self.0) as u32
    }
}
