//! In what order solids are painted, and which may hide which: far ones are painted before near ones.
//!
//! Where a plane separates two solids, with the eye on the near one's side, no ray meets the far one first.
//! Only where no such plane is found must the distances of the two be compared, pixel by pixel.

use crate::camera::{Camera, Projection};
use crate::math::{UNIT_ROUNDOFF, const_fn};
use crate::solid::Solid;
use crate::vector::{F32x3, difference, dot, scale};

/// A factor that takes rounding into account in the two comparisons which decide whether a plane separates
/// two solids. The first, between the solids, it makes more lenient: the plane between a solid and another
/// that stands on it is taken. The second, between the far solid and the eye, it makes stricter: a plane in
/// which the eye lies, for example a cap's, is not taken. A dot product of three terms is off by three units
/// of roundoff, the support function by four.
const MARGIN: f32 = 1.0 + 8.0 * UNIT_ROUNDOFF;

/// Keeps normals that are nearly zero from being taken. In the first comparison, this times the square of the
/// sum of both radii is added to the support functions that `between·n` must exceed, where `between` is the
/// vector between the solids' centers and n the plane's normal.
///
/// If n is shorter than 10⁻¹⁹, its square underflows, and with it the support functions. Then `between·n` is
/// at most 10⁻¹⁹ times the distance between the centers, too little to exceed this.
const LEAST: f32 = 1e-12;

/// The distance at which the eye is taken to be if the rays are parallel, in units of the sum of both radii.
/// From there the direction to any point of the two solids differs from that of the rays by 2⁻²⁰ at most.
const FAR: f32 = 1_048_576.0;

/// How many solids a [`PaintOrder`] sorts: as many as a `u32` has groups of four bits.
const SORTED: usize = 8;

/// The order in which solids are painted, and which of them are compared by their distances, pixel by pixel:
/// computed once for a picture.
///
/// The farthest solids come first, and each is painted over those before it. Where no plane is found between
/// two solids, they and those ranked between them belong to the block, and so does every body whose sheets
/// may hide one another. There is one block at most. It is painted with a distance for each pixel, in the order
/// of the slice, so that of two solids at the same distance the first is seen. If there are more than
/// [`SORTED`] solids, all are in the block.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct PaintOrder {
    /// The indices of the first [`SORTED`] solids, 0 to 7 in four bits each, that of the first in the lowest.
    indices: u32,
    /// The ranks of the block are those from `block` to before `beyond`; none if there is no block.
    pub block: usize,
    pub beyond: usize,
}

impl PaintOrder {
    /// The order for the solids of a slice and a camera: the farthest first, and of two at the same distance
    /// the first in the slice. Within the block it is the order of the slice.
    #[inline(never)]
    pub const fn of(solids: &[Solid], camera: &Camera) -> Self {
        let mut order = Self { indices: 0x7654_3210, block: 0, beyond: solids.len() };
        if solids.len() > SORTED {
            return order;
        }
        let (mut keys, mut index) = ([0; SORTED], 0);
        while index < solids.len() {
            keys[index] = camera.distance(&solids[index]);
            index += 1;
        }
        order.sort(&keys, 0, solids.len());
        (order.block, order.beyond) = (solids.len(), 0);
        let mut near = 0;
        while near < solids.len() {
            let mut far = 0;
            while far <= near && !(order.block <= far && near < order.beyond) {
                if !order.is_parted(solids, camera, far, near) {
                    order.block = if far < order.block { far } else { order.block };
                    order.beyond = near + 1;
                }
                far += 1;
            }
            near += 1;
        }
        order.sort(&[0; SORTED], order.block, order.beyond);
        order
    }

    /// The index, in the slice, of the solid with a rank: 0 is painted first. If the slice has no solid of
    /// that rank, the index is not in the slice either.
    #[inline]
    pub const fn index(&self, rank: usize) -> usize {
        if rank < SORTED { (self.indices >> (4 * rank)) as usize & 7 } else { rank }
    }

    /// Whether the solid ranked `far` is certain to hide no part of the one ranked `near`: whether a plane is
    /// found between the two, with the eye on the side of the latter. A solid and itself need no plane,
    /// unless it is a body, whose sheets may hide one another: then true only if it is a *shell* seen from
    /// outside. True if the slice has no such solid.
    #[inline(never)]
    const fn is_parted(&self, solids: &[Solid], camera: &Camera, far: usize, near: usize) -> bool {
        let (far, near) = (self.index(far), self.index(near));
        if far >= solids.len() || near >= solids.len() {
            return true;
        }
        let (far_solid, near_solid) = (&solids[far], &solids[near]);
        if far == near {
            !near_solid.is_body() || camera.sees_shell(near_solid)
        } else {
            camera.sees_behind(far_solid, near_solid)
        }
    }

    /// Sorts the ranks from `from` to before `to`, by insertion: the solid whose index has the largest key
    /// first, and of two with equal keys the one with the lower index.
    #[inline(never)]
    const fn sort(&mut self, keys: &[u32; SORTED], from: usize, to: usize) {
        let mut next = from + 1;
        while next < to {
            let mut low = 4 * next;
            while low > 4 * from {
                low -= 4;
                let pair = self.indices >> low;
                let (before, after) = ((pair & 7) as usize, (pair >> 4 & 7) as usize);
                if keys[before] > keys[after] || keys[before] == keys[after] && before < after {
                    break;
                }
                // Swaps the four bits with the next four.
                let both = (pair ^ pair >> 4) & 15;
                self.indices ^= both << low | both << (low + 4);
            }
            next += 1;
        }
    }
}

impl Solid<'_> {
    /// The support function of the cylinder around the solid: how far the cylinder extends from its center in
    /// direction n, times the length of n. Infinite or NaN if the square of n overflows.
    #[inline(never)]
    pub(crate) const fn support(&self, n: F32x3) -> f32 {
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

    /// Whether a body is a shell that lies beyond the plane through the eye, perpendicular to the direction of
    /// view, in which all rays begin.
    #[inline(never)]
    const fn sees_shell(&self, body: &Solid) -> bool {
        // The sum is no less than the radius of a ball around the body.
        let radius = body.half_height() + body.radius();
        body.is_shell() && dot(body.center_from(self.eye), self.forward) > MARGIN * radius
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
