//! The full traversal of one ray: segment by segment, whatever the ray.

use super::chord::Chord;
use super::is_beyond;
use super::local_ray::LocalRay;
use crate::hit::{Hit, Part};
use crate::lathe::frame::{Frame, View};
use crate::math::Math;
use crate::math::minmax::{greater, lesser};
use crate::solve::Solver;
use core::ops::ControlFlow;

/// How far the place nearest to the axis may be off, relative: it is a quotient of two sums of two products, four roundings of
/// 2⁻²⁴.
const NEAREST_ERROR: f32 = 1.0 / 4_194_304.0;

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
    /// Between the profile's ends, within the bounding cylinder, beyond `t_min`. `None` if that is empty or without end.
    ///
    /// A bound that does not exist (the plane of an end for a horizontal ray, the cylinder for a vertical one) is infinite, or
    /// NaN, which `lesser` and `greater` pass over: neither ray is a special case.
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
        // Without end: the ray lies along an endless sheet, and g is the same all along it.
        if !(from < to && (to - from).is_finite()) {
            return None;
        }
        let starts_outside = from > inner;
        let starts_at_plane = bottom > first && !starts_outside;
        Some(Self { from, to, starts_at_plane, starts_outside })
    }
}

/// Follows a ray through the slabs of a lathe's segments and reports the crossings beyond `t_min`, in order, until `meet` breaks
/// off. Returns what `meet` broke off with.
///
/// The state is which side of the surface the ray is on. On the plane between two segments their common radius decides it, for
/// both: a crossing that one of them finds beyond its end, and the other before its beginning, is reported there. Where they
/// have no common radius, at a step, each side of the plane has its own, and a ray that changes sides there meets the ring
/// between the two. The plane of an end is a step, too, to the radius of what is open there.
#[inline(always)]
pub(super) fn traverse<S: Solver, B>(
    lathe: View<'_>,
    ray: &LocalRay,
    t_min: f32,
    mut meet: impl FnMut(Hit) -> ControlFlow<B>,
) -> Option<B> {
    let View { frame, segments } = lathe;
    let interval = Interval::new::<S::Math>(frame, ray, t_min)?;
    let up = ray.rises();
    let (first, step) = if up { (0, 1) } else { (frame.len - 1, usize::MAX) };
    let (entry, exit) = if up { (&frame.base, &frame.top) } else { (&frame.top, &frame.base) };
    let mut index = if interval.starts_at_plane { first } else { lathe.index_at(ray.height(interval.from)) };
    let mut at = interval.from;
    let mut square = ray.around(at).0;
    // The squared radius on this side of the plane that the ray has come to, unless it begins between planes.
    let mut before = interval.starts_at_plane.then_some(entry.beyond);
    let mut inside = if interval.starts_at_plane {
        entry.beyond > square
    } else {
        !interval.starts_outside && ray.g_about(segments.get(index)?, at).c[0] > 0.0
    };
    // Once a crossing is beyond t_min all that follow are, however their t is rounded.
    let mut since = t_min;
    loop {
        let segment = segments.get(index);
        let behind = segment.map_or(exit.beyond, |segment| segment.end(!up));
        if let Some(before) = before
            && (behind > square) != inside
        {
            inside = !inside;
            let is_step = before.to_bits() != behind.to_bits();
            let hit = plane_hit(frame, ray.distance(at), index, is_step, up, inside);
            if is_beyond(hit.t, since) {
                since = f32::NEG_INFINITY;
                if let ControlFlow::Break(found) = meet(hit) {
                    return Some(found);
                }
            }
        }
        let segment = segment?;
        let plane = ray.plane(if up { segment.high } else { segment.low });
        let (end, is_to_plane) = (lesser(interval.to, plane), plane <= interval.to);
        let is_near = ray.around(ray.closest(at, end)).0 <= segment.bounding_square;
        square = ray.around(end).0;
        // A ray that is inside at the beginning of a chord that is not near has left the solid there, by less than rounding.
        if is_near || inside {
            let ends_inside = is_to_plane && segment.end(up) > square;
            let chord = Chord::new(ray, segment, index, [at, end]);
            let mut crossings = chord.crossings(inside, ends_inside);
            while let Some(s) = crossings.next::<S>() {
                inside = !inside;
                let hit = chord.hit(s, inside);
                if is_beyond(hit.t, since) {
                    since = f32::NEG_INFINITY;
                    if let ControlFlow::Break(found) = meet(hit) {
                        return Some(found);
                    }
                }
            }
        }
        // Where it leaves the bounding cylinder it is outside for good.
        if !is_to_plane {
            return None;
        }
        (at, before) = (end, Some(segment.end(up)));
        index = index.wrapping_add(step);
    }
}

/// The hit on a plane where a ray changes sides: of the ring there, if it is a step's or an end's; else of the wall's circle, where a
/// segment is too low for the crossing to be found within. `index` is the number of the segment behind the plane, if there is one.
#[inline(never)]
fn plane_hit(frame: &Frame, t: f32, index: usize, is_step: bool, up: bool, enters: bool) -> Hit {
    // Of the segment above the plane.
    let upper = if up { index } else { index.wrapping_add(1) };
    let (is_base, is_top) = (upper == 0, upper == frame.len);
    // What rays leave upwards faces up, and belongs to the segment below.
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
