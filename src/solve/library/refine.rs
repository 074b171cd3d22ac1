use crate::cubic::Cubic;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::lesser;
use crate::solve::{Fall, Piece};

/// The most steps. Bisection alone takes 24, one a bit of the result, after as many as the exponents of the
/// interval's length and of the root differ by: 152 for a root of 1 in an interval of the length 2¹²⁸. From a
/// fair seed two or three steps are taken.
const MOST_STEPS: u32 = 160;

/// The root of `g` in a piece, by Newton's method in a bracket, from any seed, NaN too: a bad seed costs
/// time, never accuracy. For a [`Solver`](crate::solve::Solver) whose closed form is inaccurate; `g` and
/// `piece` are those that it is given, so `g` is above zero where the piece begins. [`Piece`] has an example.
///
/// Cost: from a fair seed two or three steps, each with a division; 160 at most.
///
/// The signs of `g` narrow the bracket; a step that leaves it is replaced by its middle. After a step d from
/// u the value that remains is exactly `d²·(g″(u)/2 − c3·d)`.
///
/// The search ends when the value is below two roundings, since its sign is then uncertain, or when what
/// remains after a step is below an eighth of a rounding, so that another step would change no bit but the
/// last. Beside a critical point the slope is mostly rounding: no step is longer than half the way to it.
/// From a bad seed such steps could go on for long, each halving that way; so every fourth of them is
/// replaced by the bracket's middle, which bounds their number by four times bisection's.
#[inline(never)]
#[must_use]
pub fn refine(g: &Cubic, piece: &Piece, seed: f32) -> f32 {
    let [c0, _, c2, c3] = g.c;
    // A critical point limits steps only if it bounds the crossing's bracket.
    let top = if piece.fall == Fall::Straight { f32::NEG_INFINITY } else { piece.maximum(g) };
    let (mut lo, mut hi) = (if piece.lo < top && top < piece.hi { top } else { piece.lo }, piece.hi);
    // At u = 0 a value has no rounding to be within: a root there, simple or multiple, is found by c0.
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
        // Not `<=`: far out both sides may be infinite.
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
