//! One over the length of a vector.

use super::{high, wide_square};

/// The sum of the squares of three components, each less than 2³⁰ in magnitude.
#[inline(always)]
pub(crate) const fn square([x, y, z]: [i32; 3]) -> u64 {
    wide_square(x) + wide_square(y) + wide_square(z)
}

/// 1/√x in the middle of each of 128 equal intervals of x from 0 to 1, in units of 2⁻⁷. The first 32 are not
/// used: without them it would have to be asked whether a number is in the table.
pub(super) static GUESSES: [u8; 128] = {
    let (mut guesses, mut i) = ([0; 128], 32);
    while i < guesses.len() {
        // x is (2·i + 1)/256. Of 2²²/x the root is 2¹¹/√x.
        let root = ((1_u32 << 30) / (2 * i as u32 + 1)).isqrt();
        guesses[i] = ((root + 8) >> 4) as u8;
        i += 1;
    }
    guesses
};

/// Returns 1/√x, in units of 2⁻²⁹, with a relative error of at most 2⁻²⁴. x is from 1/4 to less than 1, in
/// units of 2⁻³⁰.
///
/// A Newton step is `y ← y + y·r/2` with the residual `r = 1 − x·y²`; it makes the relative error e of y
/// 3/2·e². The guess is off by 2⁻⁷ where x is least, for that much 1/√x changes in half an interval, and
/// by 2⁻⁹ because it is rounded: together by less than 0.01. The first step makes that 1.5·10⁻⁴, the
/// second less than 2⁻²⁴·⁸, by which y is too small. Rounding makes y larger by less than 2⁻²⁵ of it, or
/// smaller by less than 2⁻²⁶.
#[inline(always)]
pub(crate) fn inverse_root(x: i32) -> i32 {
    let step = |y: i32| {
        // The residual has 30 + 1 + 26 − 32 = 25 bits behind the point; the 26 are those of y².
        let rest = (1 << 25) - high(x << 1, high(y, y));
        y + (high(y, rest << 4) << 2)
    };
    let guess = GUESSES[x as usize >> 23 & 127];
    step(step(i32::from(guess) << 22))
}

#[cfg(test)]
mod tests {
    use super::inverse_root;

    #[test]
    fn is_as_close_as_it_says() {
        let mut worst: f64 = 0.0;
        for x in (1 << 28..1 << 30).step_by(997).chain([(1 << 30) - 1]) {
            let exact = 1.0 / (f64::from(x) / f64::from(1 << 30)).sqrt();
            let found = f64::from(inverse_root(x)) / f64::from(1 << 29);
            worst = worst.max((found / exact - 1.0).abs());
        }
        assert!((0.25..=1.0).contains(&(worst * f64::from(1 << 24))), "{worst}");
    }
}
