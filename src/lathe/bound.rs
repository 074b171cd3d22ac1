//! How high a cubic comes.

use crate::cubic::Cubic;
use crate::math::order::greater;
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

/// The greatest value of `c1·s + c2·s²` from `-before` to `beyond`.
#[inline(never)]
pub(super) fn highest(c1: f32, c2: f32, before: f32, beyond: f32) -> f32 {
    let at = |s: f32| (c1 + c2 * s) * s;
    let vertex = -0.5 * c1 / c2;
    // Also where c2 is zero, and the vertex infinite or not a number.
    let is_between = c2 < 0.0 && -before < vertex && vertex < beyond;
    if is_between { at(vertex) } else { greater(0.0, greater(at(-before), at(beyond))) }
}
