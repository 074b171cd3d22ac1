//! The full traversal of one ray: segment by segment, whatever the ray.

use super::chord::Chord;
use super::is_beyond;
use super::local_ray::LocalRay;
use crate::hit::{Hit, Part};
use crate::lathe::frame::{Frame, View};
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, UNIT_ROUNDOFF};
use crate::solve::Solver;

/// An upper bound of the relative error of the t at which a ray is nearest to the axis, and of what
/// [`Interval::new`] computes from it. Four roundings of 2⁻²⁴ add up: two in q, which is a product and a sum,
/// one in the quotient `nearest`, and one in the sum with `half`. The numerator of the quotient is rounded,
/// too. That moves the t by 2·2⁻²⁴ times the ray's distance over √q, which the widening of the bounding
/// cylinder covers (see [`widened`](crate::lathe::segment::widened)).
const NEAREST_ERROR: f32 = 4.0 * UNIT_ROUNDOFF;

/// Where a ray may meet a lathe: from `from` to `to`, in the local ray's t.
struct Interval {
    from: f32,
    to: f32,
    /// Whether it begins on the plane of an end of the profile.
    starts_at_plane: bool,
    /// Whether it begins on the bounding cylinder, where the ray is outside.
    starts_outside: bool,
}

impl Interval {
    /// The interval between the profile's ends, within the bounding cylinder, beyond `t_min`, a t of the
    /// [`Ray`](crate::Ray). `None` if it is empty or infinite.
    ///
    /// A bound that does not exist (the plane of an end for a horizontal ray, the cylinder for a vertical
    /// one) is infinite, or NaN, which `lesser` and `greater` ignore: neither ray is a special case.
    #[inline(always)]
    fn new<M: Math>(frame: &Frame, ray: &LocalRay, t_min: f32) -> Option<Self> {
        if ray.square > frame.bounding_square {
            return None;
        }
        let half = M::sqrt((frame.bounding_square - ray.square) / ray.q) + NEAREST_ERROR * ray.nearest.abs();
        let (bottom, top) = ray.slab(frame.low, frame.high);
        let first = t_min * ray.unit - ray.shift;
        let inner = greater(first, bottom);
        let from = greater(inner, ray.nearest - half);
        let to = lesser(ray.nearest + half, top);
        // The interval is infinite for a ray that lies along an infinite sheet: g is the same all along such
        // a ray.
        if !(from < to && (to - from).is_finite()) {
            return None;
        }
        let starts_outside = from > inner;
        let starts_at_plane = bottom > first && !starts_outside;
        Some(Self { from, to, starts_at_plane, starts_outside })
    }
}

/// Follows a ray through the slabs of a lathe's segments and calls `meet` with each crossing beyond `t_min`,
/// a t of the [`Ray`](crate::Ray), in order, until `meet` returns `None`. Returns `None` at the end.
///
/// The state is on which side of the surface the ray is. On the plane between two segments the radius common
/// to both decides it. Rounding may put a crossing near the plane beyond the end of the first segment and
/// before the beginning of the second; it is then reported on the plane. Where the two have no common radius,
/// at a step, each side of the plane has its own, and a ray that changes sides there meets the ring between
/// the two. The plane of an end is such a step, between the radius of the wall and that of the opening, which
/// is zero at a cap.
#[inline(always)]
pub(super) fn traverse<S: Solver>(
    lathe: View<'_>,
    ray: &LocalRay,
    t_min: f32,
    mut meet: impl FnMut(Hit) -> Option<()>,
) -> Option<()> {
    let interval = Interval::new::<S::Math>(lathe.frame, ray, t_min)?;
    let mut traversal = Traversal::enter(lathe, ray, &interval)?;
    // Once a crossing is beyond t_min all that follow are, however their t is rounded.
    let mut since = t_min;
    let mut report = |hit: Hit| {
        if !is_beyond(hit.t, since) {
            return Some(());
        }
        since = f32::NEG_INFINITY;
        meet(hit)
    };
    loop {
        let segment = lathe.segments.get(traversal.index);
        if let Some(hit) = traversal.plane(segment) {
            report(hit)?;
        }
        traversal.slab::<S>(segment?, interval.to, &mut report)?;
    }
}

/// A ray on its way through the slabs.
struct Traversal<'a> {
    frame: &'a Frame,
    ray: &'a LocalRay,
    /// Whether the ray rises, or is horizontal.
    up: bool,
    /// The number of the segment that the ray comes to.
    index: usize,
    /// The local ray's t at which the ray comes to it.
    at: f32,
    /// The squared distance from the axis there.
    square: f32,
    /// The squared radius at the end of the segment before. `None` if the ray begins between planes.
    before: Option<f32>,
    /// Whether the ray is inside the solid.
    inside: bool,
}

