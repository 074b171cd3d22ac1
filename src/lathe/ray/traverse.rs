//! The full traversal of one ray: segment by segment, whatever the ray.

use super::chord::Chord;
use super::is_beyond;
use super::local_ray::LocalRay;
use crate::hit::Hit;
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
        if ray.square > frame.reach {
            return None;
        }
        let half = M::sqrt((frame.reach - ray.square) / ray.q) + NEAREST_ERROR * ray.nearest.abs();
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
/// both: a crossing that one of them finds beyond its end, and the other before its beginning, is reported there.
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
    let mut index = if interval.starts_at_plane { first } else { lathe.index_at(ray.height(interval.from)) };
    let segment = segments.get(index)?;
    let mut inside = if interval.starts_at_plane {
        segment.end(!up) > ray.around(interval.from).0
    } else {
        !interval.starts_outside && ray.g_about(segment, interval.from).c[0] > 0.0
    };
    // Once a crossing is beyond t_min all that follow are, however their t is rounded.
    let mut since = t_min;
    if inside
        && interval.starts_at_plane
        && let Some(hit) = cap(frame, ray, interval.from, t_min, up, true)
    {
        since = f32::NEG_INFINITY;
        if let ControlFlow::Break(found) = meet(hit) {
            return Some(found);
        }
    }
    let mut at = interval.from;
    while let Some(segment) = segments.get(index) {
        let plane = ray.plane(if up { segment.high } else { segment.low });
        let end = lesser(interval.to, plane);
        let is_near = ray.around(ray.closest(at, end)).0 <= segment.reach;
        // A ray that is inside at the beginning of a chord that is not near has left the solid there, by less than rounding.
        if is_near || inside {
            let ends_inside = plane <= interval.to && segment.end(up) > ray.around(end).0;
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
        at = end;
        if !(end < interval.to) {
            break;
        }
        index = index.wrapping_add(step);
    }
    // Where it leaves the bounding cylinder it is outside: this is the plane of the other end.
    if inside
        && let Some(hit) = cap(frame, ray, interval.to, since, !up, false)
        && let ControlFlow::Break(found) = meet(hit)
    {
        return Some(found);
    }
    None
}

/// The hit of a cap on the plane of an end, if there is one, beyond `t_min`.
#[inline(never)]
fn cap(frame: &Frame, ray: &LocalRay, t: f32, t_min: f32, low: bool, enters: bool) -> Option<Hit> {
    let (segment, u, part) =
        if low { (0, 0.0, frame.base.part) } else { (frame.len - 1, 1.0, frame.top.part) };
    let hit = Hit { t: ray.distance(t), segment, u, enters, part: part? };
    is_beyond(hit.t, t_min).then_some(hit)
}
