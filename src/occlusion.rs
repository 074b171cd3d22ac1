//! In what order solids are painted, and which may hide which: far ones are painted before near ones.
//!
//! Where a plane separates two solids, with the eye on the near one's side, no ray meets the far one first.
//! Only where no such plane is found must pixels ask which of the two is nearer. Any order gives the same
//! picture; a good one is cheap.

use crate::camera::{Camera, Projection};
use crate::math::{UNIT_ROUNDOFF, const_fn};
use crate::solid::Solid;
use crate::vector::{F32x3, difference, dot, scale};
use core::slice;

/// The factor by which rounding is taken into account where distances are compared. With it a plane may
/// separate two solids of which one stands on the other; but a plane is not taken if the eye lies in it, as
/// it may in that of a cap. A dot product of three terms is off by three units of roundoff, the support
/// function by four.
const MARGIN: f32 = 1.0 + 8.0 * UNIT_ROUNDOFF;

/// By how much `between·n`, the distance between two solids' centers along n times n's length, must exceed
/// what both extend along n: this times the square of the sum of both radii. If n is shorter than 10⁻¹⁹, its
/// square underflows, and with it the support functions; but then `between·n` is at most 10⁻¹⁹ times the
/// distance between the centers, so that such an n is never taken for a separating one.
const LEAST: f32 = 1e-12;

/// The distance at which the eye is taken to be if the rays are parallel, in units of the sum of both radii.
/// From there the direction to any point of the two solids differs from that of the rays by 2⁻²⁰ at most.
const FAR: f32 = 1_048_576.0;

/// How many solids a [`PaintOrder`] keeps: as many as a `u32` has groups of four bits. More are ordered anew
/// in every row.
const KEPT: usize = 8;

/// The order in which solids are painted, and which of them must be compared with the others pixel by pixel:
/// computed once for a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct PaintOrder {
    /// The indices of the farthest solids, 0 to 7 in four bits each, that of the farthest in the lowest. Of
    /// more than [`KEPT`] solids none is kept.
    indices: u32,
    /// Bit n is set if the n-th of them may be hidden by one that is painted before it.
    compared: u8,
}

/// A solid in its turn.
pub(crate) struct Painted<'a> {
    pub solid: &'a Solid<'a>,
    /// The solids of which the nearest is seen where this one may be: it alone, or, if one painted before it
    /// may yet hide it, all of them.
    pub candidates: &'a [Solid<'a>],
}

impl PaintOrder {
    /// The order of solids that a camera sees: the farthest first, and of two at the same distance the first
    /// in the slice.
    #[inline(never)]
    pub const fn of(solids: &[Solid], camera: &Camera) -> Self {
        let mut order = Self { indices: 0, compared: 0 };
        let (mut rank, mut last) = (0, FIRST);
        while rank < solids.len() && solids.len() <= KEPT {
            last = camera.painted_after(solids, last);
            order.indices |= (index_of(last) as u32) << (4 * rank);
            order.compared |= (camera.may_be_hidden(solids, last) as u8) << rank;
            rank += 1;
        }
        order
    }

    /// The solid that is painted as number `rank`, from 0 on; `None` if there are no more. `last` is the
    /// place of the solid before it, at first [`FIRST`], and becomes this one's; only where no order is kept
    /// it is used.
    #[inline]
    pub fn painted<'a>(
        &self,
        solids: &'a [Solid<'a>],
        camera: &Camera,
        rank: usize,
        last: &mut Place,
    ) -> Option<Painted<'a>> {
        let (index, is_compared) = match solids.len() {
            len if rank >= len => return None,
            0..=KEPT => ((self.indices >> (4 * rank)) as usize & 7, self.compared >> rank & 1 == 1),
            _ => camera.painted_next(solids, last),
        };
        let solid = solids.get(index)?;
        Some(Painted { solid, candidates: if is_compared { solids } else { slice::from_ref(solid) } })
    }
}

/// A solid's place in the order: its distance's bits over the complement of its index, so that of two numbers
/// the larger is painted first.
pub(crate) type Place = u64;

/// Before all others.
pub(crate) const FIRST: Place = u64::MAX;

