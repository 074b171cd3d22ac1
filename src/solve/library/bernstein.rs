use super::collect::MOST_ROOTS;
use super::cubic::DefaultSolver;
use super::rescale::{TAME, rescaled};
use crate::bernstein::Bernstein;
use crate::cubic::Cubic;
use crate::math::minmax::greater;
use crate::solve::Solver;
use heapless::Vec;

impl Bernstein {
    /// By how much the ordinates of the cubic for which an answer is exact may differ from the given ones, in
    /// units of 2⁻²⁴, relative: [`BACKWARD_ERROR`](crate::solve::BACKWARD_ERROR), and one unit for the
    /// rounding of the products 3·b1 and 3·b2.
    pub const BACKWARD_ERROR: f32 = crate::solve::BACKWARD_ERROR + 1.0;

    /// By how much a root returned may be off by its own rounding, in units of 2⁻²⁴, relative: one unit for
    /// the sum and one for the quotient in `w/(1 + w)`.
    pub const ROUNDING: f32 = 2.0;

    /// The smallest root in [0, 1], by [`DefaultSolver`]. `None` if there is none, or if an ordinate is
    /// infinite or NaN. If all ordinates are zero, every point is a root, and the first is 0.
    ///
    /// Cost: 294 instructions on a Cortex-M4F, the mean of `cargo run --example bench` (`ordinates native`).
    #[must_use]
    pub fn first_root(&self) -> Option<f32> {
        self.first_root_by::<DefaultSolver>()
    }

    /// The roots in [0, 1] in ascending order, by [`DefaultSolver`]: at most three. Rounding decides whether
    /// a double root is found as two that are equal or close, as one at an end of the interval, or not at
    /// all. If all ordinates are zero, the list holds 0 alone.
    ///
    /// ```
    /// use embedded_lathe::Bernstein;
    ///
    /// // (4·u − 1)·(2·u − 1)·(4·u − 3)
    /// let roots = Bernstein::new([-3.0, 13.0 / 3.0, -13.0 / 3.0, 3.0]).roots();
    /// let are_near = roots.iter().zip([0.25, 0.5, 0.75]).all(|(u, root)| (u - root).abs() < 1e-6);
    /// assert!(are_near && roots.len() == 3);
    /// ```
    #[must_use]
    pub fn roots(&self) -> Vec<f32, 3> {
        self.roots_by::<DefaultSolver>()
    }

    /// [`Bernstein::first_root`] by the solver S.
    #[must_use]
    pub fn first_root_by<S: Solver>(&self) -> Option<f32> {
        if self.has_one_sign() {
            return None;
        }
        // Most roots have a w of 2³⁰ or less. `search` would find the same one, in the first of its parts.
        let first = self.over_ratio().first_root_by::<S>(0.0, TAME).map(from_ratio);
        first.or_else(|| self.search::<S>(1).first().copied())
    }

    /// [`Bernstein::roots`] by the solver S.
    #[must_use]
    pub fn roots_by<S: Solver>(&self) -> Vec<f32, 3> {
        self.search::<S>(MOST_ROOTS)
    }

    /// Whether all ordinates are positive, or all are negative. Then the cubic has no root in [0, 1].
    fn has_one_sign(&self) -> bool {
        self.b.iter().all(|b| *b > 0.0) || self.b.iter().all(|b| *b < 0.0)
    }

    /// The first roots in [0, 1], at most `most` of them, ascending: those of [`Bernstein::over_ratio`], and
    /// 1 if b3 is zero. 0 alone if all ordinates are zero. Empty if an ordinate is infinite or NaN.
    fn search<S: Solver>(&self, most: usize) -> Vec<f32, 3> {
        let [_, _, _, b3] = self.b;
        let mut roots = Vec::new();
        if self.has_one_sign() || !self.b.iter().all(|b| b.is_finite()) {
            return roots;
        }
        for w in rescaled::<S>(&self.over_ratio(), 0.0, f32::INFINITY, most) {
            let _ = roots.push(from_ratio(w));
        }
        // At u = 1, where w is infinite, the value is b3.
        if b3 == 0.0 && self.b != [0.0; 4] && roots.len() < most {
            let _ = roots.push(1.0);
        }
        roots
    }

    /// The cubic `b0 + 3·b1·w + 3·b2·w² + b3·w³`, or a quarter of it if an ordinate is so large that three
    /// times it might be infinite.
    fn over_ratio(&self) -> Cubic {
        const LARGE: f32 = 0.25 * f32::MAX;
        let largest = self.b.iter().fold(0.0, |largest, b| greater(largest, b.abs()));
        let [b0, b1, b2, b3] = if largest > LARGE { self.b.map(|b| 0.25 * b) } else { self.b };
        Cubic::new([b0, 3.0 * b1, 3.0 * b2, b3])
    }
}

/// `u = w/(1 + w)` within 2 units of 2⁻²⁴, relative, for w ≥ 0. For w > 1 it is computed as `1 − 1/(1 + w)`,
/// which is 1 for infinite w.
fn from_ratio(w: f32) -> f32 {
    if w <= 1.0 { w / (1.0 + w) } else { 1.0 - 1.0 / (1.0 + w) }
}