impl<'a> Traversal<'a> {
    /// The ray where it comes to the lathe: on the plane of an end, on the bounding cylinder, or at `t_min`.
    /// `None` if no segment is there.
    #[inline(always)]
    fn enter(lathe: View<'a>, ray: &'a LocalRay, interval: &Interval) -> Option<Self> {
        let View { frame, segments } = lathe;
        let (up, at) = (ray.rises(), interval.from);
        let square = ray.around(at).0;
        let (index, before, inside);
        if interval.starts_at_plane {
            let (first, end) = if up { (0, &frame.base) } else { (frame.len - 1, &frame.top) };
            (index, before, inside) = (first, Some(end.beyond), end.beyond > square);
        } else {
            (index, before) = (lathe.index_at(ray.height(at)), None);
            inside = !interval.starts_outside && ray.g_about(segments.get(index)?, at).c[0] > 0.0;
        }
        Some(Self { frame, ray, up, index, at, square, before, inside })
    }

    /// Passes the plane that the ray has come to, given the segment on the other side, or `None` if the ray
    /// leaves the last one. Returns the hit on the plane, and changes `inside`, if the ray changes sides
    /// there; else `None`, also where the ray has begun between planes.
    #[inline(always)]
    fn plane(&mut self, segment: Option<&Segment>) -> Option<Hit> {
        let before = self.before?;
        let exit = if self.up { &self.frame.top } else { &self.frame.base };
        let behind = segment.map_or(exit.beyond, |segment| segment.end(!self.up));
        if (behind > self.square) == self.inside {
            return None;
        }
        self.inside = !self.inside;
        let is_step = before.to_bits() != behind.to_bits();
        // The number of the segment above the plane.
        let upper = if self.up { self.index } else { self.index.wrapping_add(1) };
        Some(plane_hit(self.frame, self.ray.distance(self.at), upper, is_step, self.up, self.inside))
    }

    /// Passes the slab of the segment, as far as `to`, and reports the hits in it. Afterwards the state is
    /// that at the next plane. Returns `None` if the ray comes to no next plane, or if `report` returns
    /// `None`: then the traversal is at its end.
    #[inline(always)]
    fn slab<S: Solver>(
        &mut self,
        segment: &Segment,
        to: f32,
        report: &mut impl FnMut(Hit) -> Option<()>,
    ) -> Option<()> {
        let (ray, up, at) = (self.ray, self.up, self.at);
        let plane = ray.plane(if up { segment.high } else { segment.low });
        let (end, is_to_plane) = (lesser(to, plane), plane <= to);
        let is_near = ray.around(ray.closest(at, end)).0 <= segment.bounding_square;
        self.square = ray.around(end).0;
        // A chord outside the segment's cylinder is passed over, unless the ray is inside the solid where it
        // comes to the segment. Then rounding has put the crossing out of the solid beyond the plane, and the
        // chord reports it at its beginning.
        if is_near || self.inside {
            // If the ray comes to no plane, the chord ends on the bounding cylinder, outside of the solid.
            let ends_inside = is_to_plane && segment.end(up) > self.square;
            let chord = Chord::new(ray, segment, self.index, [at, end]);
            let mut crossings = chord.crossings(self.inside, ends_inside);
            while let Some(s) = crossings.next::<S>() {
                self.inside = !self.inside;
                report(chord.hit(s, self.inside))?;
            }
        }
        (self.at, self.before) = (end, Some(segment.end(up)));
        self.index = self.index.wrapping_add(if up { 1 } else { usize::MAX });
        is_to_plane.then_some(())
    }
}

/// The hit on a plane where a ray changes sides, at the t of the [`Ray`](crate::Ray). If `is_step`, it is on
/// the ring or cap in the plane. Else it is on the wall, where that meets the plane: a segment's height is
/// so small that the crossing was not found within the segment. `upper` is the number of the segment above
/// the plane, one past the last if there is none; `up` says whether the ray rises, `enters` whether it enters
/// the solid.
#[inline(never)]
fn plane_hit(frame: &Frame, t: f32, upper: usize, is_step: bool, up: bool, enters: bool) -> Hit {
    let (is_base, is_top) = (upper == 0, upper == frame.len);
    // A ring that rising rays leave through, and falling rays enter through, faces up, and belongs to the
    // segment below.
    let is_of_lower = is_top || up != enters && !is_base;
    Hit {
        t,
        segment: if is_of_lower { upper - 1 } else { upper },
        u: if is_of_lower { 1.0 } else { 0.0 },
        enters,
        part: match is_step {
            false => Part::Wall,
            _ if is_base => Part::Base,
            _ if is_top => Part::Top,
            _ => Part::Ring,
        },
    }
}
