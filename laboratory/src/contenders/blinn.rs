use super::{Functions, first_of};

/// Blinn's homogeneous form (How to Solve a Cubic Equation, part 5, IEEE Computer Graphics and Applications, 2007):
/// `a·x³ + 3b·x²w + 3c·xw² + d·w³`, the Hessian's three minors, and the larger and the smaller root each from the
/// depressed form, of `(x, w)` or of `(w, x)`, in which it does not cancel. Roots are ratios, so nothing is divided by a leading coefficient.
pub fn first_root<F: Functions>(&[c0, c1, c2, c3]: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    let (a, b, c, d) = (c3, c2 / 3.0, c1 / 3.0, c0);
    let d1 = a * c - b * b;
    let d2 = a * d - b * c;
    let d3 = b * d - c * c;
    let discriminant = 4.0 * d1 * d3 - d2 * d2;
    // The depressed cubics x³ + 3·bar_c·x + bar_d of the two forms.
    let forward = (a, d1, -2.0 * b * d1 + a * d2);
    let backward = (d, d3, -d * d2 + 2.0 * c * d3);
    if discriminant <= 0.0 {
        let is_forward = b * b * b * d >= a * c * c * c;
        let (bar_a, bar_c, bar_d) = if is_forward { forward } else { backward };
        let t0 = bar_a.abs() * F::sqrt(-discriminant);
        let t0 = if bar_d < 0.0 { t0 } else { -t0 };
        let t1 = t0 - bar_d;
        let p = F::cbrt(0.5 * t1);
        let q = if t1 == t0 { -p } else { -bar_c / p };
        let x = if bar_c <= 0.0 { p + q } else { -bar_d / (p * p + q * q + bar_c) };
        let root = if is_forward { (x - b) / a } else { -d / (x + c) };
        return first_of(&[root], lo, hi);
    }
    let outer = |(bar_a, bar_c, bar_d): (f32, f32, f32)| {
        let third = angle::<F>(bar_a.abs() * F::sqrt(discriminant), -bar_d) / 3.0;
        let size = F::sqrt(-bar_c);
        let cos = F::cos(third);
        let sin = F::sqrt(1.0 - cos * cos);
        (2.0 * size * cos, -size * (cos + 1.732_050_8 * sin))
    };
    let (x1, x3) = outer(forward);
    let large = (if x1 + x3 > 2.0 * b { x1 } else { x3 } - b, a);
    let (x1, x3) = outer(backward);
    let small = (-d, if x1 + x3 < 2.0 * c { x1 } else { x3 } + c);
    let e = large.1 * small.1;
    let f = -large.0 * small.1 - large.1 * small.0;
    let g = large.0 * small.0;
    let middle = (c * f - b * g, -b * f + c * e);
    first_of(&[large, small, middle].map(|(x, w)| x / w), lo, hi)
}

/// The angle of (x, y) with y ≥ 0, from 0 to π.
fn angle<F: Functions>(y: f32, x: f32) -> f32 {
    F::acos((x / F::sqrt(x * x + y * y)).clamp(-1.0, 1.0))
}
