//! How wrong the roots of a Bézier curve's ordinates are.
//!
//! As [`judge`](crate::judge) has it for coefficients: changing every ordinate by δ relative changes g(u) by
//! at most `δ·Σ |bⱼ|·Bⱼ(u)`. A root may besides have been moved by rounding, since beside u = 1 no float is
//! near enough; so it is judged by the least of the values within that, and where the sign changes within
//! that, it is 0.

use crate::UNITS;
use crate::exact::{Exact, Polynomial, exact, float, quotient, sign};
use dashu_base::Abs;

/// What a list of roots in [0, 1] is off by.
#[derive(Clone, Copy, Debug)]
pub struct BernsteinVerdict {
    /// What makes each root one, in units of each ordinate.
    pub residual: f64,
    /// What makes the signs between the roots alternate.
    pub skipped: f64,
}

/// A cubic by its ordinates, exactly.
pub struct Ordinates {
    b: [Exact; 4],
    /// `(1 − u)⁻³·g`, over `w = u/(1 − u)`.
    over_ratio: Polynomial,
}

impl Ordinates {
    pub fn new(b: [f32; 4]) -> Self {
        let b = b.map(exact);
        let over_ratio = Polynomial(vec![b[0].clone(), exact(3.0) * &b[1], exact(3.0) * &b[2], b[3].clone()]);
        Self { b, over_ratio }
    }

    /// g(u), and its terms' magnitudes.
    fn at(&self, u: &Exact) -> (Exact, Exact) {
        let v = exact(1.0) - u;
        let weights = [&v * &v * &v, exact(3.0) * &v * &v * u, exact(3.0) * &v * u * u, u * u * u];
        let terms = self.b.iter().zip(&weights).map(|(b, weight)| b * weight);
        terms.fold((exact(0.0), exact(0.0)), |(value, size), term| (value + &term, size + term.abs()))
    }

    fn ratio(&self, u: &Exact) -> f64 {
        let (value, size) = self.at(u);
        if sign(&size) == 0 { 0.0 } else { float(&quotient(&value, &size)) }
    }

    /// By how much a value at u is off, in units of its terms.
    pub fn error(&self, u: f32, value: f32) -> f64 {
        let (exactly, size) = self.at(&exact(u));
        UNITS * float(&quotient(&(exact(value) - exactly).abs(), &size))
    }

    /// Judges the first roots, or all of them; each may have been moved by `rounding` units, relative.
    pub fn judge(&self, roots: &[f32], all: bool, rounding: f64) -> BernsteinVerdict {
        let one = exact(1.0);
        let around = |root: f32| {
            let u = exact(root);
            let by = &u * exact(rounding / UNITS);
            [&u - &by, u.clone(), (&u + &by).min(one.clone())]
        };
        // g over its terms is greatest where that of w has its turning points, but for terms of second order.
        let far = exact(2_f64.powi(400));
        let mut places = vec![exact(0.0), one.clone()];
        places.extend(self.over_ratio.turns(&exact(0.0), &far).iter().map(|w| quotient(w, &(&one + w))));
        let residual = roots.iter().map(|&root| {
            let [low, middle, high] = around(root);
            let within = places.iter().filter(|place| low <= **place && **place <= high);
            let ratios: Vec<f64> = within.chain([&low, &middle, &high]).map(|u| self.ratio(u)).collect();
            let is_crossed = ratios.iter().any(|r| *r >= 0.0) && ratios.iter().any(|r| *r <= 0.0);
            let least = ratios.iter().map(|r| r.abs()).fold(f64::INFINITY, f64::min);
            if is_crossed { 0.0 } else { least }
        });
        let residual = residual.fold(0.0, f64::max);

        let last = if all { None } else { roots.last().map(|&root| around(root)[0].clone()) };
        let skipped = [1, -1].map(|start| {
            let mut worst = 0_f64;
            for place in places.iter().filter(|place| last.as_ref().is_none_or(|last| *place < last)) {
                let is_at = |&&root: &&f32| {
                    let [low, _, high] = around(root);
                    low <= *place && *place <= high
                };
                if roots.iter().any(|root| is_at(&root)) {
                    continue;
                }
                let before = roots.iter().filter(|root| exact(**root) < *place).count();
                let wanted = if before % 2 == 0 { start } else { -start };
                let ratio = self.ratio(place);
                worst = worst.max(-ratio * f64::from(wanted));
            }
            worst
        });
        let skipped = skipped[0].min(skipped[1]);
        BernsteinVerdict { residual: UNITS * residual, skipped: UNITS * skipped }
    }
}
