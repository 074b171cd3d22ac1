use super::split::Guess;
use crate::cubic::Cubic;

/// Of Newton's, for a positive root.
const MOST_STEPS: u32 = 4;

/// The root of a cubic that has no turning points.
///
/// About the point of inflection i, with v = u − i: `c3·v³ + m·v + k = 0`, `k = g(i)`, `m = g′(i)`, all of one
/// sign but for v.
///
/// As c3 → 0 that point goes to infinity, and v with it. The root by then is where the line from zero meets
/// it: `−c0/c1`, good to 2⁻⁹ wherever i lies so far that `c1·i` is 2⁹·c0.
///
/// Apart, since it is rare.
#[cold]
#[inline(never)]
pub(super) fn from_inflection(g: Cubic) -> Guess {
    let [c0, c1, c2, c3] = g.c;
    let i = -c2 / (3.0 * c3);
    if !(512.0 * c0.abs() >= (c1 * i).abs()) {
        let u = -c0 / c1;
        return Guess { from: 0.0, d: u, slope: g.slope(u) };
    }
    // Rounding may turn the sign of m, where it is nothing else.
    let (m, k) = ((c1 + c2 * i).abs(), g.at(i));
    let (v, slope) = positive_root(k.abs(), [m, 0.0, c3.abs()]);
    Guess { from: i, d: v.copysign(k), slope: -slope }
}

/// The root of `c1·d + c2·d² + c3·d³ = height`, where nothing is negative and c1 or c2 is nothing, and the
/// slope there.
///
/// Newton's steps `(height + c2·d² + 2·c3·d³)/(c1 + 2·c2·d + 3·c3·d²)` from `∛(height/c3)`. That is close
/// where the cubic term rules; where it does not the first step comes within a factor of 3 and the second
/// where the others rule. From above the root they come down to it, and nothing cancels on the way: at most
/// four bring the last below 10⁻³ of d, which leaves 1.2·10⁻⁶. The square's term may lead to the cubic's by
/// no more than `c2³ ≤ 2·c3²·height`, or they are more. Where terms underflow they may go to and fro for
/// ever, and the fourth is the last: what remains there is below what counts.
#[cold]
#[inline(never)]
pub(super) fn positive_root(height: f32, [c1, c2, c3]: [f32; 3]) -> (f32, f32) {
    if !(height > 0.0) {
        return (0.0, f32::INFINITY);
    }
    let (d, slope, _) = approach(height, [c1, c2, c3]);
    (d, slope)
}

/// The same, and how many steps it took.
#[inline(always)]
fn approach(height: f32, [c1, c2, c3]: [f32; 3]) -> (f32, f32, u32) {
    let slope = |d| c1 + (2.0 * c2 + 3.0 * c3 * d) * d;
    let mut d = cube_root_of_ratio(height, c3);
    let (mut steps, mut is_far) = (0, true);
    while is_far && steps < MOST_STEPS {
        let last = d;
        d = (height + (c2 + 2.0 * c3 * d) * (d * d)) / slope(d);
        is_far = (d - last).abs() > 1e-3 * d;
        steps += 1;
    }
    (d, slope(d), steps)
}

/// `∛(a/b)` of positive numbers within 6 %, whatever a/b: bits less those of one are about a logarithm.
fn cube_root_of_ratio(a: f32, b: f32) -> f32 {
    let [a, b] = [a, b].map(|x| x.to_bits() as i32);
    // What is no positive number, or none at all, may wrap; there is no root of it.
    f32::from_bits((a.wrapping_sub(b) / 3 + 0x3f7c_538b) as u32)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{MOST_STEPS, approach, positive_root};

    /// A chord's cubic may overflow: what comes of it is held to the chord, NaN too, and nothing panics.
    #[test]
    fn no_numbers_do_not_panic() {
        for c3 in [f32::NAN, -f32::NAN, f32::NEG_INFINITY, -1.0, 0.0] {
            for height in [f32::INFINITY, f32::MAX, f32::MIN_POSITIVE] {
                let _ = positive_root(height, [0.0, 1.0, c3]);
            }
        }
    }

    /// `c1·d + d³ = height` and `c2·d² + d³ = height`, c1 over twenty decades and c2 from nothing to what the
    /// doc allows, both in units of ∛height. The seed is another for every height from 1 to 8.
    #[test]
    fn four_steps_leave_a_millionth() {
        let (mut most, mut worst) = (0, 0.0_f64);
        for i in 0..=1000 {
            for j in 0..64 {
                let height = (f64::from(j) * 3.0 / 64.0).exp2();
                let unit = height.cbrt();
                let share = f64::from(i) / 1000.0;
                let c1 = (unit * unit * 10_f64.powf(20.0 * share - 10.0)) as f32;
                let c2 = (unit * 2_f64.cbrt() * share) as f32;
                for [c1, c2] in [[c1, 0.0], [0.0, c2]] {
                    let (d, _, steps) = approach(height as f32, [c1, c2, 1.0]);
                    let (a, b, d) = (f64::from(c1), f64::from(c2), f64::from(d));
                    let off = ((d + b) * d + a) * d - f64::from(height as f32);
                    most = most.max(steps);
                    worst = worst.max((off / (((3.0 * d + 2.0 * b) * d + a) * d)).abs());
                }
            }
        }
        assert_eq!(most, MOST_STEPS);
        assert!(0.9 * 1.2e-6 < worst && worst <= 1.2e-6, "{worst}");
    }
}
