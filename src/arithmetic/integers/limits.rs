//! What is known of a row's rays, in integers.

use super::{Numbers, fixed, wide};
use crate::arithmetic::RowLimits;

/// The [`RowLimits`] of a row.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    /// How far along a ray a probe looks, and the s from which on it does: in units of 2^(d − w − 32).
    pub span: i32,
    pub start: i32,
    /// In units of 2^−w.
    pub low: i32,
    pub high: i32,
    /// In units of 2^−d.
    pub drift: i32,
    /// In units of 2^−p.
    pub slip: i32,
    pub tolerance: i32,
    pub knot_tolerance: i32,
    /// The slip and the tolerance as differences of r²: in units of 2^(−2·w).
    pub wide_slip: i64,
    pub wide_tolerance: i64,
}

impl Numbers {
    /// What is known of a row's rays, the numbers of 32 bits rounded to the nearest, those of 64 bits down.
    pub(super) fn limits(self, of: &RowLimits) -> Limits {
        let Self { d, p, w, .. } = self;
        Limits {
            span: fixed(of.span, w + 32 - d),
            start: fixed(of.start, w + 32 - d),
            low: fixed(of.low, w),
            high: fixed(of.high, w),
            drift: fixed(of.drift, d),
            slip: fixed(of.slip, p),
            tolerance: fixed(of.tolerance, p),
            knot_tolerance: fixed(of.knot_tolerance, p),
            wide_slip: wide(of.slip, 2 * w),
            wide_tolerance: wide(of.tolerance, 2 * w),
        }
    }
}
