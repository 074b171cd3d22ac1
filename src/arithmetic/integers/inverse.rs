//! The inverse of an integer.

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
use super::inverse_root::GUESSES;

/// (2³² − 1)/x, rounded down, for an x of 2¹² or more; `None` if x is zero.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) const fn inverse(x: u32) -> Option<u32> {
    u32::MAX.checked_div(x)
}

/// (2³² − 1)/x, rounded down, for an x of 2¹² or more; `None` if x is zero. An ARMv6-M has no instruction that
/// divides.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
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
#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
fn by_guess(x: u32) -> u32 {
    let (mut n, mut left) = (x, 0);
    for bits in [16, 8, 4, 2] {
        if n >> (32 - bits) == 0 {
            (n, left) = (n << bits, left + bits);
        }
    }
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
    use super::by_guess;

    #[test]
    fn is_what_a_division_gives() {
        for bits in 12..31 {
            for i in 0..20_000_u32 {
                let x = (1 << bits) + (i.wrapping_mul(2_654_435_761) & ((1 << bits) - 1));
                assert_eq!(by_guess(x), u32::MAX / x, "{x}");
            }
            for x in [1 << bits, (1 << bits) + 1, (2 << bits) - 1] {
                assert_eq!(by_guess(x), u32::MAX / x, "{x}");
            }
        }
    }
}
