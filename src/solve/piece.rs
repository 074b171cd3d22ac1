//! A bracket for one root, and the critical points of the cubic that bound it.

use crate::cubic::Cubic;
use crate::math::Math;
use crate::math::minmax::greater;

/// A bracket for one root: the cubic is positive from `lo` to the crossing, and negative or zero at `hi`.
/// Between them it crosses zero once.
///
/// ```
/// use embedded_lathe::{Cubic, math::Native, solve::{Piece, Solver, refine}};
///
/// /// A solver that leaves all to `refine`, from the middle of the piece.
/// struct Middle;
///
/// impl Solver for Middle {
///     type Math = Native;
///     fn root(g: &Cubic, piece: &Piece) -> f32 {
///         refine(g, piece, 0.5 * (piece.lo + piece.hi))
///     }
/// }
///
/// let root = Cubic::new([-0.1, 0.0, 0.0, 0.8]).first_root_by::<Middle>(0.0, 1.0);
/// assert!((root.unwrap() - 0.5).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Piece {
    /// Where the piece begins: at the start of what is left of the interval to be searched.
    pub lo: f32,
    /// Where the piece ends: at the interval's end, or at the cubic's minimum if that comes before.
    pub hi: f32,
    /// How the cubic falls to zero: by which of its critical points the fall is bounded.
    pub fall: Fall,
    /// `√(c2² − 3·c3·c1)`: half the second derivative at the minimum, and minus half of it at the maximum.
    /// Zero if the cubic has no critical points.
    pub bend: f32,
    /// Where the cubic has its minimum. Infinite or NaN if it has none.
    pub minimum: f32,
    /// Minus the cubic's value at the minimum. Zero if the cubic has no critical points.
    pub depth: f32,
}

/// How a cubic falls to zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Fall {
    /// The cubic has no critical points.
    Straight,
    /// The cubic falls to its minimum. That lies after the piece's start, perhaps beyond its end, and the
    /// value there is zero or less.
    ToMinimum,
    /// The cubic falls from its maximum: its minimum lies before the piece's start, or the value at the
    /// minimum is positive.
    FromMaximum,
}

impl Piece {
    /// Where `g`, the cubic that the solver was given with this piece, has its maximum. Infinite or NaN if it
    /// has none.
    #[inline(always)]
    #[must_use]
    pub fn maximum(&self, g: &Cubic) -> f32 {
        critical_point(g, self.bend, g.c[2] < 0.0)
    }
}

/// One of the two critical points, `(−c2 ± bend)/(3·c3)`: the one nearer to zero if `near`, and else the
/// other.
///
/// Each is computed by that form of the quadratic formula that adds two numbers of one sign. So the nearer
/// one, which stays finite as c3 → 0, takes no division by c3. If c2 ≥ 0, the nearer one is the minimum, and
/// else the maximum.
#[inline(always)]
pub(super) fn critical_point(g: &Cubic, bend: f32, near: bool) -> f32 {
    let [_, c1, c2, c3] = g.c;
    let sum = if c2 >= 0.0 { c2 + bend } else { c2 - bend };
    // The fraction is chosen before it is divided, so that there is one division.
    let (above, below) = if near { (-c1, sum) } else { (-sum, 3.0 * c3) };
    above / below
}

/// `√(c2² − 3·c3·c1)`, or `None` if the cubic has no critical points, that is, if the square is not positive,
/// or none that matter: see [`slight_bend`].
///
/// The computed square is, within two roundings, that of a cubic whose c1 differs by 3 roundings at most: one
/// for each of the three products. Where the difference cancels, the critical points are so close together
/// that g changes by far less than its rounding between them.
///
/// Above 10⁻²⁴ the difference is not affected by underflow: a product that underflows is off by less than
/// f32's smallest normal number, 1.2·10⁻³⁸, which is less than 2⁻²⁴·10⁻²⁴.
#[inline(always)]
pub(super) fn bend<M: Math>(g: &Cubic) -> Option<f32> {
    let [_, c1, c2, c3] = g.c;
    let square = c2 * c2 - 3.0 * c3 * c1;
    if square > 1.0e-24 { Some(M::sqrt(square)) } else { slight_bend::<M>(c1, c2, c3) }
}

/// [`bend`] where the computed square is 10⁻²⁴ or less, or NaN, so that products may have underflowed. `None`
/// if the square is not positive, or if |c1| is 2⁵⁰·bend or more: then the critical points do not matter. For
/// either |c2| is 2⁸·bend at most, and the nearer one, at the distance |c1|/(|c2| + bend) from zero, is
/// beyond 2⁴¹, where no interval reaches that is solved as it is. Or |c2| is larger, and between the critical
/// points g changes by 4/3·(bend/c2)³ of its quadratic term there, which is about 2⁻²⁴ or less: a rounding.
///
/// The coefficients are multiplied by LIFT = 2⁶⁰, and so the products by 2¹²⁰, which makes small ones normal
/// numbers. A product above 2⁸ overflows. Both do if c2² does, since c2² exceeds 3·c3·c1 by 10⁻²⁴ at most;
/// numbers above 2⁸ are multiples of 2⁻¹⁵, and so the square is zero or negative. The lifted difference is −∞
/// or NaN, `greater` makes zero of either, and the result is `None`.
#[cold]
#[inline(never)]
fn slight_bend<M: Math>(c1: f32, c2: f32, c3: f32) -> Option<f32> {
    const LIFT: f32 = (1_u64 << 60) as f32;
    const MOST_RATIO: f32 = (1_u64 << 50) as f32;
    let [c1, c2, c3] = [LIFT * c1, LIFT * c2, LIFT * c3];
    let bend = M::sqrt(greater(0.0, c2 * c2 - 3.0 * c3 * c1));
    (MOST_RATIO * bend > c1.abs()).then_some(bend / LIFT)
}
