//! Polynomials over [0, 1] by their Bernstein coefficients, in f64 or in balls.

use core::ops::{Add, Div, Mul, Sub};

/// What coefficients are: f64, or a [`Ball`](crate::ball::Ball) around it.
pub trait Number:
    Copy + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<f64, Output = Self>
{
}

impl<T> Number for T where
    T: Copy + From<f64> + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<f64, Output = T>
{
}

/// The same coefficients as exact numbers of another type.
pub fn lift<T: Number>(c: &[f64]) -> Vec<T> {
    c.iter().map(|c| T::from(*c)).collect()
}

/// The value at t, by de Casteljau's interpolations.
pub fn value(c: &[f64], t: f64) -> f64 {
    blossom(c, core::iter::repeat_n(t, c.len() - 1))
}

/// The coefficients of the derivative with respect to t: one fewer, or a single zero for a constant.
pub fn derivative(c: &[f64]) -> Vec<f64> {
    match c.len() {
        1 => vec![0.0],
        n => c.windows(2).map(|c| (n - 1) as f64 * (c[1] - c[0])).collect(),
    }
}

/// The coefficients over [a, b] in place of [0, 1]. Where b < a the direction turns around.
pub fn restrict<T: Number>(c: &[T], a: f64, b: f64) -> Vec<T> {
    let degree = c.len() - 1;
    (0..=degree)
        .map(|i| blossom(c, core::iter::repeat_n(a, degree - i).chain(core::iter::repeat_n(b, i))))
        .collect()
}

/// The polar form: interpolates once for each of the `degree` arguments.
fn blossom<T: Number>(c: &[T], arguments: impl Iterator<Item = f64>) -> T {
    let mut c = c.to_vec();
    for t in arguments {
        for i in 0..c.len() - 1 {
            c[i] = c[i] * (T::from(1.0) - T::from(t)) + c[i + 1] * T::from(t);
        }
        c.pop();
    }
    c[0]
}

/// The product: its degree is the sum of the factors' degrees.
pub fn product<T: Number>(a: &[T], b: &[T]) -> Vec<T> {
    let (m, n) = (a.len() - 1, b.len() - 1);
    if m == 0 {
        return b.iter().map(|b| *b * a[0]).collect();
    }
    if n == 0 {
        return product(b, a);
    }
    (0..=m + n)
        .map(|k| {
            let terms = (k.saturating_sub(n)..=k.min(m))
                .map(|i| a[i] * b[k - i] * T::from(binomial(m, i) * binomial(n, k - i)));
            terms.reduce(|a, b| a + b).unwrap_or(T::from(0.0)) / binomial(m + n, k)
        })
        .collect()
}

/// The sum, of the higher of the two degrees.
pub fn sum<T: Number>(a: &[T], b: &[T]) -> Vec<T> {
    let elevate = |c: &[T], n: usize| match n - c.len() {
        0 => c.to_vec(),
        by => product(c, &vec![T::from(1.0); by + 1]),
    };
    let n = a.len().max(b.len());
    elevate(a, n).into_iter().zip(elevate(b, n)).map(|(a, b)| a + b).collect()
}

/// All coefficients times a factor.
pub fn scale<T: Number>(c: &[T], factor: T) -> Vec<T> {
    c.iter().map(|c| *c * factor).collect()
}

/// The highest degree of a source: the certificate's polynomials have three times as much, and up to there
/// products of binomial coefficients are exact in f64 (C(48, 24) < 2⁵³).
pub const HIGHEST_DEGREE: usize = 16;

/// n over k, exact as far as [`HIGHEST_DEGREE`] needs it.
fn binomial(n: usize, k: usize) -> f64 {
    (0..k.min(n - k)).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// Where in (0, 1) the polynomial is zero, in increasing order: by bisection for as long as the signs of the
/// coefficients allow a zero. Of a polynomial that is zero everywhere no zero is reported.
pub fn zeros(c: &[f64]) -> Vec<f64> {
    let size = c.iter().fold(0.0, |size: f64, c| size.max(c.abs()));
    let mut zeros = Vec::new();
    if size > 0.0 && size.is_finite() {
        search(c, 0.0, 1.0, 1e-14 * size, &mut zeros);
    }
    zeros
}

fn search(c: &[f64], a: f64, b: f64, zero: f64, zeros: &mut Vec<f64>) {
    let signs: Vec<bool> = c.iter().filter(|c| c.abs() > zero).map(|c| *c > 0.0).collect();
    let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let middle = 0.5 * (a + b);
    if changes == 0 && !signs.is_empty() {
        return;
    }
    // All but zero: the whole interval would do. So would it where f64 has no number between.
    if signs.is_empty() || b - a < 1e-15 {
        zeros.push(middle);
        return;
    }
    let (left, right) = (restrict(c, 0.0, 0.5), restrict(c, 0.5, 1.0));
    search(&left, a, middle, zero, zeros);
    // A zero in the middle is an end of both halves, and changes no sign in either.
    let at_middle = right[0].abs() <= zero && !zeros.last().is_some_and(|last| middle - last < 1e-12);
    if at_middle {
        zeros.push(middle);
    }
    let known = zeros.len();
    search(&right, middle, b, zero, zeros);
    // The same zero found from both sides of the middle.
    if zeros.len() > known && known > 0 && zeros[known] - zeros[known - 1] < 1e-12 {
        zeros.remove(known);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_single_double_and_in_the_middle() {
        assert!(zeros(&[1.0, 1.0]).is_empty());
        assert_eq!(zeros(&[-1.0, 1.0]), [0.5]);
        let double = zeros(&[0.25, -0.25, 0.25]);
        assert!(double.len() == 1 && (double[0] - 0.5).abs() < 1e-7, "{double:?}");
        // (t − 0.3)·(t − 0.8)
        let two = zeros(&product(&[-0.3, 0.7], &[-0.8, 0.2]));
        assert!(two.len() == 2 && (two[0] - 0.3).abs() < 1e-12 && (two[1] - 0.8).abs() < 1e-12, "{two:?}");
        // (t − 0.3)², whose zero no bisection meets.
        let double = zeros(&product(&[-0.3, 0.7], &[-0.3, 0.7]));
        assert!(double.len() == 1 && (double[0] - 0.3).abs() < 1e-6, "{double:?}");
    }

    #[test]
    fn products_and_restrictions_agree_with_values() {
        let (a, b) = ([1.0, -2.0, 0.5, 4.0], [0.3, 2.0, -1.0]);
        let both = product(&a, &b);
        let part = restrict(&both, 0.9, 0.2);
        for t in [0.0, 0.1, 0.37, 0.9, 1.0] {
            assert!((value(&both, t) - value(&a, t) * value(&b, t)).abs() < 1e-14);
            assert!((value(&part, t) - value(&both, 0.9 - 0.7 * t)).abs() < 1e-14);
            assert!((value(&sum(&a, &b), t) - value(&a, t) - value(&b, t)).abs() < 1e-14);
        }
    }
}
