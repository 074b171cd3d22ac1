//! A cubic polynomial in power form.

use crate::math::minmax::greater;
use crate::math::{Math, Native};

/// `c0 + c1·u + c2·u² + c3·u³`, constant term first.
///
/// Any coefficient may be zero, the leading ones too: the degree is three at most.
///
/// ```
/// use embedded_lathe::Cubic;
///
/// let g = Cubic::new([-6.0, 11.0, -6.0, 1.0]); // (u − 1)(u − 2)(u − 3)
/// assert_eq!(g.at(0.0), -6.0);
/// let first = g.first_root(0.0, 10.0).unwrap();
/// assert!((first - 1.0).abs() < 1e-6);
/// assert_eq!(g.roots(1.5, 10.0).len(), 2);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cubic {
    /// `[c0, c1, c2, c3]`.
    pub c: [f32; 4],
}

impl Cubic {
    /// From `[c0, c1, c2, c3]`, constant term first.
    #[must_use]
    pub const fn new(c: [f32; 4]) -> Self {
        Self { c }
    }

    /// From Bernstein ordinates over [0, 1]: `Σ bⱼ·(3 over j)·(1 − u)³⁻ʲ·uʲ`.
    ///
    /// Each coefficient is off by at most 36 units of 2⁻²⁴ of the largest ordinate. The worst is c2, three
    /// times the difference of two differences: it is at most 12 times that ordinate, and has three
    /// roundings. Where no ordinate is negative c2 is at most 6 times the largest, and the bound is 18 units.
    /// A cubic whose values near u = 1 are small loses them in such sums: [`Bernstein`](crate::Bernstein)
    /// finds roots without them.
    #[must_use]
    pub const fn from_bernstein(b: [f32; 4]) -> Self {
        let [b0, b1, b2, b3] = b;
        let d1 = b1 - b0;
        let d2 = b2 - b1;
        Self { c: [b0, 3.0 * d1, 3.0 * (d2 - d1), (b3 - b0) - 3.0 * d2] }
    }

    /// Returns the value at u, by Horner's rule: 3 multiplications and 3 additions, off by at most 6 units of
    /// 2⁻²⁴ of [`Cubic::size`], one for each of them.
    #[inline]
    #[must_use]
    pub const fn at(&self, u: f32) -> f32 {
        let [c0, c1, c2, c3] = self.c;
        ((c3 * u + c2) * u + c1) * u + c0
    }

    /// Returns the derivative at u, `c1 + 2·c2·u + 3·c3·u²`.
    #[inline(always)]
    #[must_use]
    pub const fn slope(&self, u: f32) -> f32 {
        let [_, c1, c2, c3] = self.c;
        (3.0 * c3 * u + (c2 + c2)) * u + c1
    }

    /// Returns the value and the derivative at u, which share intermediate results: Horner's rule twice.
    #[inline(always)]
    pub(crate) const fn with_slope(&self, u: f32) -> (f32, f32) {
        let [c0, c1, c2, c3] = self.c;
        let leading = c3 * u;
        let twice = leading + c2;
        let once = twice * u + c1;
        let slope = (leading + twice) * u + once;
        (once * u + c0, slope)
    }

    /// Returns `Σ |cⱼ·uʲ|`, the sum of the terms' magnitudes: rounding in [`Cubic::at`] is proportional to
    /// it.
    #[must_use]
    pub const fn size(&self, u: f32) -> f32 {
        let [c0, c1, c2, c3] = self.c;
        let u = u.abs();
        ((c3.abs() * u + c2.abs()) * u + c1.abs()) * u + c0.abs()
    }

    /// The greatest value on the interval from `before` before zero to `beyond` beyond it, [−before, beyond].
    /// The cubic has it at one of the interval's ends, or at its maximum if that lies inside.
    pub(crate) fn max_on(&self, before: f32, beyond: f32) -> f32 {
        let [_, c1, c2, c3] = self.c;
        let ends = greater(self.at(-before), self.at(beyond));
        // The maximum is where the derivative is zero: of the two forms of that root, the one that does not
        // cancel. It is NaN if the cubic has no maximum, and then the comparisons below are false.
        let root = Native::sqrt(c2 * c2 - 3.0 * c3 * c1);
        let top = if c2 > 0.0 { -(c2 + root) / (3.0 * c3) } else { c1 / (root - c2) };
        if -before < top && top < beyond { greater(ends, self.at(top)) } else { ends }
    }
}

/// The greatest value of `c0 + c1·x + c2·x²` for x in [−half, half], half ≥ 0.
pub(crate) fn quadratic_max_on(c0: f32, c1: f32, c2: f32, half: f32) -> f32 {
    // True if the vertex lies inside and the parabola opens downwards.
    if c1.abs() + 2.0 * c2 * half < 0.0 {
        c0 - 0.25 * c1 * c1 / c2
    } else {
        c0 + (c1.abs() + c2 * half) * half
    }
}
