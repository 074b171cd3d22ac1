use super::piece::Piece;
use super::solver::Solver;
use crate::cubic::Cubic;
use crate::math::{Native, UNIT_ROUNDOFF};

/// The most steps of [`Newton`]. After 24 halvings the bracket is 2⁻²⁴ of the piece, and no step in it
/// longer. The other 40 are for the slowest steps of Newton's method, those towards a triple root, which
/// leave 2/3 of the distance: 40 of them leave 2⁻²³.
const NEWTON_LIMIT: u32 = 64;

/// Newton's method in a bracket, from the middle of the piece: a step that would leave the bracket goes to
/// the bracket's middle instead. It returns a u at which the value is at most one rounding, 2⁻²⁴ of the sum
/// of its terms' magnitudes, or from which the next step would be at most 2⁻²⁴ of the piece's length; after
/// [`NEWTON_LIMIT`] steps it returns the bracket's upper end.
///
/// This is the solver with the least code. It is used for rays that the fast path leaves undecided, which are
/// few, so its speed matters little.
pub(crate) struct Newton;

impl Solver for Newton {
    type Math = Native;

    #[inline(always)]
    fn root(g: &Cubic, piece: &Piece) -> f32 {
        let (mut lo, mut hi) = (piece.lo, piece.hi);
        let last = UNIT_ROUNDOFF * (hi - lo);
        let mut u = hi;
        for _ in 0..NEWTON_LIMIT {
            if !(lo < u && u < hi) {
                u = 0.5 * (lo + hi);
            }
            let value = g.at(u);
            if value > 0.0 {
                lo = u;
            } else {
                hi = u;
            }
            let step = value / g.slope(u);
            if value.abs() <= UNIT_ROUNDOFF * g.size(u) || step.abs() <= last {
                return u;
            }
            u -= step;
        }
        hi
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::Newton;
    use crate::cubic::Cubic;
    use crate::math::UNIT_ROUNDOFF;
    use crate::solve::isolate::Crossings;
    use crate::solve::{BACKWARD_ERROR, DefaultSolver};
    use rand::rngs::ChaCha8Rng;
    use rand::{RngExt, SeedableRng};

    /// Roots are found where the default solver finds any, and are as good as that promises, apart from what
    /// the last step leaves: well separated ones, and those of which two are nearly one.
    #[test]
    fn as_good_as_any() {
        let mut rng = ChaCha8Rng::seed_from_u64(1995);
        let (mut roots, mut worst) = (0, 0.0_f64);
        for _ in 0..200_000 {
            let mut c: [f32; 4] = core::array::from_fn(|_| rng.random_range(-1.0..1.0));
            if rng.random() {
                // (u − a)²·(b0 + b1·u), rounded.
                let [a, b0, b1, _] = c;
                c = [a * a * b0, a * (a * b1 - 2.0 * b0), b0 - 2.0 * a * b1, b1];
            }
            let (g, hi) = (Cubic::new(c), rng.random_range(-1.0..2.0));
            let is_positive = g.at(-1.0) > 0.0;
            let crossings = || Crossings::new(&g, -1.0, hi, is_positive);
            let root = crossings().next::<Newton>();
            assert_eq!(root.is_some(), crossings().next::<DefaultSolver>().is_some());
            let Some(u) = root else { continue };
            assert!((-1.0..=hi).contains(&u), "{u}");
            let [c0, c1, c2, c3] = c.map(f64::from);
            let u = f64::from(u);
            let value = ((c3 * u + c2) * u + c1) * u + c0;
            let size = c0.abs() + (c1 * u).abs() + (c2 * u * u).abs() + (c3 * u * u * u).abs();
            // What is left by the last step, of the whole interval at most.
            let slope = (3.0 * c3 * u + 2.0 * c2) * u + c1;
            let left = f64::from(UNIT_ROUNDOFF) * f64::from(hi + 1.0) * slope.abs();
            worst = worst.max((value.abs() - left) / size * 24_f64.exp2());
            roots += 1;
        }
        assert!(roots > 50_000, "{roots}");
        assert!(1.0 < worst && worst <= BACKWARD_ERROR.into(), "{worst} units");
    }
}
