use super::chord::Chord;
use super::{Frame, View, is_beyond};
use crate::hit::Hit;
use crate::math::Math;
use crate::math::order::{greater, lesser};
use crate::ray::Ray;
use crate::solve::Solver;
use core::ops::ControlFlow;

/// A ray in the lathe's frame, its origin moved along it to where it is nearest to the frame's, so that what
/// follows has the size of the solid however far away the ray comes from. x is scaled by √k: there every
/// lathe is round.
pub(super) struct Path {
    pub x: f32,
    pub y: f32,
    pub z: f32,
    pub dx: f32,
    pub dy: f32,
    pub dz: f32,
    /// Infinite for a horizontal path.
    per_dz: f32,
    /// dx² + dy².
    pub q: f32,
    per_q: f32,
    /// The t at which the path is nearest to the axis, and the square of the distance there.
    pub nearest: f32,
    square: f32,
    /// Where the path's origin lies on the ray, in the path's t.
    shift: f32,
    /// A distance along the ray, in units of its own direction, is a path's t (from the ray's origin) times
    /// this.
    per_unit: f32,
}

impl Path {
    #[inline(always)]
    fn new(frame: &Frame, ray: &Ray) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let (x, y, z) = (o.x * frame.scale, o.y * frame.scale, (o.z - frame.middle) * frame.scale);
        let shift = -(x * d.x + y * d.y + z * d.z) / (d.x * d.x + d.y * d.y + d.z * d.z);
        let (x, y, z) = ((x + shift * d.x) * frame.root_squash, y + shift * d.y, z + shift * d.z);
        let (dx, dy, dz) = (d.x * frame.root_squash, d.y, d.z);
        let q = dx * dx + dy * dy;
        // Parallel to the axis, it is as near everywhere.
        let per_q = if q > f32::MIN_POSITIVE { 1.0 / q } else { f32::INFINITY };
        let nearest = if per_q < f32::INFINITY { -(x * dx + y * dy) * per_q } else { 0.0 };
        let (ax, ay) = (x + nearest * dx, y + nearest * dy);
        Self {
            x,
            y,
            z,
            dx,
            dy,
            dz,
            // −0 + 0 = +0: a horizontal path counts as rising.
            per_dz: 1.0 / (dz + 0.0),
            q,
            per_q,
            nearest,
            square: ax * ax + ay * ay,
            shift,
            per_unit: 1.0 / (frame.scale * ray.unit),
        }
    }

    /// From where to where the path is in a cylinder about the axis, of the radius whose square is given.
    #[inline(always)]
    fn within<M: Math>(&self, reach: f32) -> Option<(f32, f32)> {
        if self.square > reach {
            return None;
        }
        let half = M::sqrt((reach - self.square) * self.per_q);
        Some((self.nearest - half, self.nearest + half))
    }

    /// Where the path passes a height.
    #[inline(always)]
    pub fn plane(&self, z: f32) -> f32 {
        (z - self.z) * self.per_dz
    }

    /// The distance along the ray, in units of its own direction, at the path's t.
    #[inline(always)]
    pub fn distance(&self, t: f32) -> f32 {
        (t + self.shift) * self.per_unit
    }
}

/// What a walk along a ray comes upon.
pub(super) enum Meeting<'a> {
    /// The ray passes through a cap.
    Cap(Hit),
    /// g may change sign along the chord.
    Chord(Chord<'a>),
}

/// Follows a ray through the slabs of a lathe's segments and reports what it comes upon beyond `t_min`, in
/// order, until told to stop. The answer to a meeting is whether the ray is inside after it.
///
/// A bound that does not exist (the plane of a slab for a horizontal ray, the cylinder for a vertical one)
/// has an infinite t, or NaN, which `lesser` and `greater` pass over: neither ray is a special case.
#[inline(always)]
pub(super) fn walk<S: Solver, B>(
    lathe: View<'_>,
    ray: &Ray,
    t_min: f32,
    mut meet: impl FnMut(Meeting) -> ControlFlow<B, bool>,
) -> Option<B> {
    let View { frame, segments } = lathe;
    let path = &Path::new(frame, ray);
    let first = t_min * (frame.scale * ray.unit) - path.shift;

    let (near, far) = path.within::<S::Math>(frame.reach)?;
    let slab = Slab::new(path, frame);
    let enter = greater(greater(first, near), slab.near);
    let leave = lesser(far, slab.far);
    // Not finite: the ray lies along an endless sheet, and g is the same all along it.
    if !(enter < leave && (leave - enter).is_finite()) {
        return None;
    }

    // A ray that comes in through the cylinder is outside. One that comes in through an end, or starts here,
    // has g to tell.
    let mut inside = (enter > first && enter > slab.near).then_some(false);
    let mut at = enter;
    for step in 0..segments.len() {
        let index = if slab.up { step } else { segments.len() - 1 - step };
        let Some(segment) = segments.get(index) else {
            break;
        };
        let exit = path.plane(if slab.up { segment.high } else { segment.low });
        if exit <= at {
            continue;
        }
        let end = lesser(leave, exit);
        let mut after = false;
        if let Some((near, far)) = path.within::<S::Math>(segment.reach) {
            let (from, to) = (greater(at, near), lesser(end, far));
            if from < to {
                let known = if from > at { Some(false) } else { inside };
                let chord = Chord::new(path, segment, index, [from, to], known, from > first);
                after = chord.inside;
                if known.is_none()
                    && after
                    && enter > first
                    && let Some(hit) = cap(frame, path, enter, t_min, slab.up, true)
                    && let ControlFlow::Break(found) = meet(Meeting::Cap(hit))
                {
                    return Some(found);
                }
                if !chord.is_clear() {
                    match meet(Meeting::Chord(chord)) {
                        ControlFlow::Break(found) => return Some(found),
                        ControlFlow::Continue(inside) => after = inside,
                    }
                }
                // Beyond the segment's cylinder there is only outside.
                after &= !(to < end);
            }
        }
        inside = Some(after);
        at = end;
        if !(end < leave) {
            break;
        }
    }
    if inside == Some(true)
        && leave == slab.far
        && let Some(hit) = cap(frame, path, leave, t_min, !slab.up, false)
        && let ControlFlow::Break(found) = meet(Meeting::Cap(hit))
    {
        return Some(found);
    }
    None
}

/// The hit in the plane of an end, if part of the surface is there, beyond `t_min`.
#[inline(never)]
fn cap(frame: &Frame, path: &Path, t: f32, t_min: f32, low: bool, enters: bool) -> Option<Hit> {
    let (segment, u, part) = if low { (0, 0.0, frame.base) } else { (frame.len - 1, 1.0, frame.top) };
    let hit = Hit { t: path.distance(t), segment, u, enters, part: part? };
    is_beyond(hit.t, t_min).then_some(hit)
}

/// From where to where a path is between the ends of a lathe.
struct Slab {
    near: f32,
    far: f32,
    /// Whether the path does not descend.
    up: bool,
}

impl Slab {
    #[inline(always)]
    fn new(path: &Path, frame: &Frame) -> Self {
        let up = path.per_dz > 0.0;
        let (low, high) = (path.plane(frame.low), path.plane(frame.high));
        let (near, far) = if up { (low, high) } else { (high, low) };
        Self { near, far, up }
    }
}
