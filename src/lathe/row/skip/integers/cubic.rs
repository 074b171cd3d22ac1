//! Cubics for −1 ≤ τ ≤ 1 in integers: g along a part of a ray, or how fast it changes from pixel to pixel.

use crate::arithmetic::integers::{Divisor, high, narrowed, product, square_root};

/// `a0 + a1·τ + a2·τ² + a3·τ³`, with coefficients that are rounded down to a unit each.
pub(super) struct Cubic {
    /// The coefficients, constant term first, none above 2²⁸, in units of 2^`right` of those that were given.
    a: [i32; 4],
    right: u32,
}

/// What rounding takes from the largest value at most, in units of `a`: four coefficients are rounded, and
/// the three products of a value, by two units each. The place of the largest value is found within 2⁻²².
/// Since the slope is zero there, this error changes the value by less than a unit.
const SLACK: i64 = 12;

/// x·t, rounded down to an even number, for t in units of 2⁻³⁰ and an x below 2³⁰.
#[inline(always)]
fn times(x: i32, t: i32) -> i32 {
    high(x << 1, t) << 1
}

impl Cubic {
    /// The cubic with these coefficients.
    #[inline(always)]
    pub fn new(coefficients: [i64; 4]) -> Self {
        let (a, right) = narrowed(coefficients);
        Self { a, right }
    }

    /// Its largest value, in the units of the coefficients that were given, or a little more.
    #[inline(never)]
    pub fn most(&self) -> i64 {
        let [a0, a1, a2, a3] = self.a;
        let mut most = a0 + a2 + (a1 + a3).abs();
        // Otherwise the slope has no zero between −1 and 1, and the largest value is at an end.
        if a1.abs() < 2 * a2.abs() + 3 * a3.abs() {
            let discriminant = product(a2, a2) - product(3 * a3, a1);
            // Of the slope's two zeros the one where it falls, in the form that does not cancel.
            let root = square_root(discriminant);
            let (number, divisor) = if a2 > 0 { (-(a2 + root), 3 * a3) } else { (a1, root - a2) };
            let top = Divisor::new(divisor).of(number, 30);
            if discriminant > 0 && top.abs() < 1 << 30 {
                most = most.max(self.with_slope(top).0);
            }
        }
        (i64::from(most) + SLACK) << self.right
    }

    /// Value and slope, in units of `a`, at a τ in units of 2⁻³⁰.
    #[inline(never)]
    pub fn with_slope(&self, t: i32) -> (i32, i32) {
        let [a0, a1, a2, a3] = self.a;
        let third = times(a3, t);
        let second = third + a2;
        let first = times(second, t) + a1;
        (times(first, t) + a0, times(third + second, t) + first)
    }

    /// About where the cubic rises through zero as τ grows, or, for a `way` of −1, where it falls through
    /// zero: τ in units of 2⁻³⁰. If there is no such place, the result may be any number from −1 to 1.
    ///
    /// Newton's method begins at the end from which a concave cubic's zero is never passed.
    #[inline(always)]
    pub fn zero(&self, way: i32) -> i32 {
        let mut t = -way << 30;
        for _ in 0..NEWTON_STEPS {
            let (value, slope) = self.with_slope(t);
            let step = Divisor::new(slope).of(value, 30);
            t = t.saturating_sub(step).clamp(-1 << 30, 1 << 30);
            if step.abs() < 1 << 16 {
                break;
            }
        }
        t
    }
}

/// The most steps of Newton's method from an end to a zero: beside a double zero each step halves the error.
const NEWTON_STEPS: u32 = 6;
