//! Quotients and roots of wide integers.

use super::{inverse_root, leading_zeros};

/// A number to divide by, held as its inverse. Zero counts as 1.
#[derive(Clone, Copy)]
pub(crate) struct Divisor {
    /// 2⁶³ over the divisor's magnitude after a shift by `left`, which makes its highest bit bit 31. So that
    /// magnitude is from 2³¹ to 2³², and this number, too.
    inverse: u32,
    left: i32,
    is_negative: bool,
}

/// The largest magnitude of a quotient: in place of a larger one this is returned, with its sign.
pub(crate) const MOST_QUOTIENT: i32 = 1 << 30;

impl Divisor {
    /// Computes the inverse of a divisor, by one division of 32-bit integers and two products. Its relative
    /// error is 2⁻²⁸ at most: that of the division is 2⁻¹⁴·⁴, since it has half of the divisor's bits, and a
    /// Newton step squares it.
    #[inline(never)]
    pub fn new(divisor: i32) -> Self {
        let magnitude = divisor.unsigned_abs().max(1);
        let left = leading_zeros(magnitude);
        let high = magnitude << left;
        // The highest bit is set already. That it is set here, too, shows the compiler that the divisor is
        // not zero: it leaves out a test that could panic.
        let guess = (u32::MAX / (high >> 16 | 1 << 15)) << 15;
        let rest = (1 << 31) - ((u64::from(high) * u64::from(guess)) >> 32) as i64;
        let inverse = (i64::from(guess) + ((i64::from(guess) * rest) >> 31)).min(u32::MAX.into());
        Self { inverse: inverse as u32, left: left as i32, is_negative: divisor < 0 }
    }

    /// The same for a divisor of 64 bits.
    pub fn wide(divisor: i64) -> Self {
        let (divisor, right) = upper(divisor);
        let narrow = Self::new(divisor);
        Self { left: narrow.left - right, ..narrow }
    }

    /// A number over the divisor, in units of 2^−`bits`, at most [`MOST_QUOTIENT`] in magnitude. The error is
    /// at most 2⁻²⁷ of the quotient, and a unit.
    #[inline(never)]
    pub fn of(&self, number: i32, bits: i32) -> i32 {
        let magnitude = number.unsigned_abs();
        if magnitude == 0 {
            return 0;
        }
        let left = leading_zeros(magnitude);
        let high = (magnitude << left) >> 1;
        let quotient = ((u64::from(high) * u64::from(self.inverse)) >> 32) as i32;
        let right = 30 + left as i32 - self.left - bits;
        let quotient = if right < 0 { MOST_QUOTIENT } else { (quotient >> right.min(31)).min(MOST_QUOTIENT) };
        if (number < 0) != self.is_negative { -quotient } else { quotient }
    }

    /// The same for a number of 64 bits.
    pub fn of_wide(&self, number: i64, bits: i32) -> i32 {
        let (number, right) = upper(number);
        self.of(number, bits + right)
    }
}

/// A number shifted to the right, rounded down, so that at most 31 bits and the sign remain; and by how many
/// bits it is shifted, which is zero if so few remain anyway.
#[inline(never)]
fn upper(number: i64) -> (i32, i32) {
    let magnitude = number.unsigned_abs();
    let (high, low) = ((magnitude >> 32) as u32, magnitude as u32);
    let right = if high > 0 { 33 - leading_zeros(high) } else { low >> 31 };
    ((number >> right) as i32, right as i32)
}

/// The root of a number below 2⁶⁰; zero for a negative number. The error is at most 2⁻²³ of the root, and a
/// unit.
#[inline(never)]
pub(crate) fn square_root(square: i64) -> i32 {
    if square <= 0 {
        return 0;
    }
    // `left` is even, and at least 2. After the shift the highest bit is bit 60 or 61.
    let left = (square.leading_zeros() - 2) & !1;
    let quarter = ((square << left) >> 32) as i32;
    let root = ((i64::from(quarter) * i64::from(inverse_root(quarter))) >> 29) as i32;
    root >> (left / 2 - 1)
}

/// Shifts four numbers to the right, all by the same number of bits, five at least, so that none exceeds 2²⁸ in
/// magnitude. Returns them, rounded down, and the number of bits.
#[inline(never)]
pub(crate) fn narrowed(numbers: [i64; 4]) -> ([i32; 4], u32) {
    // Only the upper words decide `left`, and words are shifted: the compiler takes many instructions for a
    // shift of 64 bits by a variable number.
    let most =
        numbers.iter().map(|number| (number >> 32) as i32).fold(0, |most, high| most | high ^ (high >> 31));
    let left = (leading_zeros(most as u32) - 1).min(30);
    let narrow = |number: i64| {
        let (high, low) = ((number >> 32) as u32, number as u32);
        (high << left | low >> 1 >> (31 - left)) as i32 >> 3
    };
    (numbers.map(narrow), 35 - left)
}

#[cfg(test)]
mod tests {
    use super::{Divisor, MOST_QUOTIENT, square_root};

    #[test]
    fn quotients_and_roots_are_as_close_as_they_say() {
        let mut bits = 0x1995_u64;
        let mut next = || {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (bits as i64) >> ((bits >> 3) % 63)
        };
        let (mut worst, mut worst_root) = (0.0_f64, 0.0_f64);
        for _ in 0..200_000 {
            let (a, b) = (next(), next());
            if b == 0 {
                continue;
            }
            let bits = 40
                - ((a.unsigned_abs().leading_zeros() as i32) - b.unsigned_abs().leading_zeros() as i32).abs();
            let exact = a as f64 / b as f64 * f64::exp2(f64::from(bits));
            let found = f64::from(Divisor::wide(b).of_wide(a, bits));
            if exact.abs() >= f64::from(MOST_QUOTIENT) {
                assert!(
                    found.abs() > 0.999_999 * f64::from(MOST_QUOTIENT) && found.signum() == exact.signum()
                );
            } else {
                worst = worst.max((found - exact).abs() / (exact.abs() * f64::exp2(-27.0) + 1.0));
            }
            let square = a.abs() >> 4;
            let exact = (square as f64).sqrt();
            worst_root = worst_root
                .max((f64::from(square_root(square)) - exact).abs() / (exact * f64::exp2(-23.0) + 1.0));
        }
        assert!((0.25..=1.0).contains(&worst) && (0.25..=1.0).contains(&worst_root), "{worst} {worst_root}");
    }
}
