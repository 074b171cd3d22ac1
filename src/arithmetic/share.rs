//! Shares: the numbers from 0 to 1 by which colors are multiplied, in both arithmetics.

/// A number from 0 to 1 in fixed point, in units of 2⁻³². 1 itself is 2³² − 1 units.
#[derive(Clone, Copy)]
pub(crate) struct Share(u32);

impl Share {
    /// The number 0.
    pub const NONE: Self = Self(0);
    /// How many units make the number 1.
    pub const UNITS: f32 = 4_294_967_296.0;

    /// The share of that many units. A negative number and NaN give the share 0; 2³² units and more give the
    /// share 1.
    #[inline(always)]
    pub const fn new(units: f32) -> Self {
        Self(units as u32)
    }

    /// The share of that many whole units.
    #[inline(always)]
    pub const fn of_units(units: u32) -> Self {
        Self(units)
    }

    /// How many whole units the share has.
    #[inline(always)]
    pub const fn units(self) -> u32 {
        self.0
    }

    /// The share x, from 0 to 1. A negative x and NaN give 0, an x above 1 gives 1.
    pub const fn of_one(x: f32) -> Self {
        Self::new(x * Self::UNITS)
    }

    /// This share of a number, rounded down.
    #[inline(always)]
    pub const fn of(self, number: u32) -> u32 {
        ((number as u64 * self.0 as u64) >> 32) as u32
    }
}
