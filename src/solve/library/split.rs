use super::inflection::{Guess, from_inflection, positive_root};
use crate::cubic::Cubic;
use crate::math::{Math, Native};
use crate::solve::{Fall, Piece, Solver};
use core::marker::PhantomData;

/// A parabola about the nearer critical point, corrected for the cubic term. The solver of
/// [`Cubic::first_root`] and [`Cubic::roots`]. A tag, of which no value exists.
///
/// At a distance d from the critical point that is nearer to the root, `|g| = height − bend·d² + c3·d³`,
/// where height is |g| at that point. Without the last term the root would be at `d = e = √(height/bend)`.
/// With it the root is at `d = e·Φ(b)`, where `b = c3·e/bend` and Φ is the solution of `Φ²·(1 − b·Φ) = 1`.
///
/// If the root lies towards the other critical point, b is from 0 to `√6/9`: at that value the root is the
/// point of inflection, and beyond it the other critical point would be the nearer. If it lies in the other
/// direction, b is negative without bound. Where b is below −3/4, or NaN, the cubic term dominates, and
/// Newton's method finds d. Where there is no critical point the root is computed from the point of
/// inflection. (`inflection.rs` has both.)
///
/// Φ is computed by a polynomial of five terms, within 2.7·10⁻³, and a Newton step on its equation, which
/// leaves 5.2·10⁻⁶. One Newton step on g removes that error, and the rounding of the critical point. The step
/// is divided by the slope `d·(2·bend − 3·c3·d)`, a product that does not cancel as d → 0. Since Newton's
/// method converges quadratically, an error of about 10⁻¹¹·d remains. There is no bracket, and for b of −3/4
/// or more no loop. In two places the step on g is another:
///
/// - Beside a critical point rounding decides the sign of g, and a Newton step may have any length. One
///   longer than d/2 is cut to d/2: `bend·d²` is then below the rounding of g, and every point within a few d
///   is an equally good root.
/// - Where the root is so near to zero that 10⁻¹¹·d is not small beside it, the Newton step on g starts from
///   `−c0/c1` instead, which is then within 2⁻⁹ of the root, relative.
///
/// Sound for every finite cubic; see the [module](crate::solve) for the bound.
///
/// ```
/// use embedded_lathe::{Cubic, math::Micromath, solve::Split};
///
/// let g = Cubic::new([-0.25, 0.0, 1.0, 0.0]); // u² − 1/4
/// let root = g.first_root_by::<Split<Micromath>>(0.0, 1.0).unwrap();
/// assert!((root - 0.5).abs() < 1e-7);
/// ```
#[derive(Debug)]
pub struct Split<M = Native>(PhantomData<M>);

impl<M: Math> Solver for Split<M> {
    type Math = M;

    #[inline(always)]
    fn root(g: &Cubic, piece: &Piece) -> f32 {
        newton(
            g,
            if piece.fall == Fall::Straight { from_inflection(*g) } else { from_turning::<M>(g, piece) },
        )
    }
}

/// The root, before the last Newton step, by its distance from the critical point that is nearer to it.
#[inline(always)]
fn from_turning<M: Math>(g: &Cubic, piece: &Piece) -> Guess {
    let [.., c2, c3] = g.c;
    let bend = piece.bend;
    let per_bend = 1.0 / bend;
    let ratio = c3 * per_bend;
    // Between its critical points the cubic falls if c3 > 0, and the minimum is nearer if b² ≤ 2/27. A
    // parabola with a minimum has no maximum: if it is said to fall from there, its end has another sign than
    // the rounded values, and the root is within rounding of the minimum.
    let to_minimum = if c3 > 0.0 {
        13.5 * (piece.depth.abs() * ratio) * ratio <= bend
    } else {
        piece.fall == Fall::ToMinimum || c3 == 0.0 && c2 > 0.0
    };
    let (from, height, way) = if to_minimum {
        (piece.minimum, piece.depth, -1.0)
    } else {
        let maximum = piece.maximum(g);
        (maximum, g.at(maximum), 1.0)
    };
    let e = M::sqrt(height.abs() * per_bend);
    let b = ratio * e;
    // True if b < −3/4, and if b is NaN, of either sign: 0·∞, where bend is so small that 1/bend is infinite,
    // is negative on x86 and positive on Arm. A b above √6/9 is due to rounding, and then every point of the
    // piece is a root within rounding.
    if b.abs().to_bits() > 0.75_f32.to_bits() {
        let (d, slope) = positive_root(height.abs(), [0.0, bend, -c3]);
        return Guess { from, d: way * d, slope: -slope };
    }
    let d = e * phi(b);
    Guess { from, d: way * d, slope: -d * (2.0 * bend - 3.0 * c3 * d) }
}

