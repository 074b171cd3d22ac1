//! Products, inverses and bits of whole words, where the machine has instructions for them.

/// The high word of a signed product: `a·b/2³²`, rounded down.
#[inline(always)]
pub(crate) const fn high(a: i32, b: i32) -> i32 {
    (product(a, b) >> 32) as i32
}

/// The product of two numbers, all 64 bits of it.
#[inline(always)]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    a as i64 * b as i64
}

/// The square of a number, all 64 bits of it.
#[inline(always)]
pub(crate) const fn wide_square(x: i32) -> u64 {
    product(x, x) as u64
}

/// The number of leading zeros of a number; 31 or 32 for zero.
#[inline(always)]
pub(crate) const fn leading_zeros(x: u32) -> u32 {
    x.leading_zeros()
}

/// (2³² − 1)/x, rounded down, for an x of 2¹² or more; `None` if x is zero.
#[inline(always)]
pub(crate) const fn inverse(x: u32) -> Option<u32> {
    u32::MAX.checked_div(x)
}
