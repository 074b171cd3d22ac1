//! How wrong an answer is.
//!
//! The backward error of "the first root in [lo, hi] is u" is the smallest relative change of the coefficients that makes it true, here in units of
//! 2⁻²⁴. Changing every coefficient by δ relative changes g(v) by at most `δ·size(v)`, `size(v) = Σ |cⱼ·vʲ|`. So to make u a root
//! takes `|g(u)|/size(u)`, and to unmake a stretch of the wrong sign before u takes the largest `|g(v)|/size(v)` on it; that lies at a turning
//! point of g, or at lo, to a relative error of the order of δ itself. For "there is none", the stretch ends at hi.
//! What is computed is therefore a lower bound: an answer that it calls wrong is wrong.
//!
//! [`Truth::promised`] forgives in addition what the crate's promise leaves out: a value, not a term of it,
//! below 2⁻¹⁰⁶ of the largest coefficient.

use super::exact::{Exact, Polynomial, exact, float, quotient, sign};
use crate::UNITS;
use embedded_lathe::solve::BACKWARD_ERROR;

/// Everything the judge needs to know of a polynomial on an interval.
pub struct Truth {
    g: Polynomial,
    /// Added to every size.
    floor: f64,
    lo: f64,
    hi: f64,
    /// lo, the turning points, and hi: where, and `g/size` there.
    extremes: Vec<(f64, f64)>,
    /// Certified, ascending.
    pub roots: Vec<f64>,
}

/// What the judge says of an answer.
#[derive(Clone, Copy, Debug)]
pub struct Verdict {
    /// Backward error, in units of 2⁻²⁴.
    pub units: f64,
    /// From the certified first root, in units of 2⁻²⁴ of the interval; none if either of the two says that
    /// there is no root.
    pub distance: Option<f64>,
}

impl Truth {
    pub fn new(c: &[f32], lo: f32, hi: f32) -> Self {
        Self::above(0.0, c, lo, hi)
    }

    /// Where a value of 2⁻¹⁰⁶ of the largest coefficient is `BACKWARD_ERROR` units.
    pub fn promised(c: &[f32], lo: f32, hi: f32) -> Self {
        let largest = c.iter().fold(0f32, |largest, c| largest.max(c.abs()));
        let floor = (-106f64).exp2() * f64::from(largest) * UNITS / f64::from(BACKWARD_ERROR);
        Self::above(floor, c, lo, hi)
    }

    fn above(floor: f64, c: &[f32], lo: f32, hi: f32) -> Self {
        let g = Polynomial::new(c);
        let cuts = g.cuts(&exact(lo), &exact(hi));
        let extremes = cuts.iter().map(|u| (float(u), ratio(&g, floor, u))).collect();
        let roots = g.roots_between(&cuts).iter().map(float).collect();
        Self { g, floor, lo: lo.into(), hi: hi.into(), extremes, roots }
    }

    pub fn judge(&self, answer: Option<f64>) -> Verdict {
        let units = UNITS * self.backward_error(answer);
        let interval = self.hi - self.lo;
        let distance = answer.zip(self.roots.first()).map(|(u, root)| UNITS * (u - root).abs() / interval);
        Verdict { units, distance }
    }

    /// What it takes to make u a root, in units.
    pub fn residual(&self, u: f64) -> f64 {
        UNITS * ratio(&self.g, self.floor, &exact(u)).abs()
    }

    /// What it takes to change the number of roots, in units: the least value at a turning point, an end, or the point of inflection, where
    /// two turning points may be born.
    pub fn clearance(&self) -> f64 {
        let flat = match self.g.0.as_slice() {
            [_, _, c2, c3] if sign(c3) != 0 => {
                let u = -quotient(c2, &(exact(3.0) * c3));
                ratio(&self.g, self.floor, &u).abs()
            }
            _ => f64::INFINITY,
        };
        UNITS * self.extremes.iter().map(|(_, ratio)| ratio.abs()).fold(flat, f64::min)
    }

    fn backward_error(&self, answer: Option<f64>) -> f64 {
        let (residual, end) = match answer {
            Some(u) if self.lo <= u && u <= self.hi => (ratio(&self.g, self.floor, &exact(u)).abs(), u),
            Some(_) => return f64::INFINITY,
            None => (0.0, f64::INFINITY),
        };
        let before = self.extremes.iter().filter(|(at, _)| *at < end);
        let (above, below) =
            before.fold((0f64, 0f64), |(above, below), &(_, ratio)| (above.max(ratio), below.max(-ratio)));
        residual.max(above.min(below))
    }
}

fn ratio(g: &Polynomial, floor: f64, u: &Exact) -> f64 {
    let (value, size) = (float(&g.at(u)), float(&g.size(u)) + floor);
    if size > 0.0 { value / size } else { 0.0 }
}
