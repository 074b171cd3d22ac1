//! All crossings of an interval as a list.

use crate::cubic::Cubic;
use crate::solve::Solver;
use crate::solve::isolate::{Crossings, first_critical};
use heapless::Vec;

/// How many roots a cubic has at most.
pub(super) const MOST: usize = 3;

/// Appends the roots of `g` in [lo, hi], times `unit`, until there are `most` of them. Returns the sign at
/// `hi`.
///
/// `sign` is that at `lo`, if it has been decided; if not, and the value there is zero, `lo` is a root, and
/// the search goes on with the sign at the end of the monotone piece that begins there.
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
