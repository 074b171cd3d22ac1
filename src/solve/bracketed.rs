use super::{Piece, Solver};
use crate::cubic::Cubic;
use crate::math::Native;

/// Of Newton's steps and halvings. Halvings alone would take 25.
const MOST_STEPS: u32 = 64;

/// A step of so small a part of the piece is the last.
const LAST: f32 = 1.0 / 33_554_432.0;

/// A value of so small a part of its terms is zero, but for rounding.
const UNIT: f32 = 1.0 / 16_777_216.0;

/// Newton's method in a bracket, no more: a step that leaves it is replaced by its middle.
///
/// The smallest solver, for rays that are seldom asked about. A root that is off by 2⁻²⁵ of its chord is as good there
/// as any.
pub(crate) struct Bracketed;

impl Solver for Bracketed {
    type Math = Native;

    #[inline(always)]
    fn root(g: &Cubic, piece: &Piece) -> f32 {
        let (mut lo, mut hi) = (piece.lo, piece.hi);
        let last = LAST * (hi - lo);
        let mut u = 0.5 * (lo + hi);
        for _ in 0..MOST_STEPS {
            let value = g.at(u);
            if value > 0.0 {
                lo = u;
            } else {
                hi = u;
            }
            let step = value / g.slope(u);
            if value.abs() <= UNIT * g.size(u) || step.abs() <= last {
                break;
            }
            u -= step;
            if !(lo < u && u < hi) {
                u = 0.5 * (lo + hi);
            }
            if u == lo || u == hi {
                break;
            }
        }
        u
    }
}
