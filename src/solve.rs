//! Where a cubic vanishes: the first root in an interval, or all of them.
//!
//! Every method here answers in the same two steps, and only the second differs:
//!
//! 1. **Split.** The cubic is turned round to start positive. From there it can only fall below zero, towards its
//!    minimum or the interval's end, and two signs say whether it does: the [`Piece`]. (`pieces.rs`.)
//! 2. **Solve.** A closed form says where: that is the [`Solver`].
//!
//! | solver | closed form | then | cost |
//! |---|---|---|---|
//! | [`Split`] | the parabola at the nearer turning point, bent by the cubic term | one Newton step | one root, four divisions or five, a short polynomial |
//! | [`Cardano`] | Cardano's formula, trigonometric or with a cube root | [`refine`](fn@refine) | an arc cosine and a cosine, or a cube root, and Newton's steps |
//!
//! A closed form that is poor, or poor at times, is brought to full accuracy by [`refine`](fn@refine), in a bracket. The
//! default needs none: it is good everywhere, and its cost differs little from one cubic to another.
//!
//! Rays that a glance does not tell are walked along with the smallest of all, Newton's method in a bracket and nothing
//! else. (`bracketed.rs`.)
//!
//! # Promise
//!
//! The root returned is exact for a cubic whose coefficients differ from the given ones by at most
//! [`BACKWARD_ERROR`] units of 2⁻²⁴ each, relative, and so is the claim that there is none before it. Two
//! roots closer than that can tell apart may be reported or missed together. Leading coefficients may vanish,
//! and neither the scale of the coefficients nor the length of the interval matters (`wide.rs`); what does not
//! count is a value below 2⁻¹⁰⁶ of the largest coefficient, f32's smallest over the least that is not scaled
//! first. Coefficients that are not finite have no roots.

mod bracketed;
mod cardano;
mod inflection;
mod pieces;
mod refine;
mod split;
mod wide;

pub use cardano::Cardano;
pub use pieces::{Fall, Piece};
pub use refine::refine;
pub use split::Split;

pub(crate) use bracketed::Bracketed;
pub(crate) use pieces::first_crossing;

use crate::cubic::Cubic;
use crate::math::minmax::greater;
use crate::math::{Math, Native};
use heapless::Vec;
use pieces::crossing;
use wide::{is_tame, local, wide};

/// The relative change of each coefficient, in units of 2⁻²⁴, within which every answer is exact.
pub const BACKWARD_ERROR: f32 = 4.0;

/// A method: where a cubic known to cross zero once in a piece does so.
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

    /// The crossing of `g` in `piece`. What lies outside the piece is replaced by its nearer end, NaN by hi.
    fn root(g: &Cubic, piece: &Piece) -> f32;
}

/// What [`Cubic::first_root`] and [`Cubic::roots`] use.
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
        if !is_tame(self, lo, hi) {
            return wide::<S>(self, lo, hi, None);
        }
        let start = self.at(lo);
        if start == 0.0 { Some(lo) } else { crossing::<S>(self, lo, hi, start > 0.0) }
    }

    /// [`Cubic::roots`] by the method S.
    pub fn roots_by<S: Solver>(&self, lo: f32, hi: f32) -> Vec<f32, 3> {
        let mut roots = Vec::new();
        if !(lo <= hi) {
            return roots;
        }
        let tame = is_tame(self, lo, hi);
        let mut from = greater(f32::MIN, lo);
        let (scaled, at) = if tame { (*self, from) } else { local(self, from) };
        let start = scaled.at(at);
        let mut positive = start > 0.0;
        if start == 0.0 {
            let _ = roots.push(from);
            // The sign beyond is that of the first derivative that has one.
            let [_, _, c2, c3] = scaled.c;
            let signs = [scaled.slope(at), c2 + 3.0 * c3 * at, c3];
            positive = signs.iter().find(|&&sign| sign != 0.0).is_some_and(|&sign| sign > 0.0);
        }
        while !roots.is_full() && (roots.is_empty() || from < hi) {
            let next = if tame {
                crossing::<S>(self, from, hi, positive)
            } else {
                wide::<S>(self, from, hi, Some(positive))
            };
            let Some(root) = next else { break };
            let _ = roots.push(root);
            (from, positive) = (root, !positive);
        }
        roots
    }
}
