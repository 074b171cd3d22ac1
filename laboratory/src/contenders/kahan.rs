use super::{Functions, first_of};

/// Kahan's QBC (To Solve a Real Cubic Equation, lecture notes, Berkeley 1986): Newton's method from outside all roots to one of
/// them, a deflation chosen to be stable, and the quadratic that remains.
///
/// His safety factor, one part in a billion for double, is here two units of f32.
pub fn first_root<F: Functions>(&[c0, c1, c2, c3]: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    if c3 == 0.0 {
        let [one, other] = quadratic::<F>(c2, c1, c0);
        return first_of(&[one, other], lo, hi);
    }
    let (x, b, c) = if c0 == 0.0 { (0.0, c2, c1) } else { real_root::<F>(c3, c2, c1, c0) };
    let [one, other] = quadratic::<F>(c3, b, c);
    first_of(&[x, one, other], lo, hi)
}

/// A root x of `a·x³ + b·x² + c·x + d`, and what `a·x² + …` remains.
fn real_root<F: Functions>(a: f32, b: f32, c: f32, d: f32) -> (f32, f32, f32) {
    let mut x = -(b / a) / 3.0;
    let (mut value, mut slope, mut b1, mut c2) = horner(x, a, b, c, d);
    let t = value / a;
    let s = if t < 0.0 { -1.0 } else { 1.0 };
    let mut r = F::cbrt(t.abs());
    let t = -slope / a;
    if t > 0.0 {
        let outer = F::sqrt(t);
        r = 1.324_718 * if r > outer { r } else { outer };
    }
    let mut next = x - s * r;
    if next != x {
        // From outside the roots Newton's steps all go one way, until rounding turns them.
        for _ in 0..64 {
            x = next;
            (value, slope, b1, c2) = horner(x, a, b, c, d);
            next = if slope == 0.0 { x } else { x - value / slope / (1.0 + 2.0 * f32::EPSILON) };
            if !(s * next > s * x) {
                break;
            }
        }
        if a.abs() * x * x > (d / x).abs() {
            c2 = -d / x;
            b1 = (c2 - c) / x;
        }
    }
    (x, b1, c2)
}

fn horner(x: f32, a: f32, b: f32, c: f32, d: f32) -> (f32, f32, f32, f32) {
    let q0 = a * x;
    let b1 = q0 + b;
    let c2 = b1 * x + c;
    (c2 * x + d, (q0 + b1) * x + c2, b1, c2)
}

/// The real roots of `a·x² + b·x + c`.
fn quadratic<F: Functions>(a: f32, b: f32, c: f32) -> [f32; 2] {
    let half = -0.5 * b;
    let discriminant = half * half - a * c;
    if discriminant < 0.0 {
        return [f32::NAN; 2];
    }
    let root = F::sqrt(discriminant);
    let sum = if half < 0.0 { half - root } else { half + root };
    if sum == 0.0 { [0.0, if a == 0.0 { f32::NAN } else { 0.0 }] } else { [c / sum, sum / a] }
}
