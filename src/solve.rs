//! Where a cubic vanishes: root isolation, which rays use, and a library of solvers, which they do not.
//!
//! | files | what they hold | who uses them |
//! |---|---|---|
//! | `piece.rs`, `isolate.rs`, `newton.rs` | a bracket for one root; root isolation, piece by piece; Newton's method in a bracket, a private [`Solver`] | rays that the fast path leaves undecided, and `library/` |
//! | `library/` | [`Split`], [`Cardano`], [`refine`](fn@refine), the roots of any [`Cubic`](crate::Cubic) in any interval and of [`Bernstein`](crate::Bernstein) ordinates | you; no picture is made with them |
//!
//! Every root is found in two steps, and solvers differ in the second alone:
//!
//! 1. **Isolate.** The cubic is negated if it starts below zero, so that it starts above. Then it crosses
//!    zero before its minimum if it is zero or less there, and else before the interval's end if it is zero
//!    or less at the end: the signs at these two points decide. If it crosses, the result is a [`Piece`], a
//!    bracket in which it does so once, and the search for the next crossing begins where the piece ends; if
//!    not, the interval has no root. (`isolate.rs`.)
//! 2. **Solve.** A [`Solver`] computes the crossing in the piece.
//!
//! | solver | closed form | then | cost |
//! |---|---|---|---|
//! | [`Split`] | the parabola at the nearer critical point, corrected for the cubic term | one Newton step | a square root, four or five divisions, a short polynomial |
//! | [`Cardano`] | Cardano's formula, trigonometric or with a cube root | [`refine`](fn@refine) | an arc cosine and a cosine, or a cube root, and Newton's steps |
//!
//! A solver whose closed form is inaccurate, everywhere or in places, is brought to full accuracy by
//! [`refine`](fn@refine), in a bracket. [`Split`], which [`Cubic::first_root`](crate::Cubic::first_root) and
//! [`Cubic::roots`](crate::Cubic::roots) use, needs no bracket: its closed form is accurate everywhere, and
//! its cost differs little from one cubic to another.
//!
//! # Promise
//!
//! A root returned is a root of some cubic whose coefficients differ from the given ones by at most
//! [`BACKWARD_ERROR`] units of 2⁻²⁴ each, relative. Another cubic within that bound has no root before the
//! one returned, or no root at all where none is returned.
//!
//! A list of roots keeps five promises:
//!
//! - Each of its roots is a root of some cubic within the bound.
//! - Between two neighbours in the list some cubic within the bound has the sign that it should have there.
//! - Two equal roots in the list are a double root of some cubic within the bound.
//! - The list has no more roots than the degree. Every point is a root of the zero cubic, and the list holds
//!   the interval's first one alone.
//! - Some cubic within the bound has as many roots as the list, except where three roots are nearly one and
//!   the interval ends beside them.
//!
//! Rounding decides whether a double root is found as two roots or not at all.
//!
//! Leading coefficients may vanish, and neither the scale of the coefficients nor the length of the interval
//! matters (`library/rescale.rs`). Values below 2⁻¹⁰⁶ of the largest coefficient count as zero: cubics are
//! solved as they are if their largest coefficient is 2⁻²⁰ or more, and then 2⁻¹⁰⁶ of it is f32's smallest
//! normal number, 2⁻¹²⁶, or more. A cubic with a coefficient that is infinite or NaN has no roots.

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
