//! Pixels that see a flat part of the surface: a cap or a ring. Both lie on the plane of a knot, between the
//! squared radius that the profile has just below the plane and the one that it has just above. A ray that
//! passes the plane between the two crosses the surface there.
//!
//! If that is the plane of the end at which the ray comes to the solid, no part of the solid hides the flat
//! part: all of the solid lies beyond the plane. On any other plane it is seen if g keeps its sign on the way
//! there, which a probe certifies.

// One of the two is not used.
#[allow(dead_code)]
mod floats;
#[allow(dead_code)]
mod integers;

use super::sweep::{Span, Sweep};
use crate::arithmetic::{Length, Seen};
use crate::lathe::frame::KnotPlane;
use crate::math::minmax::{greater, lesser};

impl Sweep<'_> {
    /// The span of pixels, from the i-th on, that may see a cap or a ring: on the plane at which the i-th ray
    /// comes to the solid, or on the one that `root.plane` names. No part of the solid hides that from these
    /// pixels: each sees it if its ray [passes](Sweep::passes) through it, as the i-th does. The `flat` of
    /// the sweep is set to it. `None` if the i-th is not certain to see one; then `root.plane` names none.
    #[inline(always)]
    pub(super) fn flat_span(&mut self, i: u32) -> Option<Span> {
        let frame = self.bounds.lathe.frame;
        let (rises, _) = self.rises_until(i);
        let (first, end) = if rises { (0, &frame.base) } else { (frame.len, &frame.top) };
        if end.wall == end.beyond && self.root.plane > frame.len {
            return None;
        }
        self.flat_on_either(i, first, rises)
    }

    /// Does what [`Sweep::flat_span`] does: `first` is the number of the plane at which the i-th ray comes to
    /// the solid, `rises` whether it rises.
    #[inline(never)]
    fn flat_on_either(&mut self, i: u32, first: usize, rises: bool) -> Option<Span> {
        for number in [first, self.root.plane] {
            if number > self.bounds.lathe.frame.len {
                break;
            }
            let Some(KnotPlane { z, below, above }) = self.bounds.lathe.plane(number) else { break };
            let (inner, outer) = (lesser(below, above), greater(below, above));
            // A cap reaches to the axis: it has no inner rim, and no r² is negative.
            let inner = if inner > 0.0 { inner } else { -outer };
            let up = if rises { -1.0 } else { 1.0 };
            self.root.sign = if rises == (above > below) { 1.0 } else { -1.0 };
            self.flat = self.bounds.numbers.flat(&self.bounds, z, (inner, outer), up);
            if self.passes(i).is_none() {
                continue;
            }
            let mut to = self.direction.len;
            if number != first {
                let path = self.path(i);
                let interval = self.interval(&path);
                let until = self.bounds.numbers.plane(&path, z);
                let sign = self.root.sign;
                let before = self.below_zero(i, &path, sign, (interval.0, until), usize::MAX);
                let is_clear = sign > 0.0 || self.may_begin_inside(&path, interval);
                to = to.min(before.ok().filter(|_| is_clear).unwrap_or(i));
            }
            if to > i {
                return Some(Span::Flat { to });
            }
        }
        self.root.plane = usize::MAX;
        None
    }

    /// The s at which the i-th ray passes through the cap or the ring of the last [`Span::Flat`], clear of
    /// its rims and of the point where the rays begin by more than the tolerance. `None` if it does not, if
    /// it comes from the side that is not seen, or if its distance is not certain enough to be compared.
    ///
    /// An error of the height moves the point by 1/|dz| times as much: so the flatter the ray, the farther
    /// from a rim the point has to be. At |dz| = 1 its r² has to differ from the rim's by the tolerance.
    // Without a hint: in a build for size flash contains the function only once, and in a build for speed the
    // compiler inlines it.
    pub fn passes(&self, i: u32) -> Option<Length> {
        self.bounds.numbers.passes(self, &self.direction.numbers, &self.flat, i)
    }

    /// What a pixel sees of the cap or the ring of the last [`Span::Flat`].
    #[inline(always)]
    pub fn flat(&self) -> Seen {
        Seen::flat(self.flat.up)
    }
}