/// Φ(b) within 5.2·10⁻⁶, for b in [−3/4, √6/9]: a Newton step on `Φ²·(1 − b·Φ) − 1` from [`nearly_phi`].
fn phi(b: f32) -> f32 {
    let y = nearly_phi(b);
    let by = b * y;
    (1.0 + y * y * (1.0 - 2.0 * by)) / (y * (2.0 - 3.0 * by))
}

/// Φ(b) within 2.7·10⁻³, for b in [−3/4, √6/9]: the minimax polynomial of degree 4, by relative error.
/// `laboratory/tests/fits.rs` computes it by Remez's exchange, and asserts these coefficients.
#[inline(always)]
fn nearly_phi(b: f32) -> f32 {
    0.997_442_4 + b * (0.505_279_96 + b * (0.789_021_4 + b * (1.192_748_1 + b * 0.742_747_07)))
}

/// The root after the last step, a Newton step of at most |d|/2 from the guess, or from `−c0/c1` if the guess
/// [`is_lost`].
#[inline(always)]
fn newton(g: &Cubic, Guess { from, d, slope }: Guess) -> f32 {
    let [c0, c1, ..] = g.c;
    let (mut u, mut slope) = (from + d, slope);
    if is_lost(u, from) {
        u = -c0 / c1;
        slope = g.slope(u);
    }
    let step = g.at(u) / slope;
    let most = 0.5 * d.abs();
    // If the step is 0/0, points d/2 from u are roots, too: where the slope underflows, so does bend·d².
    u - if step.abs() <= most {
        step
    } else if step > 0.0 {
        most
    } else {
        -most
    }
}

/// Whether |u| is below about 2⁻⁹·|from|. The threshold is met within a factor of 2, since the difference of
/// two numbers' bits is about 2²³ times that of their logarithms to base 2.
#[inline(always)]
fn is_lost(u: f32, from: f32) -> bool {
    let [u, from] = [u, from].map(|x| (x.to_bits() & 0x7fff_ffff) as i32);
    from - u > 9 << 23
}

#[cfg(test)]
mod tests {
    use super::{Split, nearly_phi, phi};
    use crate::cubic::Cubic;
    use crate::math::{Libm, Micromath, Native};

    /// Where `y²·(1 − b·y) = 1`: Newton's method, from 1/2 up, where it is steeper than beyond.
    fn exactly(b: f64) -> f64 {
        let mut y = 1.0;
        for _ in 0..60 {
            y -= (y * y * (1.0 - b * y) - 1.0) / (y * (2.0 - 3.0 * b * y));
        }
        y
    }

    /// The bounds of the doc, each no more than a tenth slack, over [−3/4, √6/9].
    #[test]
    fn phi_is_as_good_as_its_doc_says() {
        let (mut before, mut after) = (0.0_f64, 0.0_f64);
        for i in 0..=100_000 {
            let b = (-0.75 + (0.75 + 6_f64.sqrt() / 9.0) * f64::from(i) / 1e5) as f32;
            let truth = exactly(b.into());
            let error = |y: f32| (f64::from(y) / truth - 1.0).abs();
            (before, after) = (before.max(error(nearly_phi(b))), after.max(error(phi(b))));
        }
        assert!(0.9 * 2.7e-3 < before && before <= 2.7e-3, "{before}");
        assert!(0.9 * 5.2e-6 < after && after <= 5.2e-6, "{after}");
    }

    /// A double root at 0, and a third beside it: bend is subnormal, so that 1/bend is infinite, and NaN when
    /// multiplied by the height, which is zero.
    #[test]
    fn a_subnormal_bend_gives_roots() {
        let g = Cubic::new([0.0, 0.0, -1e-39, 0.01]);
        let roots = g.roots_by::<Split<Native>>(-1.0, 1.0);
        // Up to the third root, at 10⁻³⁷, the cubic's values count as zero.
        assert!(roots[..2] == [0.0, 0.0] && 0.0 < roots[2] && roots[2] <= 1e-37, "{roots:?}");
        assert_eq!(g.roots_by::<Split<Libm>>(-1.0, 1.0), roots);
        assert_eq!(g.roots_by::<Split<Micromath>>(-1.0, 1.0), roots);
    }
}
