//! A cubic polynomial in Bernstein form.

/// A cubic by its Bernstein ordinates over [0, 1], as a Bézier curve has it:
/// `b0·(1 − u)³ + 3·b1·(1 − u)²·u + 3·b2·(1 − u)·u² + b3·u³`.
///
/// Its roots are found from the ordinates, not from the coefficients of powers of u that
/// [`Cubic::from_bernstein`](crate::Cubic::from_bernstein) makes of them. Those are sums of ordinates, and
/// small values near u = 1 are lost in them:
///
/// ```
/// use embedded_lathe::{Bernstein, Cubic};
///
/// let b = [117.11707, 39.039914, -2.3525217e-6, -2.3526636e-6];
/// assert_eq!(Bernstein::new(b).first_root(), Some(0.999_858_26)); // truly 0.999858269
/// assert!(Cubic::from_bernstein(b).first_root(0.0, 1.0).unwrap() > 0.9999);
/// ```
///
/// With `w = u/(1 − u)`, which goes from 0 to infinity, the cubic is
/// `(1 − u)³·(b0 + 3·b1·w + 3·b2·w² + b3·w³)`. So its roots are those of a cubic in w whose coefficients are
/// the ordinates, two of them times 3: no sum is formed before that cubic is solved.
///
/// # Promise
///
/// A root returned is within [`Bernstein::ROUNDING`] units of 2⁻²⁴, relative, of a root of some cubic whose
/// ordinates differ from the given ones by at most [`Bernstein::BACKWARD_ERROR`] units of 2⁻²⁴ each,
/// relative. Another cubic within that bound has no root before the one returned, or no root at all where
/// none is returned. Values of the cubic below 2⁻¹⁰⁶ of the largest ordinate count as zero. If an ordinate is
/// infinite or NaN, no root is returned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bernstein {
    /// `[b0, b1, b2, b3]`.
    pub b: [f32; 4],
}

impl Bernstein {
    /// From `[b0, b1, b2, b3]`: b0 is the value at u = 0, and b3 that at u = 1.
    #[must_use]
    pub const fn new(b: [f32; 4]) -> Self {
        Self { b }
    }

    /// The value at u, by de Casteljau's interpolations. For 0 ≤ u ≤ 1 it is off by at most 10 units of 2⁻²⁴
    /// of `Σ |bⱼ|·Bⱼ(u)`, the sum of the terms' magnitudes.
    ///
    /// The rounding of 1 − u, of which a term has three factors at most, contributes up to 3 units; the three
    /// interpolations, each a product and a sum, contribute 6; one is left for terms of second order.
    #[must_use]
    pub const fn at(&self, u: f32) -> f32 {
        let [b0, b1, b2, b3] = self.b;
        let v = 1.0 - u;
        let (c0, c1, c2) = (b0 * v + b1 * u, b1 * v + b2 * u, b2 * v + b3 * u);
        let (d0, d1) = (c0 * v + c1 * u, c1 * v + c2 * u);
        d0 * v + d1 * u
    }
}
