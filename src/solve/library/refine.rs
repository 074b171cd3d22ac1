use crate::cubic::Cubic;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::lesser;
use crate::solve::{Fall, Piece};

/// Bisection alone would need one step a bit of the result, 24, after as many as the exponents differ.
/// Newton's needs two or three; the rest is for those who call with an interval like ±10³⁸ and a bad seed.
const MOST_STEPS: u32 = 160;

/// The root of `g` in a piece, by Newton's method from any seed, NaN too: a poor one costs time, never the
/// answer. For solvers whose seeds are poor, or poor at times: `g` as a [`Solver`](super::Solver) is given it, above zero
/// where the piece begins. [`Piece`] has an example.
///
/// Cost: from a fair seed two or three steps, each with a division, and 160 at most.
///
/// Held in the bracket that the signs of `g` draw ever closer; a step that leaves the bracket is replaced by
/// its middle. After a step d from u the value that remains is exactly `d²·(g″(u)/2 − c3·d)`.
///
/// Two ways out, both bounds on the value: one that is within its own rounding has no sign to go by, only a
/// last step to offer; and one that remains after a step may be below a rounding. Beside a turning point the
/// slope is mostly rounding: no step is longer than half the way to it, and every fourth of those is replaced
/// by the bracket's middle, for from a bad seed they could go on for long.
#[inline(never)]
#[must_use]
pub fn refine(g: &Cubic, piece: &Piece, seed: f32) -> f32 {
    let [c0, _, c2, c3] = g.c;
    // What the crossing lies between, and nothing else, limits a step.
    let top = if piece.fall == Fall::Straight { f32::NEG_INFINITY } else { piece.maximum(g) };
    let (mut lo, mut hi) = (if piece.lo < top && top < piece.hi { top } else { piece.lo }, piece.hi);
    // At zero no value is within its own rounding: what vanishes there is found there, doubly or triply too.
    if c0 == 0.0 && (lo < 0.0 || top == 0.0) && lo <= 0.0 && 0.0 <= hi {
        return 0.0;
    }
    let maximum = if top <= lo { top } else { f32::NEG_INFINITY };
    let minimum = if piece.minimum >= hi { piece.minimum } else { f32::INFINITY };
    let mut u = seed;
    for count in 0..MOST_STEPS {
        if !(lo < u && u < hi) {
            u = 0.5 * lo + 0.5 * hi;
            if !(lo < u && u < hi) {
                break;
            }
        }
        let value = g.at(u);
        let rounding = UNIT_ROUNDOFF * g.size(u);
        let step = value / g.slope(u);
        let reach = 0.5 * lesser(u - maximum, minimum - u);
        let far = step.abs() > reach;
        let rest = step * step * (c2 + 3.0 * c3 * u - c3 * step);
        let last = !far && rest.abs() <= 0.125 * rounding;
        // Not `<=`: far out both may be infinite.
        if value.abs() < 2.0 * rounding || value == 0.0 {
            u -= if last { step } else { 0.0 };
            break;
        }
        if value > 0.0 {
            lo = u;
        } else {
            hi = u;
        }
        u = if !far {
            u - step
        } else if count % 4 == 3 {
            0.5 * lo + 0.5 * hi
        } else if step > 0.0 {
            u - reach
        } else {
            u + reach
        };
        if last && step.abs() <= 0.5 * u.abs() {
            break;
        }
    }
    u
}
