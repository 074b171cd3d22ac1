//! The public solver library: the roots of a cubic in an interval, by solvers over mathematics libraries.
//! Rays and pictures use nothing of it.

mod bernstein;
mod cardano;
mod inflection;
mod refine;
mod rescale;
mod split;

pub use cardano::Cardano;
pub use refine::refine;
pub use split::Split;

use super::Solver;
use super::isolate::{Crossings, first_critical};
use crate::cubic::Cubic;
use crate::math::Native;
use heapless::Vec;
use rescale::{is_tame, rescaled};

/// How many roots a cubic has at most.
const MOST: usize = 3;

/// The solver of [`Cubic::first_root`], [`Cubic::roots`] and the like, which name none. No picture is made
/// with it.
pub type DefaultSolver = Split<Native>;

impl Cubic {
    /// The smallest root in [lo, hi], by [`DefaultSolver`].
    ///
    /// `None` if there is no root, if a coefficient is infinite or NaN, and unless lo ≤ hi. An infinite end
    /// stands for the largest finite number. Of the zero polynomial the first root is lo.
    #[must_use]
    pub fn first_root(&self, lo: f32, hi: f32) -> Option<f32> {
        self.first_root_by::<DefaultSolver>(lo, hi)
    }

    /// The roots in [lo, hi] in ascending order, by [`DefaultSolver`]: no more than the degree. A double root
    /// is found as two that are equal or close, as one at an end of the interval, or not at all, as rounding
    /// decides.
    ///
    /// Empty where [`Cubic::first_root`] is `None`, and otherwise with that for its first.
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
            return rescaled::<S>(self, lo, hi, MOST);
        }
        let mut roots = Vec::new();
        collect::<S>(self, [lo, hi], None, 1.0, MOST, &mut roots);
        roots
    }
}

/// Appends the roots of `g` in [lo, hi], times `unit`, until there are `most` of them. Returns the sign at
/// `hi`.
///
/// `sign` is that at `lo`, if it has been decided; if not, and the value there is zero, `lo` is a root, and
/// the search goes on with the sign at the end of the monotone piece that begins there.
fn collect<S: Solver>(
    g: &Cubic,
    [lo, hi]: [f32; 2],
    sign: Option<bool>,
    unit: f32,
    most: usize,
    roots: &mut Vec<f32, 3>,
) -> bool {
    let start = g.at(lo);
    let (from, positive) = match sign {
        Some(positive) => (lo, positive),
        None if start == 0.0 => {
            let _ = roots.push(lo * unit);
            let end = first_critical::<S::Math>(g, lo, hi);
            (end, g.at(end) > 0.0)
        }
        None => (lo, start > 0.0),
    };
    let mut crossings = Crossings::new(g, from, hi, positive);
    while roots.len() < most
        && let Some(root) = crossings.next::<S>()
    {
        let _ = roots.push(root * unit);
    }
    crossings.is_positive()
}

/// The first of the [`Crossings`]. Not inline: there is one copy for all callers.
#[inline(never)]
fn first_crossing<S: Solver>(g: &Cubic, lo: f32, hi: f32, positive: bool) -> Option<f32> {
    Crossings::new(g, lo, hi, positive).next::<S>()
}
