use super::{Functions, first_of};
use core::f32::consts::TAU;

/// Cardano's formula as textbooks print it: divide by c3, then with `Q = (a² − 3b)/9`, `R = (2a³ − 9ab + 27c)/54`
///
/// - `R² < Q³`: three real roots, `−2·√Q·cos((θ + 2πj)/3) − a/3`, `cos θ = R/√Q³`;
/// - otherwise one, `A + Q/A − a/3`, `A = −sgn R·∛(|R| + √(R² − Q³))`.
///
/// A quadratic or less, by equality with zero, has its own formula, in the form that does not cancel. Unused places are NaN.
pub fn roots<F: Functions>(&[c0, c1, c2, c3]: &[f32; 4]) -> [f32; 3] {
    if c3 == 0.0 {
        let [one, other] = quadratic::<F>(c0, c1, c2);
        return [one, other, f32::NAN];
    }
    let (a, b, c) = (c2 / c3, c1 / c3, c0 / c3);
    let shift = a / 3.0;
    let q = (a * a - 3.0 * b) / 9.0;
    let r = (2.0 * a * a * a - 9.0 * a * b + 27.0 * c) / 54.0;
    if r * r < q * q * q {
        let root = F::sqrt(q);
        let theta = F::acos(r / (root * root * root));
        return [0.0, TAU, -TAU].map(|turn| -2.0 * root * F::cos((theta + turn) / 3.0) - shift);
    }
    let size = F::cbrt(r.abs() + F::sqrt(r * r - q * q * q));
    let first = if r > 0.0 { -size } else { size };
    let second = if first == 0.0 { 0.0 } else { q / first };
    [first + second - shift, f32::NAN, f32::NAN]
}

fn quadratic<F: Functions>(c0: f32, c1: f32, c2: f32) -> [f32; 2] {
    if c2 == 0.0 {
        return [-c0 / c1, f32::NAN];
    }
    let root = F::sqrt(c1 * c1 - 4.0 * c2 * c0);
    let sum = -0.5 * if c1 < 0.0 { c1 - root } else { c1 + root };
    [c0 / sum, sum / c2]
}

pub fn first_root<F: Functions>(c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    first_of(&roots::<F>(c), lo, hi)
}

/// The same, each root followed by one Newton step that nothing guards.
pub fn corrected<F: Functions>(c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    let &[c0, c1, c2, c3] = c;
    let stepped = roots::<F>(c).map(|u| {
        let value = ((c3 * u + c2) * u + c1) * u + c0;
        let slope = (3.0 * c3 * u + 2.0 * c2) * u + c1;
        u - value / slope
    });
    first_of(&stepped, lo, hi)
}
