//! What a solver is, and how exact its roots are.

use super::piece::Piece;
use crate::cubic::Cubic;
use crate::math::Math;

/// By how much the coefficients of the cubic for which an answer is exact may differ from the given ones, in
/// units of 2⁻²⁴, relative. The bound is measured, not proved: the largest change seen is 2.4 units among the
/// cubics of `docs/ACCURACY.md`, and 3.2 units among sixty million over a hundred binary orders (`cargo test
/// --release --lib sixty_million -- --ignored`). The laboratory's tests assert the bound in exact arithmetic.
pub const BACKWARD_ERROR: f32 = 4.0;

/// A method that computes where a cubic crosses zero in a [`Piece`], in which there is one crossing.
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
    /// The library from which the solver takes its square root, and what else it needs.
    type Math: Math;

    /// Returns the root of `g` in `piece`, where `g` is positive before the root. The caller replaces a
    /// result outside the piece by the nearer end, and NaN by `hi`.
    fn root(g: &Cubic, piece: &Piece) -> f32;
}
