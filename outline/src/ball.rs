//! A number known to within an error: arithmetic whose results enclose the exact ones.

use core::ops::{Add, Mul, Neg, Sub};

/// Every real number from `mid − err` to `mid + err`. Each operation returns a ball that contains the exact
/// results of all its operands' numbers: it adds what rounding to f64 can have cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    mid: f64,
    err: f64,
}

/// Half a unit in the last place of 1, the largest relative error of one f64 operation.
const HALF_ULP: f64 = f64::EPSILON / 2.0;

/// The error terms are sums of at most five rounded products: 1 + 8·ε outweighs their own roundings.
const OUTWARD: f64 = 1.0 + 8.0 * f64::EPSILON;

/// More than products that underflow can lose.
const UNDERFLOW: f64 = 1e-300;

impl Ball {
    /// The ball that contains `value` alone.
    pub const fn exact(value: f64) -> Self {
        Self { mid: value, err: 0.0 }
    }

    /// A ball around all numbers from `low` to `high`.
    pub fn between(low: f64, high: f64) -> Self {
        let mid = 0.5 * (low + high);
        Self { mid, err: (high - mid).max(mid - low).next_up() }
    }

    fn rounded(mid: f64, err: f64) -> Self {
        Self { mid, err: (err + HALF_ULP * mid.abs()) * OUTWARD + UNDERFLOW }
    }

    /// The least number, rounded down.
    pub fn low(self) -> f64 {
        (self.mid - self.err).next_down()
    }

    /// The largest number, rounded up.
    pub fn high(self) -> f64 {
        (self.mid + self.err).next_up()
    }

    /// This over another ball, which must not contain zero.
    pub fn over(self, divisor: Self) -> Self {
        let quotient = self.mid / divisor.mid;
        let least = (divisor.mid.abs() - divisor.err) * (1.0 - 4.0 * f64::EPSILON);
        Self::rounded(quotient, (self.err + quotient.abs() * divisor.err * OUTWARD) / least)
    }
}

impl From<f64> for Ball {
    fn from(value: f64) -> Self {
        Self::exact(value)
    }
}

impl Add for Ball {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::rounded(self.mid + other.mid, self.err + other.err)
    }
}

impl Sub for Ball {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.mid - other.mid, self.err + other.err)
    }
}

impl Neg for Ball {
    type Output = Self;
    fn neg(self) -> Self {
        Self { mid: -self.mid, err: self.err }
    }
}

impl Mul for Ball {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let err = self.mid.abs() * other.err + other.mid.abs() * self.err + self.err * other.err;
        Self::rounded(self.mid * other.mid, err)
    }
}

/// By an exact number.
impl core::ops::Div<f64> for Ball {
    type Output = Self;
    fn div(self, divisor: f64) -> Self {
        Self::rounded(self.mid / divisor, self.err / divisor.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::Ball;

    #[test]
    fn a_ball_contains_what_rounding_loses() {
        // 1e16 + 1 rounds to 1e16.
        let sum = Ball::exact(1e16) + Ball::exact(1.0);
        assert!((sum - Ball::exact(1e16)).high() >= 1.0);
        let third = Ball::exact(1.0) / 3.0;
        let zero = third * Ball::exact(3.0) - Ball::exact(1.0);
        assert!(zero.low() < 0.0 && zero.high() > 0.0 && zero.high() < 1e-15);
    }
}
