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

mod isolate;
mod library;
mod newton;

pub use isolate::{Fall, Piece};
pub use library::{Cardano, DefaultSolver, Split, refine};

pub(crate) use isolate::Crossings;
pub(crate) use newton::Newton;

use crate::cubic::Cubic;
use crate::math::Math;

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
