//! How high a cubic comes.

use crate::cubic::Cubic;
use crate::math::minmax::greater;
use crate::math::{Math, Native};

/// The greatest value of a cubic from `-before` to `beyond`: at an end, or where g′ = 0 and falls.
pub(super) fn most(g: &Cubic, before: f32, beyond: f32) -> f32 {
    let [_, c1, c2, c3] = g.c;
    let ends = greater(g.at(-before), g.at(beyond));
    // Of the two forms of that root the one that does not cancel.
    let root = Native::sqrt(c2 * c2 - 3.0 * c3 * c1);
    let top = if c2 > 0.0 { -(c2 + root) / (3.0 * c3) } else { c1 / (root - c2) };
    if -before < top && top < beyond { greater(ends, g.at(top)) } else { ends }
}

/// The greatest value of `c0 + c1·x + c2·x²` for x from `-half` to `half`.
#[inline(always)]
pub(super) fn highest(c0: f32, c1: f32, c2: f32, half: f32) -> f32 {
    // Beyond its vertex it falls.
    if c1.abs() + 2.0 * c2 * half < 0.0 {
        c0 - 0.25 * c1 * c1 / c2
    } else {
        c0 + (c1.abs() + c2 * half) * half
    }
}
