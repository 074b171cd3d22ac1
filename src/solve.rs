//! Where a cubic vanishes: root isolation, which rays use, and a library of solvers, which they do not.
//!
//! | files | what they hold | who uses them |
//! |---|---|---|
//! | `piece.rs`, `isolate.rs`, `newton.rs` | a bracket for one root; root isolation, piece by piece; Newton's method in a bracket, a private [`Solver`] | rays that the fast path leaves undecided, and `library/` |
//! | `library/` | [`Split`], [`Cardano`], [`refine`](fn@refine), the roots of any [`Cubic`] in any interval and of [`Bernstein`](crate::Bernstein) ordinates | you; no picture is made with them |
//!
//! Every root is found in two steps, and solvers differ in the second alone:
//!
//! 1. **Isolate.** The cubic is negated if it starts below zero. From above zero it can only fall below,
//!    towards its minimum or the interval's end, and the two signs there decide whether it does. The result
//!    is a [`Piece`], a bracket in which the cubic crosses zero once. After a crossing the search goes on
//!    where the piece ends. (`isolate.rs`.)
//! 2. **Solve.** A [`Solver`] computes the crossing in the piece.
//!
//! | solver | closed form | then | cost |
//! |---|---|---|---|
//! | [`Split`] | the parabola at the nearer critical point, corrected for the cubic term | one Newton step | one root, four or five divisions, a short polynomial |
//! | [`Cardano`] | Cardano's formula, trigonometric or with a cube root | [`refine`](fn@refine) | an arc cosine and a cosine, or a cube root, and Newton's steps |
//!
//! A solver whose closed form is inaccurate, everywhere or in places, is brought to full accuracy by
//! [`refine`](fn@refine), in a bracket. [`Split`], which [`Cubic::first_root`] and [`Cubic::roots`] use,
//! needs no bracket: its closed form is accurate everywhere, and its cost differs little from one cubic to
//! another.
//!
//! # Promise
//!
//! A root returned is exact for a cubic whose coefficients differ from the given ones by at most
//! [`BACKWARD_ERROR`] units of 2⁻²⁴ each, relative; and so is the claim that there is none before it, or none
//! at all. Of a list of roots this holds for each root, and for the sign of each stretch between two; two
//! equal roots are a double root; there are no more roots than the degree; and one cubic within the same
//! bound has as many, except where three roots are nearly one and the interval ends beside them. A double
//! root may be found as two roots, or not at all, as rounding decides.
//!
//! Leading coefficients may vanish, and neither the scale of the coefficients nor the length of the interval
//! matters (`library/rescale.rs`). Values below 2⁻¹⁰⁶ of the largest coefficient count as zero: cubics whose
//! largest coefficient is 2⁻²⁰ or more are solved as they are, and f32's smallest normal number is 2⁻¹²⁶. A
//! cubic with a coefficient that is infinite or NaN has no roots.

mod isolate;
mod library;
mod newton;
mod piece;
mod solver;

pub use library::{Cardano, DefaultSolver, Split, refine};
pub use piece::{Fall, Piece};
pub use solver::{BACKWARD_ERROR, Solver};

pub(crate) use isolate::Crossings;
pub(crate) use newton::Newton;
