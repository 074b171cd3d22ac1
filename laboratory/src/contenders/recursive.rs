//! One method for every degree: between two neighbouring roots of the derivative, found by the same method, a polynomial is monotone, and a
//! change of sign there is a root, by Newton's method held in its bracket. (Yuksel, High-Performance Polynomial Root Finding for Graphics, 2022.)
//!
//! It stands on both sides of the paper's claim: the cubic of a profile in squared radius against the sextic of a general one.

/// No sextic asks for more.
const MOST: usize = 7;

/// The first root in [lo, hi] of a polynomial of degree 6 at most, constant term first.
pub fn first_root(c: &[f32], lo: f32, hi: f32) -> Option<f32> {
    let mut cuts = [hi; MOST];
    let mut count = 0;
    // Derivatives, the highest first: each one's roots cut the interval for the next.
    for order in (0..c.len().saturating_sub(1)).rev() {
        let (d, len) = derivative(c, order);
        let d = &d[..len];
        let last = order == 0;
        let mut found = [hi; MOST];
        let mut next = 0;
        let mut from = lo;
        let mut before = value(d, lo);
        if last && before == 0.0 {
            return Some(lo);
        }
        for &to in cuts.iter().take(count).chain([&hi]) {
            let after = value(d, to);
            if (before > 0.0) != (after > 0.0) {
                let root = bracketed(d, from, to, before > 0.0);
                if last {
                    return Some(root);
                }
                found[next] = root;
                next += 1;
            }
            (from, before) = (to, after);
        }
        (cuts, count) = (found, next);
    }
    (value(c, hi) == 0.0).then_some(hi)
}

/// The first root in [lo, hi] of a cubic.
pub fn first_root_of_cubic(c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    first_root(c, lo, hi)
}

fn derivative(c: &[f32], order: usize) -> ([f32; MOST], usize) {
    let mut d = [0.0; MOST];
    let len = c.len() - order;
    for (j, d) in d.iter_mut().enumerate().take(len) {
        // (j + order)·…·(j + 1)
        let factor: u32 = (j + 1..=j + order).map(|f| f as u32).product();
        *d = c[j + order] * factor as f32;
    }
    (d, len)
}

fn value(c: &[f32], u: f32) -> f32 {
    c.iter().rev().fold(0.0, |sum, &c| sum * u + c)
}

fn bracketed(c: &[f32], mut lo: f32, mut hi: f32, falling: bool) -> f32 {
    let mut u = 0.5 * lo + 0.5 * hi;
    for _ in 0..200 {
        let (mut g, mut slope) = (0.0, 0.0);
        for &c in c.iter().rev() {
            slope = slope * u + g;
            g = g * u + c;
        }
        if g == 0.0 {
            break;
        }
        if (g > 0.0) == falling {
            lo = u;
        } else {
            hi = u;
        }
        let next = u - g / slope;
        let next = if lo < next && next < hi { next } else { 0.5 * lo + 0.5 * hi };
        if (next - u).abs() <= 0.5 * f32::EPSILON * u.abs() || !(lo < next && next < hi) {
            break;
        }
        u = next;
    }
    u
}
