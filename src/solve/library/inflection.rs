use crate::cubic::Cubic;

/// A root before the last Newton step: the point `from + d`, where `from` is a critical point, the point of
/// inflection, or 0. At `from + d` the slope of g is `slope`.
pub(super) struct Guess {
    pub from: f32,
    pub d: f32,
    pub slope: f32,
}

/// The most Newton steps of [`approach`].
const APPROACH_LIMIT: u32 = 4;

/// The root of a cubic that falls and has no critical points.
///
/// With the point of inflection p and d = u − p the equation is `c3·d³ + slope·d + value = 0`, where slope
/// and value are those of g at p, and c3 and slope have one sign.
///
/// As c3 → 0, p and d go to infinity. So where |c1·p| is more than 2⁹·|c0|, or p is infinite or NaN, the
/// result is `−c0/c1` instead, the root of the tangent at u = 0, which is then within 2⁻⁹, relative.
///
/// Not inline, since it is rarely called.
#[cold]
#[inline(never)]
pub(super) fn from_inflection(g: Cubic) -> Guess {
    let [c0, c1, c2, c3] = g.c;
    let p = -c2 / (3.0 * c3);
    if !(512.0 * c0.abs() >= (c1 * p).abs()) {
        let u = -c0 / c1;
        return Guess { from: 0.0, d: u, slope: g.slope(u) };
    }
    // g falls, so its slope at p is negative. The sign of the computed one may be wrong where it is all
    // rounding, so that its magnitude is taken.
    let (value, slope) = (g.at(p), (c1 + c2 * p).abs());
    let (d, slope) = positive_root(value.abs(), [slope, 0.0, c3.abs()]);
    Guess { from: p, d: d.copysign(value), slope: -slope }
}

/// The pair of the positive root d of `c1·d + c2·d² + c3·d³ = height` and the slope of the left side there.
/// No coefficient may be negative, and c1 or c2 must be zero. If height is not above 0, the pair is (0, ∞).
///
/// Newton's method, `d ← (height + c2·d² + 2·c3·d³)/(c1 + 2·c2·d + 3·c3·d²)`, starts at `∛(height/c3)`. If
/// the cubic term dominates, the root is near there; if not, the first step comes within a factor of 3 of the
/// root, and the second comes near. From above the root the steps descend to it, and no sum cancels. If
/// `c2³ ≤ 2·c3²·height`, one of the first four steps is shorter than 10⁻³ of d, and then d is off by no more
/// than 1.2·10⁻⁶; a larger c2 would take more steps. Where terms underflow, the steps may go back and forth
/// without end. There, too, the fourth is the last, and the value that it leaves g is below 2⁻¹⁰⁶ of the
/// largest coefficient.
#[cold]
#[inline(never)]
pub(super) fn positive_root(height: f32, [c1, c2, c3]: [f32; 3]) -> (f32, f32) {
    if !(height > 0.0) {
        return (0.0, f32::INFINITY);
    }
    let (d, slope, _) = approach(height, [c1, c2, c3]);
    (d, slope)
}

/// The root and the slope of [`positive_root`] for height > 0, and how many steps it took.
#[inline(always)]
fn approach(height: f32, [c1, c2, c3]: [f32; 3]) -> (f32, f32, u32) {
    let slope = |d| c1 + (2.0 * c2 + 3.0 * c3 * d) * d;
    let mut d = cube_root_of_ratio(height, c3);
    let (mut steps, mut is_far) = (0, true);
    while is_far && steps < APPROACH_LIMIT {
        let last = d;
        d = (height + (c2 + 2.0 * c3 * d) * (d * d)) / slope(d);
        is_far = (d - last).abs() > 1e-3 * d;
        steps += 1;
    }
    (d, slope(d), steps)
}

/// `∛(a/b)` of positive normal numbers a and b, within 6.2 %, even if a/b overflows or underflows.
///
/// The bits of a number, read as an integer, less those of 1, are 2²³ times its logarithm to base 2, or up to
/// 0.0861·2²³ less. So the bits of the cube root of a/b are about those of 1, plus a third of the difference
/// between the bits of a and those of b. In units of 2²³ that third is off by up to 0.0287 to either side.
/// Bits that are a logarithm stand for a number whose logarithm is up to 0.0861 larger. Subtracting
/// 0.0287·2²³ from the bits of 1, which leaves 0x3f7c_538b, brings the error of the logarithm from
/// [−0.0287, 0.1148] to [−0.0574, 0.0861], which is 6.2 % at most.
fn cube_root_of_ratio(a: f32, b: f32) -> f32 {
    let [a, b] = [a, b].map(|x| x.to_bits() as i32);
    // For other numbers, NaN too, the result is unspecified: whoever called the solver replaces a root
    // outside the piece. The difference of such numbers' bits may overflow, so it is a wrapping one.
    f32::from_bits((a.wrapping_sub(b) / 3 + 0x3f7c_538b) as u32)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{APPROACH_LIMIT, approach, positive_root};

    /// Coefficients that overflowed give an unspecified root, and do not panic.
    #[test]
    fn nan_does_not_panic() {
        for c3 in [f32::NAN, -f32::NAN, f32::NEG_INFINITY, -1.0, 0.0] {
            for height in [f32::INFINITY, f32::MAX, f32::MIN_POSITIVE] {
                let _ = positive_root(height, [0.0, 1.0, c3]);
            }
        }
    }

    /// The doc's 6.2 %, over three octaves of a/b: others differ from these in the exponent alone.
    #[test]
    fn cube_roots_are_within_a_sixteenth() {
        let errors = (1_f32.to_bits()..8_f32.to_bits()).step_by(101).map(|bits| {
            let ratio = f32::from_bits(bits);
            [(ratio, 1.0), (1.0, ratio), (1.5 * ratio, 1.5)].map(|(a, b)| {
                (f64::from(super::cube_root_of_ratio(a, b)) / (f64::from(a) / f64::from(b)).cbrt() - 1.0)
                    .abs()
            })
        });
        let worst = errors.flatten().fold(0.0, f64::max);
        assert!(0.9 * 0.062 < worst && worst <= 0.062, "{worst}");
    }

    /// `c1·d + d³ = height` and `c2·d² + d³ = height`, c1 over twenty decades and c2 from zero to what the
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
        assert_eq!(most, APPROACH_LIMIT);
        assert!(0.9 * 1.2e-6 < worst && worst <= 1.2e-6, "{worst}");
    }
}
