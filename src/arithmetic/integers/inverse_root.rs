//! One over the length of a vector.

use super::{high, wide_square};

/// The sum of the squares of three components, each less than 2³⁰ in magnitude.
#[inline(always)]
pub(crate) const fn square([x, y, z]: [i32; 3]) -> u64 {
    wide_square(x) + wide_square(y) + wide_square(z)
}

/// Returns 1/√x, in units of 2⁻²⁹, with a relative error of at most 2⁻²⁴. x is from 1/15 to 1, in units of
/// 2⁻³⁰. `y` is a guess of the result, in its units: the nearer it is, the sooner the result is found.
///
/// A Newton step is `y ← y + y·r/2` with the residual `r = 1 − x·y²`; it makes the residual 3/4 of its
/// square. The first one with |r| ≤ 2⁻¹² is the last: the relative error that it leaves in y is 3/8·2⁻²⁴, and
/// rounding adds less than 2⁻²⁵. If x·y² is more than 2, Newton's method may diverge: then the guess is
/// replaced by 1, which is never too large, and from which nine steps lead to the result.
#[inline(always)]
pub(crate) fn inverse_root(x: i32, mut y: i32) -> i32 {
    const ONE: i32 = 1 << 25;
    loop {
        // 30 + 1 + 26 − 32 bits behind the point; 26 are those of y².
        let rest = ONE - high(x << 1, high(y, y));
        if rest < -ONE {
            y = 1 << 29;
            continue;
        }
        y += high(y, rest << 4) << 2;
        if rest.abs() <= ONE >> 12 {
            return y;
        }
    }
}

/// [`inverse_root`] for x from 1/4 to 1, without a guess.
#[inline(always)]
pub(crate) fn root_of_quarter(x: i32) -> i32 {
    // The chord of 1/√x from x = 1/4 to 1, 7/3 − 4/3·x, is nowhere a fifth above the root.
    let chord = (7.0 / 3.0 * (1 << 29) as f32) as i32 - x + high(x, (u32::MAX / 3) as i32);
    inverse_root(x, chord)
}

#[cfg(test)]
mod tests {
    use super::inverse_root;

    #[test]
    fn is_as_close_as_it_says() {
        let mut worst: f64 = 0.0;
        for x in ((1 << 30) / 15..1 << 30).step_by(9_973) {
            let exact = 1.0 / (f64::from(x) / f64::from(1 << 30)).sqrt();
            for guess in [1 << 29, i32::MAX, (exact * 0.9999 * f64::from(1 << 29)) as i32] {
                let found = f64::from(inverse_root(x, guess)) / f64::from(1 << 29);
                worst = worst.max((found / exact - 1.0).abs());
            }
        }
        assert!((0.25..=1.0).contains(&(worst * f64::from(1 << 24))), "{worst}");
    }
}
