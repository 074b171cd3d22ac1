//! The larger and the smaller of two numbers, inline. The innermost loops need them, and there `f32::max` and
//! `f32::min` would be function calls on Cortex-M.

/// The larger of two numbers, and `a` if either is NaN.
#[inline(always)]
pub(crate) const fn greater(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}

/// The smaller of two numbers, and `a` if either is NaN.
#[inline(always)]
pub(crate) const fn lesser(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}