/// The index of the solid at a place.
const fn index_of(place: Place) -> usize {
    !(place as u32) as usize
}

impl Camera {
    /// The place of the solid at an index; 0, the last, if there is none.
    const fn place(&self, solids: &[Solid], index: usize) -> Place {
        if index >= solids.len() {
            return 0;
        }
        (self.distance(&solids[index]) as u64) << 32 | !(index as u32) as u64
    }

    /// The place after another: of those that are painted later the first, 0 if there is none.
    #[inline(never)]
    const fn painted_after(&self, solids: &[Solid], last: Place) -> Place {
        let (mut next, mut index) = (0, 0);
        while index < solids.len() {
            let place = self.place(solids, index);
            if place < last && place > next {
                next = place;
            }
            index += 1;
        }
        next
    }

    /// The index of the solid that is painted after the one at place `last`, which becomes its place, and
    /// whether it must be compared.
    #[cold]
    fn painted_next(&self, solids: &[Solid], last: &mut Place) -> (usize, bool) {
        *last = self.painted_after(solids, *last);
        (index_of(*last), self.may_be_hidden(solids, *last))
    }

    /// Whether the solid at a place may be hidden by one at no smaller distance: whether one of those is not
    /// separated from it.
    #[inline(never)]
    const fn may_be_hidden(&self, solids: &[Solid], place: Place) -> bool {
        let near = index_of(place);
        let mut index = 0;
        while index < solids.len() && near < solids.len() {
            if index != near
                && self.distance(&solids[index]) >= (place >> 32) as u32
                && !self.sees_behind(&solids[index], &solids[near])
            {
                return true;
            }
            index += 1;
        }
        false
    }
}

impl Solid<'_> {
    /// The support function of the cylinder around the solid: how far the cylinder extends from its center in
    /// direction n, times the length of n. Infinite or NaN if the square of n overflows.
    #[inline(never)]
    const fn support(&self, n: F32x3) -> f32 {
        let along = dot(n, self.axis());
        let across = difference(n, scale(self.axis(), along));
        self.half_height() * along.abs() + self.radius() * length(across)
    }
}

impl Camera {
    /// The distance of a solid's center from the eye, plus the solid's radius, as bits, which grow as the
    /// number does. The radius is added so that of two solids in one place the smaller one tends to be
    /// painted last.
    #[inline(never)]
    const fn distance(&self, solid: &Solid) -> u32 {
        (length(solid.center_from(self.eye)) + solid.radius()).to_bits()
    }

    /// Whether a plane is found that separates two solids, with the eye on the side of `near`: then every ray
    /// that meets both meets `near` first.
    #[inline(never)]
    const fn sees_behind(&self, far: &Solid, near: &Solid) -> bool {
        let origin = near.position();
        let between = difference(far.center_from(origin), near.center_from(origin));
        let (radius, away) = (far.radius(), far.center_from(self.eye));
        let radii = radius + near.radius();
        let least = LEAST * radii * radii;
        let away = match self.projection {
            Projection::Perspective => away,
            Projection::Orthographic => scale(self.forward, FAR * radii),
        };
        // Three normals are tried: one perpendicular to the far solid's axis, one along that axis, and one
        // perpendicular to the line from the eye to a point between the two solids.
        let axial = scale(far.axis(), dot(between, far.axis()));
        let flat = difference(between, axial);
        let view = difference(away, scale(between, radius / radii));
        let beside = difference(flat, scale(view, dot(flat, view) / dot(view, view)));
        let normals = [flat, axial, beside];
        let mut i = 0;
        while i < normals.len() {
            let n = normals[i];
            let extent = far.support(n);
            if MARGIN * dot(between, n) > extent + near.support(n) + least && dot(away, n) > MARGIN * extent {
                return true;
            }
            i += 1;
        }
        false
    }
}

/// The length of a vector. It is infinite or NaN if the square is, and zero if the square underflows.
#[inline(never)]
const fn length(v: F32x3) -> f32 {
    let square = dot(v, v);
    if square < f32::INFINITY { const_fn::sqrt(square) } else { square }
}
