use super::{Solver, refine::refine};
use crate::cubic::Cubic;
use crate::math::Math;

/// A turning point of a cubic.
///
/// ```
/// use embedded_lathe::solve::Turning;
/// let nowhere = Turning { at: f32::INFINITY, height: f32::INFINITY };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Turning {
    /// Where, infinite if nowhere.
    pub at: f32,
    /// The magnitude of the cubic there, infinite if nowhere.
    pub height: f32,
}

/// The monotone piece of a cubic that holds its first crossing. The cubic falls from `lo`, where it is
/// positive, to `hi`, where it is negative.
///
/// ```
/// use embedded_lathe::{Cubic, math::Native, solve::{Piece, Solver}};
///
/// /// Bisection: a solver without an idea of its own.
/// struct Middle;
///
/// impl Solver for Middle {
///     type Math = Native;
///     fn seed(_: &Cubic, piece: &Piece) -> f32 {
///         0.5 * (piece.lo + piece.hi)
///     }
/// }
///
/// let root = Cubic::new([-0.1, 0.0, 0.0, 0.8]).first_root_by::<Middle>(0.0, 1.0);
/// assert!((root.unwrap() - 0.5).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Piece {
    /// Where the piece begins: at a maximum, or at the interval's end.
    pub lo: f32,
    /// Where it ends: at a minimum, or at the interval's end.
    pub hi: f32,
    /// The maximum that it falls from, which may lie before the interval.
    pub maximum: Turning,
    /// The minimum that it falls to, which may lie beyond the interval.
    pub minimum: Turning,
    /// Half the second derivative at the minimum, and its negative at the maximum: with d the distance from
    /// one of the two, `|g| = |height − bend·d² ± c3·d³|`. Zero if there is neither.
    pub bend: f32,
}

/// The cubic, turned round so that it starts positive, and the piece on which it first falls below zero, if
/// there is one in [lo, hi].
///
/// `positive` says how it starts, whatever rounding makes of its value there. From above zero it can come
/// below only by falling, and then the minimum, or the interval's end, is below: two signs tell.
///
/// The turning points are `(−c2 ± s)/(3·c3)`, `s = √(c2² − 3·c3·c1)`: each from that form of the quadratic
/// formula that adds two numbers of one sign, so that the one which stays finite as c3 → 0 is found without
/// dividing by it.
#[inline(always)]
pub(crate) fn first_piece<M: Math>(g: &Cubic, lo: f32, hi: f32, positive: bool) -> Option<(Cubic, Piece)> {
    let sign = if positive { 1.0 } else { -1.0 };
    let g = Cubic::new(g.c.map(|c| sign * c));
    let [_, c1, c2, c3] = g.c;
    let nowhere = |at| Turning { at, height: f32::INFINITY };
    let square = difference_of_products(c2, 3.0 * c1, c3);
    if !(square > 0.0) {
        let none =
            Piece { lo, hi, maximum: nowhere(f32::NEG_INFINITY), minimum: nowhere(f32::INFINITY), bend: 0.0 };
        return (g.at(hi) <= 0.0).then_some((g, none));
    }
    let bend = M::sqrt(square);
    let rising = c2 >= 0.0;
    let sum = if rising { c2 + bend } else { c2 - bend };
    let (near, far) = (-c1 / sum, -sum / (3.0 * c3));
    let (minimum, maximum) = if rising { (near, far) } else { (far, near) };

    let (mut end, mut value) = (minimum, g.at(minimum));
    let depth = -value;
    if !(lo < end && end < hi && value <= 0.0) {
        (end, value) = (hi, g.at(hi));
    }
    if !(value <= 0.0) {
        return None;
    }
    let start = if lo < maximum && maximum < end { maximum } else { lo };
    // A value that is not a number belongs to a point at infinity.
    let maximum = if maximum <= start && maximum > f32::NEG_INFINITY {
        Turning { at: maximum, height: g.at(maximum) }
    } else {
        nowhere(f32::NEG_INFINITY)
    };
    let minimum = if minimum >= end && minimum < f32::INFINITY {
        Turning { at: minimum, height: depth }
    } else {
        nowhere(f32::INFINITY)
    };
    Some((g, Piece { lo: start, hi: end, maximum, minimum, bend }))
}

/// The first point of [lo, hi] at which a cubic that starts positive (or not) has the other sign, or is zero.
#[inline(always)]
pub(crate) fn first_crossing<S: Solver>(g: &Cubic, lo: f32, hi: f32, positive: bool) -> Option<f32> {
    let (g, piece) = first_piece::<S::Math>(g, lo, hi, positive)?;
    Some(refine(&g, &piece, S::seed(&g, &piece)))
}

/// `a² − b·c` to within a few units of the result wherever it is not far below the rounding of the exact
/// products.
///
/// The plain difference, unless it cancels; then each product is taken exactly, as a sum of two numbers
/// (Dekker 1971).
#[inline(always)]
fn difference_of_products(a: f32, b: f32, c: f32) -> f32 {
    let (square, product) = (a * a, b * c);
    let plain = square - product;
    if plain.abs() > 0.25 * square { plain } else { exact_difference(a, b, c) }
}

#[cold]
#[inline(never)]
fn exact_difference(a: f32, b: f32, c: f32) -> f32 {
    let (square, product) = (a * a, b * c);
    (square - product) + (tail(a, a, square) - tail(b, c, product))
}

/// What rounding took from a·b: `a·b = product + tail`, exactly, if nothing under- or overflows.
fn tail(a: f32, b: f32, product: f32) -> f32 {
    let (a1, a0) = halves(a);
    let (b1, b0) = halves(b);
    ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0
}

/// A number as a sum of two of 12 bits each (Veltkamp 1968).
fn halves(a: f32) -> (f32, f32) {
    let shifted = 4097.0 * a;
    let high = shifted - (shifted - a);
    (high, a - high)
}
