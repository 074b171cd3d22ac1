//! The roots of a cubic in power form.

use super::collect::{MOST_ROOTS, collect};
use super::rescale::{is_tame, rescaled};
use super::split::Split;
use crate::cubic::Cubic;
use crate::math::Native;
use crate::solve::Solver;
use crate::solve::isolate::Crossings;
use heapless::Vec;

/// The solver of [`Cubic::first_root`], [`Cubic::roots`] and their like for
/// [`Bernstein`](crate::Bernstein). No picture is made with it.
pub type DefaultSolver = Split<Native>;

impl Cubic {
    /// The smallest root in [lo, hi], by [`DefaultSolver`].
    ///
    /// `None` if there is no root, if a coefficient is infinite or NaN, or if lo ≤ hi does not hold (as with
    /// NaN). An infinite interval is searched up to the largest finite numbers. If all coefficients are zero,
    /// every point is a root, and the first is lo, or `f32::MIN` if lo is −∞.
    #[must_use]
    pub fn first_root(&self, lo: f32, hi: f32) -> Option<f32> {
        self.first_root_by::<DefaultSolver>(lo, hi)
    }

    /// The roots in [lo, hi] in ascending order, by [`DefaultSolver`]: no more than the degree. Rounding
    /// decides whether a double root is found as two that are equal or close, as one at an end of the
    /// interval, or not at all.
    ///
    /// The list is empty where [`Cubic::first_root`] is `None`; otherwise its first entry is that root. If
    /// all coefficients are zero, that is its only entry.
    ///
    /// ```
    /// use embedded_lathe::Cubic;
    ///
    /// let everywhere = Cubic::new([0.0, -1.0, 0.0, 1.0]).roots(f32::NEG_INFINITY, f32::INFINITY);
    /// assert_eq!(everywhere, [-1.0, 0.0, 1.0]);
    /// ```
    #[must_use]
    pub fn roots(&self, lo: f32, hi: f32) -> Vec<f32, 3> {
        self.roots_by::<DefaultSolver>(lo, hi)
    }

    /// [`Cubic::first_root`] by the solver S.
    #[must_use]
    pub fn first_root_by<S: Solver>(&self, lo: f32, hi: f32) -> Option<f32> {
        if !is_tame(self, lo, hi) {
            return rescaled::<S>(self, lo, hi, 1).first().copied();
        }
        let start = self.at(lo);
        if start == 0.0 { Some(lo) } else { first_crossing::<S>(self, lo, hi, start > 0.0) }
    }

    /// [`Cubic::roots`] by the solver S.
    #[must_use]
    pub fn roots_by<S: Solver>(&self, lo: f32, hi: f32) -> Vec<f32, 3> {
        if !is_tame(self, lo, hi) {
            return rescaled::<S>(self, lo, hi, MOST_ROOTS);
        }
        let mut roots = Vec::new();
        collect::<S>(self, [lo, hi], None, 1.0, MOST_ROOTS, &mut roots);
        roots
    }
}

/// The first of the [`Crossings`]. Not inline, so that all callers share one copy.
#[inline(never)]
fn first_crossing<S: Solver>(g: &Cubic, lo: f32, hi: f32, positive: bool) -> Option<f32> {
    Crossings::new(g, lo, hi, positive).next::<S>()
}
