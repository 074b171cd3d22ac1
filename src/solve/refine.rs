use super::pieces::Piece;
use crate::cubic::Cubic;
use crate::math::order::{greater, lesser};

/// Bisection alone would need one step a bit of the result, 24, after as many as the exponents differ.
/// Newton's needs two or three; the rest is for those who call with an interval like ±10³⁸ and a bad seed.
const MOST_STEPS: u32 = 160;

/// The root of `g` in a monotone piece, by Newton's method from `seed`.
///
/// After a step d from u the value that remains is exactly `d²·(g″(u)/2 − c3·d)`. Below an eighth of a
/// rounding of c0, which is no more than half of `Σ |cⱼ·uʲ|` at a root, there is nothing left to gain. Two
/// steps are taken on trust. If they stay in the piece, the second is short beside what it starts from and
/// beside the way to the turning point, and what remains is nothing, they have found its root, for it has
/// only one. If not, [`guarded`] does.
#[inline(always)]
pub fn refine(g: &Cubic, piece: &Piece, seed: f32) -> f32 {
    let [c0, _, c2, c3] = g.c;
    let u = seed - g.at(seed) / g.slope(seed);
    let (value, slope) = (g.at(u), g.slope(u));
    let step = value / slope;
    let bend = c2 + 3.0 * c3 * u;
    let root = u - step;
    let settled = (step * step * (bend - c3 * step)).abs() <= 0.125 * UNIT * c0.abs();
    let short = step.abs() <= 0.125 * root.abs() && (step * bend).abs() <= 0.125 * slope.abs();
    if settled && short && piece.lo < root && root < piece.hi { root } else { guarded(*g, *piece, seed) }
}

const UNIT: f32 = 1.0 / 16_777_216.0;

/// The same, held in the bracket that the signs of `g` draw ever closer. A step that leaves the bracket is
/// replaced by its middle.
///
/// Two ways out, both bounds on the value: one that is within its own rounding has no sign to go by, only a
/// last step to offer; and one that remains after a step may be below a rounding. Beside a turning point the
/// slope is mostly rounding: no step is longer than half the way to it, and every fourth of those is replaced
/// by the bracket's middle, for from a bad seed they could go on for long.
#[cold]
#[inline(never)]
fn guarded(g: Cubic, piece: Piece, seed: f32) -> f32 {
    let [_, _, c2, c3] = g.c;
    let (mut lo, mut hi) = (piece.lo, piece.hi);
    let mut u = seed;
    for count in 0..MOST_STEPS {
        if !(lo < u && u < hi) {
            // A double root at an end, such as a cone's apex on its axis, is seeded there exactly.
            if u == lo && g.at(u) == 0.0 {
                break;
            }
            u = 0.5 * lo + 0.5 * hi;
            if !(lo < u && u < hi) {
                break;
            }
        }
        let value = g.at(u);
        let rounding = UNIT * g.size(u);
        let step = value / g.slope(u);
        let reach = 0.5 * lesser(u - piece.maximum.at, piece.minimum.at - u);
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
    // Not `clamp`, which panics if the ends are out of order, so that firmware would carry the message.
    greater(piece.lo, lesser(piece.hi, u))
}
