use super::Solver;
use super::pieces::crossing;
use crate::cubic::Cubic;
use crate::math::minmax::{greater, lesser};

/// How far an interval may reach to be solved as it is.
const TAME: f32 = (1_u64 << 30) as f32;

/// From where on the unit is 2¹²⁰. (`wide`.)
const FAR: f32 = TAME * TAME * TAME;

/// The largest coefficient may be from 2⁻²⁰ to 2²⁰ to be solved as it is.
const RANGE: u32 = 20 << 23;

/// Whether neither coefficients nor interval are so large, or so small, that a product may leave f32's range.
#[inline(always)]
pub(super) fn is_tame(g: &Cubic, lo: f32, hi: f32) -> bool {
    // Magnitudes are ordered as their bits are, NaN above all.
    let [b0, b1, b2, b3] = g.c.map(bits);
    let largest = b0.max(b1).max(b2.max(b3));
    let ends = bits(lo).max(bits(hi));
    largest.wrapping_sub(1.0_f32.to_bits() - RANGE) < 2 * RANGE && ends <= TAME.to_bits() && lo <= hi
}

fn bits(x: f32) -> u32 {
    x.to_bits() & 0x7fff_ffff
}

/// The crossing of any cubic in any interval, or where it starts if that is zero. `positive` says how it
/// starts, if that is known.
///
/// The interval is cut at ±2³⁰ and ±2⁹⁰, and each part solved in a unit of its own, 2⁰, 2⁶⁰, 2¹²⁰, so that
/// |u| is from 2⁻³⁰ (0 in the middle part) to 2³⁰ there, and the largest coefficient in [1, 2): then no power
/// overflows, and a coefficient that underflows is below 2⁻³⁶ of the largest term.
#[cold]
#[inline(never)]
pub(super) fn wide<S: Solver>(g: &Cubic, lo: f32, hi: f32, mut positive: Option<bool>) -> Option<f32> {
    const PARTS: [(f32, f32, i32); 5] =
        [(f32::MIN, -FAR, 120), (-FAR, -TAME, 60), (-TAME, TAME, 0), (TAME, FAR, 60), (FAR, f32::MAX, 120)];
    if !(lo <= hi && g.c.iter().all(|c| c.is_finite())) {
        return None;
    }
    let told = positive.is_some();
    for (from, to, unit) in PARTS {
        let (from, to) = (greater(from, lo), lesser(to, hi));
        if !(from < to || from == to && lo == hi) {
            continue;
        }
        let g = stretched(g, unit);
        let [a, b] = [from, to].map(|u| u * power(-unit));
        let start = g.at(a);
        let sign = positive.unwrap_or(start > 0.0);
        // Zero where the interval begins, or a crossing that rounding puts between two parts.
        if !(told && from <= lo) && (start == 0.0 || (start > 0.0) != sign) {
            return Some(from);
        }
        if let Some(v) = crossing::<S>(&g, a, b, sign) {
            return Some(v * power(unit));
        }
        positive = Some(sign);
    }
    None
}

/// The cubic in the unit of the part that u lies in, and u in it.
#[cold]
#[inline(never)]
pub(super) fn local(g: &Cubic, u: f32) -> (Cubic, f32) {
    let unit = 60 * (i32::from(u.abs() > TAME) + i32::from(u.abs() > FAR));
    (stretched(g, unit), u * power(-unit))
}

/// The cubic over another unit, 2ᵘⁿⁱᵗ, scaled by a power of two so that its largest coefficient is in [1, 2).
#[inline(never)]
fn stretched(g: &Cubic, unit: i32) -> Cubic {
    let units = [0, unit, 2 * unit, 3 * unit];
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

/// x·2ⁿ, in two factors, since one of 2ⁿ may not be normal.
#[inline(never)]
fn times_power(x: f32, n: i32) -> f32 {
    x * power(n / 2) * power(n - n / 2)
}

/// `⌊log₂|x|⌋`, far below all others if x is 0.
#[inline(never)]
fn exponent(x: f32) -> i32 {
    const LIFT: f32 = (1 << 24) as f32;
    let biased = |x| (bits(x) >> 23) as i32;
    match biased(x) {
        0 if x == 0.0 => -1_000,
        0 => biased(x * LIFT) - 151,
        e => e - 127,
    }
}

/// 2ⁿ, or the nearest that is normal.
fn power(n: i32) -> f32 {
    f32::from_bits(((n + 127).clamp(1, 254) as u32) << 23)
}
