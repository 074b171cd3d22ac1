use super::split::Guess;
use crate::cubic::Cubic;

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

/// The root of `c1·d + c2·d² + c3·d³ = height`, where nothing is negative, and the slope there.
///
/// Newton's steps `(height + c2·d² + 2·c3·d³)/(c1 + 2·c2·d + 3·c3·d²)` from `∛(height/c3)`. That is close where
/// the cubic term rules; where it does not the first step comes within a factor of 3 and the second where the
/// others rule. From above the root they come down to it, and nothing cancels on the way: at most four bring
/// the last below 10⁻³ of d, which leaves 10⁻⁶. The square's term may lead to the cubic's by no more than
/// `c2³ ≤ 2·c3²·height`, or they are more.
#[cold]
#[inline(never)]
pub(super) fn positive_root(height: f32, [c1, c2, c3]: [f32; 3]) -> (f32, f32) {
    if !(height > 0.0) {
        return (0.0, f32::INFINITY);
    }
    let slope = |d| c1 + (2.0 * c2 + 3.0 * c3 * d) * d;
    let mut d = cube_root_of_ratio(height, c3);
    loop {
        let last = d;
        d = (height + (c2 + 2.0 * c3 * d) * (d * d)) / slope(d);
        if !((d - last).abs() > 1e-3 * d) {
            return (d, slope(d));
        }
    }
}

/// `∛(a/b)` of positive numbers within 6 %, whatever a/b: bits less those of one are about a logarithm.
fn cube_root_of_ratio(a: f32, b: f32) -> f32 {
    let [a, b] = [a, b].map(|x| x.to_bits() as i32);
    f32::from_bits(((a - b) / 3 + 0x3f7c_538b) as u32)
}
