//! What `words.rs` has, for ARMv6-M, whose products have 32 bits only, and which has no instruction that divides
//! or that counts leading zeros. The same bits.

use super::inverse_root::GUESSES;

/// The high word of a signed product: `a·b/2³²`, rounded down. Four products of halves take half of the time of
/// the compiler's 64-bit product.
// Not `inline(always)`: in a build for size, flash should contain it only once.
#[inline]
pub(crate) const fn high(a: i32, b: i32) -> i32 {
    let (a1, a0, b1, b0) = (a >> 16, a & 0xffff, b >> 16, b & 0xffff);
    let low = (a0 as u32 * b0 as u32) >> 16;
    let middle = a1 * b0 + low as i32;
    let rest = a0 * b1 + (middle & 0xffff);
    a1 * b1 + (middle >> 16) + (rest >> 16)
}

/// The product of two numbers, all 64 bits of it.
#[inline(never)]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    ((high(a, b) as i64) << 32) | (a.wrapping_mul(b) as u32 as i64)
}

/// The square of a number, all 64 bits of it.
#[inline]
pub(crate) const fn wide_square(x: i32) -> u64 {
    let x = x.unsigned_abs();
    let (x1, x0) = (x >> 16, x & 0xffff);
    (((x1 * x1) as u64) << 32 | (x0 * x0) as u64) + (((x1 * x0) as u64) << 17)
}

/// The number of leading zeros of a number; 31 or 32 for zero. It is found in half of the time that the
/// compiler's function takes.
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

/// (2³² − 1)/x, rounded down, for an x of 2¹² or more; `None` if x is zero.
#[inline]
pub(crate) fn inverse(x: u32) -> Option<u32> {
    (x > 0).then(|| by_guess(x))
}

/// (2³² − 1)/x, rounded down, for an x of 2¹² or more: by products of 32 bits, in a quarter of the time that a
/// division by shifts and differences takes.
///
/// The square of the guess of 1/√x is off by 2 %. Newton's method for 1/x squares that error, to 2⁻¹¹, in 16 of
/// x's bits. The quotient has up to 20 bits; so it is off by 2⁹ at most, and by twice that when it is made too
/// small. What is left to divide says by how much, to within a few units.
fn by_guess(x: u32) -> u32 {
    let left = leading_zeros(x) & !1;
    let n = x << left;
    let root = u32::from(GUESSES[n as usize >> 25 & 127]);
    // 14 bits behind the point; the residual has 30.
    let guess = (root * root) as i32;
    let rest = (1 << 30) - (n >> 16) as i32 * guess;
    let guess = (guess << 12) + ((guess * (rest >> 14)) >> 4);
    let quotient = (guess >> (26_u32.wrapping_sub(left) & 31)) as u32;
    // From here on it is never too large.
    let mut quotient = quotient - (quotient >> 10) - 1;
    quotient += (((u32::MAX - quotient * x) >> 12) * quotient) >> 20;
    let mut rest = u32::MAX - quotient * x;
    while rest >= x {
        (quotient, rest) = (quotient + 1, rest - x);
    }
    quotient
}

#[cfg(test)]
mod tests {
    use super::super::words;
    use super::*;

    #[test]
    fn products_are_those_of_whole_words() {
        let numbers = [0, 1, -1, 77, -123_456, 0xffff, -0x1_0000, 0x7fff_ffff, -0x8000_0000, 0x1234_5678];
        for a in numbers {
            for b in numbers.into_iter().chain([0x0fed_cba9, -0x0000_8000, -0x7654_ffff]) {
                assert_eq!(high(a, b), words::high(a, b), "{a}·{b}");
                assert_eq!(product(a, b), words::product(a, b), "{a}·{b}");
            }
            assert_eq!(wide_square(a), words::wide_square(a), "{a}");
        }
    }

    #[test]
    fn leading_zeros_are_those_of_the_number() {
        for x in (0..32).flat_map(|bits| [1 << bits, u32::MAX >> bits, (1 << bits) | 1]) {
            assert_eq!(leading_zeros(x), x.leading_zeros(), "{x}");
        }
    }

    #[test]
    fn an_inverse_is_what_a_division_gives() {
        assert_eq!(inverse(0), None);
        for bits in 12..31 {
            let scattered = |i: u32| (1 << bits) + (i.wrapping_mul(2_654_435_761) & ((1 << bits) - 1));
            for x in (0..20_000).map(scattered).chain([1 << bits, (1 << bits) + 1, (2 << bits) - 1]) {
                assert_eq!(inverse(x), words::inverse(x), "{x}");
            }
        }
    }
}
