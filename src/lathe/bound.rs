//! How high a cubic comes.

use crate::cubic::Cubic;
use crate::math::order::greater;

/// A bound on a cubic from `-before` to `beyond`, where `c3·s³ ≤ |c3|·l·s²`.
pub(super) fn most(g: &Cubic, before: f32, beyond: f32) -> f32 {
    let [c0, c1, c2, c3] = g.c;
    c0 + highest(c1, c2 + greater(c3 * beyond, -c3 * before), before, beyond)
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
