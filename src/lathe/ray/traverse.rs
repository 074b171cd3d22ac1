use super::chord::Chord;
use super::is_beyond;
use super::local_ray::LocalRay;
use crate::hit::Hit;
use crate::lathe::frame::{Frame, View};
use crate::lathe::segment::Segment;
use crate::math::Math;
use crate::math::minmax::{greater, lesser};
use crate::solve::Solver;
use core::ops::ControlFlow;

/// Two units in the last place, and two more.
const ROUNDING: f32 = 1.0 / 4_194_304.0;

/// Follows a ray through the slabs of a lathe's segments and reports the crossings beyond `t_min`, in order,
/// until told to stop.
///
/// A bound that does not exist (the plane of a slab for a horizontal ray, the cylinder for a vertical one)
/// has an infinite t, or NaN, which `lesser` and `greater` pass over: neither ray is a special case.
#[inline(always)]
pub(super) fn walk<S: Solver, B>(
    lathe: View<'_>,
    path: &LocalRay,
    t_min: f32,
    mut meet: impl FnMut(Hit) -> ControlFlow<B>,
) -> Option<B> {
    let View { frame, segments } = lathe;
    if path.square > frame.reach {
        return None;
    }
    // Far up a needle that is wider by what rounding does to a place.
    let half = S::Math::sqrt((frame.reach - path.square) / path.q) + ROUNDING * path.nearest.abs();
    let up = path.rises();
    let (bottom, top) = path.slab(frame.low, frame.high);
    let first = t_min * path.unit - path.shift;
    let inner = greater(first, bottom);
    let enter = greater(inner, path.nearest - half);
    let leave = lesser(path.nearest + half, top);
    // Not finite: the ray lies along an endless sheet, and g is the same all along it.
    if !(enter < leave && (leave - enter).is_finite()) {
        return None;
    }

    let step = if up { 1 } else { usize::MAX };
    let mut index = lathe.index_at(path.height(enter));

    // A ray that comes in through the cylinder is outside. One that comes in through an end, or starts here,
    // has g to tell.
    let g = |segment: &Segment| path.g_about(segment, enter).c[0];
    let mut inside = !(enter > inner) && segments.get(index).is_some_and(|segment| g(segment) > 0.0);
    if inside
        && bottom > first
        && let Some(hit) = cap(frame, path, enter, t_min, up, true)
        && let ControlFlow::Break(found) = meet(hit)
    {
        return Some(found);
    }
    // Once one is beyond all that follow are, whatever rounding makes of their t.
    let mut since = t_min;
    let mut at = enter;
    while let Some(segment) = segments.get(index) {
        let end = lesser(leave, path.plane(if up { segment.high } else { segment.low }));
        if let Some(chord) = Chord::new(path, segment, index, [at, end], inside) {
            let mut crossings = chord.crossings(inside);
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
        if !(end < leave) {
            break;
        }
        index = index.wrapping_add(step);
    }
    if inside
        && leave == top
        && let Some(hit) = cap(frame, path, leave, since, !up, false)
        && let ControlFlow::Break(found) = meet(hit)
    {
        return Some(found);
    }
    None
}

/// The hit in the plane of an end, if part of the surface is there, beyond `t_min`.
#[inline(never)]
fn cap(frame: &Frame, path: &LocalRay, t: f32, t_min: f32, low: bool, enters: bool) -> Option<Hit> {
    let (segment, u, part) =
        if low { (0, 0.0, frame.base.part) } else { (frame.len - 1, 1.0, frame.top.part) };
    let hit = Hit { t: path.distance(t), segment, u, enters, part: part? };
    is_beyond(hit.t, t_min).then_some(hit)
}
