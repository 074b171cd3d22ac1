//! Root isolation: from monotone piece to monotone piece.

use super::piece::{Fall, Piece, bend, critical_point};
use super::solver::Solver;
use crate::cubic::Cubic;
use crate::math::Math;
use crate::math::minmax::{greater, lesser};

/// The cubic, negated if it starts below zero, and the piece of [lo, hi] on which it first falls to zero.
/// `None` if it stays above zero up to `hi`.
///
/// `positive` is the sign at `lo`, whatever rounding makes of the value there. From above zero a cubic can
/// only reach zero by falling, and then its value at the minimum, or at the interval's end, is zero or less:
/// two signs decide. The sign at `hi` is taken from the value there, unless `ends_positive` gives it.
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

/// Where a cubic crosses zero in an interval, from its lower end on, one crossing at a time.
///
/// The search goes from monotone piece to monotone piece. The sign at the end of a piece is decided once,
/// when the piece is searched, and carried to the next one; each piece holds one crossing at most. So however
/// the roots are rounded, a cubic has no more than three, and a parabola no more than two.
pub(crate) struct Crossings<'a> {
    g: &'a Cubic,
    /// What is left to be searched.
    lo: f32,
    hi: f32,
    /// The sign of `g` at `lo`, whatever rounding makes of the value there.
    positive: bool,
    /// That at `hi`, if it is known better than from the value there.
    ends_positive: Option<bool>,
}

impl<'a> Crossings<'a> {
    /// The crossings in [lo, hi] of a cubic that is positive at `lo`, or negative.
    #[inline(always)]
    pub fn new(g: &'a Cubic, lo: f32, hi: f32, positive: bool) -> Self {
        Self { g, lo, hi, positive, ends_positive: None }
    }

    /// The same of a cubic whose sign at `hi` is known, too: the crossings are an odd number if the two
    /// differ.
    #[inline(always)]
    pub fn between(g: &'a Cubic, [lo, hi]: [f32; 2], [positive, ends_positive]: [bool; 2]) -> Self {
        Self { g, lo, hi, positive, ends_positive: Some(ends_positive) }
    }

    /// The next point at which the cubic reaches the other sign, or zero, by the solver S. `None` if there is
    /// no other up to `hi`.
    #[inline(always)]
    pub fn next<S: Solver>(&mut self) -> Option<f32> {
        if !(self.lo < self.hi) {
            // An interval of no length, with another sign at its end.
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

    /// The sign of the cubic at `hi`, once `next` has returned `None`.
    pub fn is_positive(&self) -> bool {
        self.positive
    }
}

/// The first critical point after `lo`, or `hi` if there is none before that.
pub(super) fn first_critical<M: Math>(g: &Cubic, lo: f32, hi: f32) -> f32 {
    let Some(bend) = bend::<M>(g) else { return hi };
    let points = [true, false].map(|near| critical_point(g, bend, near));
    points.into_iter().filter(|&u| lo < u).fold(hi, lesser)
}
