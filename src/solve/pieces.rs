use super::{Solver, refine::refine};
use crate::cubic::Cubic;
use crate::math::Math;
use core::marker::PhantomData;

/// A point where the slope of a cubic vanishes: with d = u − at, `g = value + bend·d² + c3·d³`, exactly so.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Turning {
    /// Where: −∞ or +∞ if there is none on that side.
    pub at: f32,
    /// The cubic's value there, +∞ if nowhere.
    pub value: f32,
    /// Half the second derivative there: positive at a minimum, negative at a maximum.
    pub bend: f32,
}

impl Turning {
    /// None on the left.
    pub const BEFORE: Self = Self { at: f32::NEG_INFINITY, value: f32::INFINITY, bend: 0.0 };
    /// None on the right.
    pub const BEYOND: Self = Self { at: f32::INFINITY, value: f32::INFINITY, bend: 0.0 };

    fn new(g: &Cubic, at: f32, bend: f32) -> Self {
        let value = g.at(at);
        // A vanishing leading coefficient sends one of the two points to infinity.
        if value.is_finite() { Self { at, value, bend } } else { Self::BEYOND }
    }

    /// The turning points of `g` in ascending order, absent ones last. None or one of a quadratic, none or
    /// two of a cubic.
    ///
    /// `u = (−c2 ± s)/(3·c3)`, `s = √(c2² − 3·c3·c1)`: each point from that form of the quadratic formula
    /// that adds two numbers of one sign, so that the point which stays finite as c3 → 0 is found without
    /// dividing by it.
    pub fn of<M: Math>(g: &Cubic) -> [Self; 2] {
        let [_, c1, c2, c3] = g.c;
        let s = M::sqrt(difference_of_products(c2, 3.0 * c1, c3));
        if !(s > 0.0) {
            return [Self::BEYOND; 2];
        }
        let s = if c2 >= 0.0 { s } else { -s };
        let sum = c2 + s;
        let (near, far) = (Self::new(g, -c1 / sum, s), Self::new(g, -sum / (3.0 * c3), -s));
        if far.at < near.at { [far, near] } else { [near, far] }
    }
}

/// One monotone part of a cubic: between two neighbouring turning points, or beyond the outermost.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Piece {
    /// Where the piece begins: the turning point on its left, or the interval's end.
    pub lo: f32,
    /// Where it ends: the turning point on its right, or the interval's end.
    pub hi: f32,
    /// The nearest turning point to the left, which may lie outside the interval.
    pub left: Turning,
    /// The nearest turning point to the right, likewise.
    pub right: Turning,
    /// Whether the cubic falls from lo to hi.
    pub falling: bool,
}

/// The points of an interval at which a cubic changes sign, in ascending order: at most three, one a monotone
/// piece.
pub(crate) struct Crossings<S> {
    g: Cubic,
    lo: f32,
    hi: f32,
    /// The turning points at the next piece's ends, and the one after.
    left: Turning,
    right: Turning,
    after: Turning,
    /// The sign that the cubic is known to have now.
    positive: bool,
    solver: PhantomData<S>,
}

impl<S: Solver> Crossings<S> {
    /// `g` is positive (or negative) as the interval begins, whatever rounding makes of its value there.
    #[inline(always)]
    pub fn new(g: Cubic, lo: f32, hi: f32, positive: bool) -> Self {
        let [right, after] = Turning::of::<S::Math>(&g);
        Self { g, lo, hi, left: Turning::BEFORE, right, after, positive, solver: PhantomData }
    }

    /// The interval begins at a root: the sign is that at the end of the first piece, which has no other
    /// root.
    pub fn leave_root(&mut self) {
        if let Some((_, value)) = self.piece() {
            self.positive = value > 0.0;
        }
    }

    /// The next piece of which any lies in the interval, and the cubic's value at its end.
    #[inline(always)]
    fn piece(&mut self) -> Option<(Piece, f32)> {
        loop {
            let (left, right) = (self.left, self.right);
            // Or there is no point on the left, and so no piece.
            if !(left.at < self.hi) {
                return None;
            }
            (self.left, self.right, self.after) = (right, self.after, Turning::BEYOND);
            let lo = if left.at > self.lo { left.at } else { self.lo };
            let (hi, value) =
                if right.at < self.hi { (right.at, right.value) } else { (self.hi, self.g.at(self.hi)) };
            if lo < hi {
                return Some((Piece { lo, hi, left, right, falling: self.positive }, value));
            }
        }
    }

    /// The next piece that holds a crossing, and the cubic's value at its end.
    #[inline(always)]
    fn crossing(&mut self) -> Option<(Piece, f32)> {
        loop {
            let (piece, value) = self.piece()?;
            let crosses = if self.positive { value <= 0.0 } else { value >= 0.0 };
            if crosses {
                self.positive = !self.positive;
                return Some((piece, value));
            }
        }
    }

    /// Whether there is another crossing.
    #[inline(always)]
    pub fn any_left(&mut self) -> bool {
        self.crossing().is_some()
    }
}

impl<S: Solver> Iterator for Crossings<S> {
    type Item = f32;

    #[inline(always)]
    fn next(&mut self) -> Option<f32> {
        let (piece, value) = self.crossing()?;
        Some(if value == 0.0 { piece.hi } else { refine(&self.g, &piece, S::seed(&self.g, &piece)) })
    }
}

/// `a² − b·c` to within a few units of the result wherever it is not far below the rounding of the exact
/// products.
///
/// The plain difference, unless it cancels; then each product is taken exactly, as a sum of two numbers
/// (Dekker 1971).
fn difference_of_products(a: f32, b: f32, c: f32) -> f32 {
    let (square, product) = (a * a, b * c);
    let plain = square - product;
    if plain.abs() > 0.25 * square {
        return plain;
    }
    plain + (tail(a, a, square) - tail(b, c, product))
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
