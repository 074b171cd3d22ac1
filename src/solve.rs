//! Where a cubic vanishes: the first root in an interval, or all of them.
//!
//! Every method here answers in the same three steps, and only the second differs:
//!
//! 1. **Split.** The cubic is turned round to start positive. Its turning points cut the interval into monotone
//!    pieces, and two signs say which [`Piece`] holds the first root: exactly one. (`pieces.rs`.)
//! 2. **Seed.** A closed form says about where: that is the [`Solver`].
//! 3. **Refine.** Two Newton steps bring the seed to the accuracy of the coefficients, or, where they cannot be
//!    certified, as many as it takes between the ends of the piece. A poor seed costs time, never the answer.
//!    (`refine.rs`.)
//!
//! | solver | seed | cost |
//! |---|---|---|
//! | [`Split`] | the parabola at the nearer turning point, bent by the cubic term | one root, two divisions, a short polynomial |
//! | [`Cardano`] | Cardano's formula, trigonometric or with a cube root | an arc cosine and a cosine, or a cube root |
//!
//! # Promise
//!
//! The root returned is exact for a cubic whose coefficients differ from the given ones by at most
//! [`BACKWARD_ERROR`] units of 2⁻²⁴ each, relative, and so is the claim that there is none before it. Two
//! roots closer than that can tell apart may be reported or missed together. Leading coefficients may vanish,
//! and the scale of the coefficients does not matter; what does not count is a coefficient below 2⁻¹²⁶ of the
//! largest, or a term `cⱼ·uʲ` below that: on intervals like ±10³⁰ either may be what decides. Coefficients
//! that are not finite have no roots.

mod cardano;
mod pieces;
mod refine;
mod split;

pub use cardano::Cardano;
pub use pieces::{Piece, Turning};
pub use split::Split;

pub(crate) use pieces::{first_crossing, first_piece};

use crate::cubic::Cubic;
use crate::math::order::{greater, lesser};
use crate::math::{Math, Native};
use heapless::Vec;

/// The relative change of each coefficient, in units of 2⁻²⁴, within which every answer is exact.
pub const BACKWARD_ERROR: f32 = 4.0;

/// A closed form for about where the root of a monotone piece lies.
///
/// ```
/// use embedded_lathe::{Cubic, math::Libm, solve::{Cardano, Solver, Split}};
///
/// fn middle_root<S: Solver>() -> f32 {
///     Cubic::new([-6.0, 11.0, -6.0, 1.0]).first_root_by::<S>(1.5, 10.0).unwrap()
/// }
///
/// // Its terms add up to 60: the last bits of the root are those of the coefficients.
/// assert!((middle_root::<Split>() - 2.0).abs() < 1e-5);
/// assert!((middle_root::<Cardano<Libm>>() - 2.0).abs() < 1e-5);
/// ```
pub trait Solver {
    /// The mathematics that the solver's functions come from.
    type Math: Math;

    /// About where the root of `g` in `piece` lies. Anything is allowed, NaN too: what lies outside the piece
    /// is replaced by its middle.
    fn seed(g: &Cubic, piece: &Piece) -> f32;
}

/// What the renderer uses, and [`Cubic::first_root`] and [`Cubic::roots`].
pub type DefaultSolver = Split<Native>;

impl Cubic {
    /// The smallest root in [lo, hi], by the crate's default method.
    ///
    /// `None` where there is none, where a coefficient is not finite, and where not lo ≤ hi. Infinite ends
    /// stand for the largest numbers. The zero polynomial vanishes first at lo.
    pub fn first_root(&self, lo: f32, hi: f32) -> Option<f32> {
        self.first_root_by::<DefaultSolver>(lo, hi)
    }

    /// The roots in [lo, hi] in ascending order, by the crate's default method: at most three, a double root
    /// as two that are equal or not at all, as rounding decides.
    ///
    /// ```
    /// use embedded_lathe::Cubic;
    ///
    /// let everywhere = Cubic::new([0.0, -1.0, 0.0, 1.0]).roots(f32::NEG_INFINITY, f32::INFINITY);
    /// assert_eq!(everywhere, [-1.0, 0.0, 1.0]);
    /// ```
    pub fn roots(&self, lo: f32, hi: f32) -> Vec<f32, 3> {
        self.roots_by::<DefaultSolver>(lo, hi)
    }

    /// [`Cubic::first_root`] by the method S.
    pub fn first_root_by<S: Solver>(&self, lo: f32, hi: f32) -> Option<f32> {
        let (g, lo, hi) = self.within(lo, hi)?;
        let start = g.at(lo);
        if start == 0.0 {
            return Some(lo);
        }
        first_crossing::<S>(&g, lo, hi, start > 0.0)
    }

    /// [`Cubic::roots`] by the method S.
    pub fn roots_by<S: Solver>(&self, lo: f32, hi: f32) -> Vec<f32, 3> {
        let mut roots = Vec::new();
        let Some((g, mut lo, hi)) = self.within(lo, hi) else {
            return roots;
        };
        let mut positive = g.at(lo) > 0.0;
        if g.at(lo) == 0.0 {
            let _ = roots.push(lo);
            // The sign beyond is that of the first derivative that has one.
            let [_, _, c2, c3] = g.c;
            let signs = [g.slope(lo), c2 + 3.0 * c3 * lo, c3];
            positive = signs.iter().find(|&&sign| sign != 0.0).is_some_and(|&sign| sign > 0.0);
        }
        while !roots.is_full() && lo < hi {
            let Some(root) = first_crossing::<S>(&g, lo, hi, positive) else {
                break;
            };
            let _ = roots.push(root);
            (lo, positive) = (root, !positive);
        }
        roots
    }

    /// The cubic scaled by a power of two, so that its largest coefficient lies in [1, 4), and the interval
    /// made finite.
    fn within(&self, lo: f32, hi: f32) -> Option<(Self, f32, f32)> {
        // Magnitudes are ordered as their bits are, NaN above all.
        let [b0, b1, b2, b3] = self.c.map(|c| c.abs().to_bits());
        let largest = f32::from_bits(b0.max(b1).max(b2.max(b3)));
        if !(lo <= hi && largest < f32::INFINITY) {
            return None;
        }
        let [up, again] = to_one(largest);
        let c = self.c.map(|c| c * up * again);
        let bound = f32::MAX;
        Some((Self { c }, greater(-bound, lo), lesser(bound, hi)))
    }
}

/// Two powers of two whose product brings `largest` into [1, 4): one to lift subnormal numbers, one to do the
/// rest.
fn to_one(largest: f32) -> [f32; 2] {
    let lift = if largest < f32::MIN_POSITIVE { 16_777_216.0 } else { 1.0 };
    let exponent = (largest * lift).to_bits() >> 23;
    // 2^(127 − e) has the biased exponent 254 − e, which must stay above 0.
    let down = if exponent < 254 { 254 - exponent } else { 1 };
    [lift, f32::from_bits(down << 23)]
}
