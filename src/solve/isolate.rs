//! Root isolation: the search for a cubic's crossings, one monotone piece after the other.

use super::piece::{Fall, Piece, bend, critical_point};
use super::solver::Solver;
use crate::cubic::Cubic;
use crate::math::Math;
use crate::math::minmax::{greater, lesser};

/// The cubic, negated if it counts as negative at `lo`, and the first piece of [lo, hi] on which the cubic so
/// returned falls to zero. `None` if `g` does not change its sign up to `hi`.
///
/// `positive` is whether `g` counts as positive at `lo`, whatever rounding makes of the value there;
/// `ends_positive` is the same at `hi`, or `None` if the value at `hi` decides. A cubic that is positive at
/// `lo` can only reach zero by falling, up to its minimum if that comes after `lo`. So if the minimum is
/// between `lo` and `hi`, and the value there is zero or less, the piece ends at the minimum. In all other
/// cases the sign at `hi` decides whether the cubic reaches zero, and the piece ends at `hi`.
#[inline(always)]
fn first_piece<M: Math>(
    g: &Cubic,
    lo: f32,
    hi: f32,
    positive: bool,
    ends_positive: Option<bool>,
) -> Option<(Cubic, Piece)> {
    let g = if positive { *g } else { Cubic::new(g.c.map(|c| -c)) };
    let mut piece = Piece { lo, hi, fall: Fall::Straight, bend: 0.0, minimum: f32::INFINITY, depth: 0.0 };
    if let Some(bend) = bend::<M>(&g) {
        let minimum = critical_point(&g, bend, g.c[2] >= 0.0);
        let depth = -g.at(minimum);
        let sinks = lo < minimum && depth >= 0.0;
        piece = Piece { fall: Fall::FromMaximum, bend, minimum, depth, ..piece };
        if sinks {
            piece.fall = Fall::ToMinimum;
            if minimum < hi {
                piece.hi = minimum;
                return Some((g, piece));
            }
        }
    }
    let falls = ends_positive.map_or_else(|| g.at(hi) <= 0.0, |ends_positive| ends_positive != positive);
    falls.then_some((g, piece))
}

/// A search for where a cubic crosses zero in an interval, in ascending order, one crossing at a time.
///
/// The search takes one monotone piece after the other. The sign at the end of a piece is decided once, when
/// the piece is searched, and the next piece begins with that sign; no piece holds more than one crossing. So
/// whatever rounding does, no more than three crossings of a cubic are found, and no more than two of a
/// parabola.
pub(crate) struct Crossings<'a> {
    g: &'a Cubic,
    /// The interval that is left to be searched: `next` moves `lo`.
    lo: f32,
    hi: f32,
    /// Whether `g` counts as positive at `lo`, whatever rounding makes of the value there.
    positive: bool,
    /// The same at `hi`, or `None` if the value at `hi` decides.
    ends_positive: Option<bool>,
}

impl<'a> Crossings<'a> {
    /// The crossings in [lo, hi] of a cubic that counts as positive, or as negative, at `lo`.
    #[inline(always)]
    pub fn new(g: &'a Cubic, lo: f32, hi: f32, positive: bool) -> Self {
        Self { g, lo, hi, positive, ends_positive: None }
    }

    /// The same of a cubic whose sign at `hi` is known, too: the number of crossings is odd if the two signs
    /// differ, and even if not.
    #[inline(always)]
    pub fn between(g: &'a Cubic, [lo, hi]: [f32; 2], [positive, ends_positive]: [bool; 2]) -> Self {
        Self { g, lo, hi, positive, ends_positive: Some(ends_positive) }
    }

    /// The next point at which the cubic reaches zero or the other sign: the root that the solver S computes
    /// in the next piece, or the piece's nearer end if that root lies outside. The interval that is left then
    /// begins at the piece's end, with the other sign. `None` if there is no crossing up to `hi`; then the
    /// search is left as it is.
    #[inline(always)]
    pub fn next<S: Solver>(&mut self) -> Option<f32> {
        if !(self.lo < self.hi) {
            // The interval has no length. If its two ends have different signs, it is a crossing.
            let jumps = self.ends_positive == Some(!self.positive);
            self.positive ^= jumps;
            return jumps.then_some(self.hi);
        }
        let (g, piece) = first_piece::<S::Math>(self.g, self.lo, self.hi, self.positive, self.ends_positive)?;
        let root = S::root(&g, &piece);
        (self.lo, self.positive) = (piece.hi, !self.positive);
        // Not `clamp`, which panics if the ends are out of order, so that firmware would carry the message.
        Some(greater(piece.lo, lesser(piece.hi, root)))
    }

    /// Whether the cubic counts as positive at `lo`, where the interval that is left begins. Once `next` has
    /// returned `None`, the cubic has the same sign at `hi`.
    pub fn is_positive(&self) -> bool {
        self.positive
    }
}

/// The first critical point in (lo, hi), or `hi` if there is none.
pub(super) fn first_critical<M: Math>(g: &Cubic, lo: f32, hi: f32) -> f32 {
    let Some(bend) = bend::<M>(g) else { return hi };
    let points = [true, false].map(|near| critical_point(g, bend, near));
    points.into_iter().filter(|&u| lo < u).fold(hi, lesser)
}
