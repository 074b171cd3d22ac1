//! The greater and the lesser of two numbers, in line: `f32::max` and `f32::min` are calls on Cortex-M, in
//! the innermost loops.

/// The greater, or the first if the second is not a number.
#[inline(always)]
pub(crate) const fn greater(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}

/// The lesser, or the first if the second is not a number.
#[inline(always)]
pub(crate) const fn lesser(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}
