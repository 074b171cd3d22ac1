use super::collect::collect;
use crate::cubic::Cubic;
use crate::math::minmax::{greater, lesser};
use crate::solve::Solver;
use heapless::Vec;

/// 2³⁰: a cubic is solved as it is if its interval reaches no farther than this from zero. Since its
/// coefficients are below 2²⁰ ([`RANGE`]), no term is then larger than (2³⁰)³·2²⁰ = 2¹¹⁰.
pub(super) const TAME: f32 = (1_u64 << 30) as f32;

/// 2⁹⁰: the parts of the interval beyond this have the unit 2¹²⁰. (See [`rescaled`].)
const TAME_CUBED: f32 = TAME * TAME * TAME;

/// A cubic is solved as it is if its largest coefficient is in [2⁻²⁰, 2²⁰). This is the 20, shifted to where
/// the exponent stands in the bits of an f32.
const RANGE: u32 = 20 << 23;

/// Whether a cubic can be solved as it is, by [`TAME`] and [`RANGE`]: then no product overflows, and products
/// that underflow are below 2⁻¹⁰⁶ of the largest coefficient. False if a number is infinite or NaN, or if lo
/// is above hi.
#[inline(always)]
pub(super) fn is_tame(g: &Cubic, lo: f32, hi: f32) -> bool {
    // The bits of magnitudes are ordered as the magnitudes are, NaN's above all others.
    let [b0, b1, b2, b3] = g.c.map(bits);
    let largest = b0.max(b1).max(b2.max(b3));
    let ends = bits(lo).max(bits(hi));
    largest.wrapping_sub(1.0_f32.to_bits() - RANGE) < 2 * RANGE && ends <= TAME.to_bits() && lo <= hi
}

/// The bits of |x|.
fn bits(x: f32) -> u32 {
    x.to_bits() & 0x7fff_ffff
}

/// The first roots of any cubic in any interval, ascending, at most `most` of them. Empty if a coefficient is
/// infinite or NaN, or if lo ≤ hi does not hold (as with NaN).
///
/// The interval is cut at ±2³⁰ and ±2⁹⁰, and in each part u is measured in a unit of its own, 2⁰, 2⁶⁰ or
/// 2¹²⁰, and the cubic scaled so that its largest coefficient is in [1, 2). So no power overflows: |u| is
/// 2³⁰ at most. Where a coefficient underflows, it is below 2⁻¹²⁶ of the largest. In the outer parts |u| is
/// 2⁻³⁰ or more, too, so that its term is below 2⁻¹²⁶·(2³⁰)³ = 2⁻³⁶ of the largest coefficient's; in the
/// middle part, where u may be 0, such values count as zero. The sign at a cut is decided once, in the part
/// that ends there.
#[cold]
#[inline(never)]
pub(super) fn rescaled<S: Solver>(g: &Cubic, lo: f32, hi: f32, most: usize) -> Vec<f32, 3> {
    const PARTS: [(f32, f32, i32); 5] = [
        (f32::MIN, -TAME_CUBED, 120),
        (-TAME_CUBED, -TAME, 60),
        (-TAME, TAME, 0),
        (TAME, TAME_CUBED, 60),
        (TAME_CUBED, f32::MAX, 120),
    ];
    let mut roots = Vec::new();
    if !(lo <= hi && g.c.iter().all(|c| c.is_finite())) {
        return roots;
    }
    // Neither end is NaN. The interval [∞, ∞] becomes [∞, f32::MAX], and [−∞, −∞] becomes [f32::MIN, −∞]:
    // both are empty, and no part has roots.
    let (lo, hi) = (greater(f32::MIN, lo), lesser(f32::MAX, hi));
    let mut sign = None;
    for (from, to, log2_unit) in PARTS {
        let (from, to) = (greater(from, lo), lesser(to, hi));
        if from < to || from == to && lo == hi && sign.is_none() {
            let g = if log2_unit == 0 && is_tame(g, from, to) { *g } else { stretched(g, log2_unit) };
            let [a, b] = [from, to].map(|u| u * power(-log2_unit));
            sign = Some(collect::<S>(&g, [a, b], sign, power(log2_unit), most, &mut roots));
            // Every point is a root of the zero cubic. The list then holds the first one alone.
            if g.c == [0.0; 4] {
                break;
            }
        }
    }
    roots
}

/// The cubic with u measured in units of 2 to the power `log2_unit`, times a power of two that brings its
/// largest coefficient into [1, 2).
#[inline(never)]
fn stretched(g: &Cubic, log2_unit: i32) -> Cubic {
    let units = [0, log2_unit, 2 * log2_unit, 3 * log2_unit];
    let mut largest = i32::MIN;
    for (&c, n) in g.c.iter().zip(units) {
        largest = largest.max(exponent(c) + n);
    }
    let mut g = *g;
    for (c, n) in g.c.iter_mut().zip(units) {
        *c = times_power(*c, n - largest);
    }
    g
}

/// x·2ⁿ, or ±∞ or 0 if that overflows or underflows. It is multiplied in two steps, since 2ⁿ may lie outside
/// f32's range.
#[inline(never)]
fn times_power(x: f32, n: i32) -> f32 {
    x * power(n / 2) * power(n - n / 2)
}

/// `⌊log₂|x|⌋` of a finite x, and −1000, which is below all other results, if x is 0.
#[inline(never)]
fn exponent(x: f32) -> i32 {
    // A subnormal number times 2²⁴ is normal; its exponent is then that much too large.
    const TO_NORMAL: f32 = (1 << 24) as f32;
    let biased = |x| (bits(x) >> 23) as i32;
    match biased(x) {
        0 if x == 0.0 => -1_000,
        0 => biased(x * TO_NORMAL) - 127 - 24,
        e => e - 127,
    }
}

/// 2ⁿ, with n clamped to [−126, 127], so that the result is a normal number.
fn power(n: i32) -> f32 {
    f32::from_bits(((n + 127).clamp(1, 254) as u32) << 23)
}
