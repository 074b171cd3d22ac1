//! All crossings of an interval as a list.

use crate::cubic::Cubic;
use crate::solve::Solver;
use crate::solve::isolate::{Crossings, first_critical};
use heapless::Vec;

/// The largest number of roots that a cubic may have.
pub(super) const MOST_ROOTS: usize = 3;

/// Appends to `roots` the roots of `g` in [lo, hi], each multiplied by `unit`, until the list has `most`.
/// Returns whether `g` is positive at `hi`, or, if the list is full before, after its last root.
///
/// `sign` is whether `g` is positive at `lo`, if that has been decided. If it is `None`, the value at `lo`
/// decides; if that is zero, `lo` is a root, and the search goes on from the first critical point after it,
/// or from `hi` if there is none, with the sign there.
pub(super) fn collect<S: Solver>(
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
