use crate::cubic::Cubic;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::lesser;
use crate::solve::{Fall, Piece};

/// The most steps. For a root of 1 in an interval of length 2¹²⁸ bisection alone would take 152: 128 to
/// shorten the bracket to the size of the root, and 24 for the bits of its mantissa. From a fair seed two or
/// three Newton steps are enough.
const MOST_STEPS: u32 = 160;

/// The root of `g` in a piece, by Newton's method in a bracket, from any seed, NaN too: a bad seed costs
/// time, never accuracy. It is meant for a [`Solver`](crate::solve::Solver) whose closed form is inaccurate,
/// and takes the `g` and the `piece` that the solver was given: `g` is above zero where the piece begins.
/// [`Piece`] has an example.
///
/// Cost: from a fair seed two or three steps, each with a division; 160 at most.
///
/// The sign of `g` at each u narrows the bracket, and a step that would leave the bracket goes to its middle
/// instead. After a Newton step of length d from u, the value of `g` is exactly `d²·(g″(u)/2 − c3·d)`.
///
/// A rounding of `g` at u is 2⁻²⁴ of the sum of its terms' magnitudes. The search ends when the value is
/// below two roundings, since its sign is then uncertain, or when the value after a step is below an eighth
/// of a rounding, since another step could change the last bit alone.
///
/// Beside a critical point the slope is mostly rounding: no step is longer than half the distance to that
/// point. From a bad seed many steps could be cut so, each halving the distance. So a cut step whose number
/// is a multiple of four goes to the bracket's middle, which bounds the number of steps by four times that of
/// bisection.
#[inline(never)]
#[must_use]
pub fn refine(g: &Cubic, piece: &Piece, seed: f32) -> f32 {
    let [c0, _, c2, c3] = g.c;
    // A critical point limits steps only if it bounds the crossing's bracket.
    let top = if piece.fall == Fall::Straight { f32::NEG_INFINITY } else { piece.maximum(g) };
    let (mut lo, mut hi) = (if piece.lo < top && top < piece.hi { top } else { piece.lo }, piece.hi);
    // If c0 is zero, g and its rounding shrink together as u → 0, so that the search might approach a root at
    // 0 for long. That root, simple or multiple, is found by c0 instead.
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
        // Not `<=`, which is true where both sides are infinite, as they may be for large u.
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
