//! What the rays of a run of pixels have in common, reckoned once: where they pass the solid, by how much they differ,
//! and where to begin.

use super::certify::First;
use super::ray_row::RayRow;
use super::sweep::Sweep;
use super::track::STEPS;
use crate::lathe::Lathe;
use crate::lathe::frame::ROUNDING;
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::dot_xy;
use crate::vector::{F32x3, cross, dot, one_norm, vector};

/// In units of the frame, where the largest radius is between 1 and 2: what silhouettes are left in doubt.
const DOUBT: f32 = 1.0 / 4096.0;

/// How far from the root a step may leave off, in units of the direction.
const ROOT: f32 = 1.0 / 524_288.0;

impl Lathe {
    /// The pixels from `start` to `end` of a row of rays, in object space. `unit` is the rays' own; each has its origin rounded by
    /// itself, as a number of the size of `rough` is.
    #[inline(always)]
    pub(crate) fn sweep(
        &self,
        rays: &RayRow,
        unit: f32,
        rough: f32,
        width: u32,
        (start, end): (u32, u32),
    ) -> Sweep<'_> {
        let lathe = self.view();
        let frame = lathe.frame;
        let (d, d1) = (frame.squashed(rays.direction), frame.squashed(rays.direction_step));
        let o = frame.squashed(frame.point(rays.origin));
        let o1 = frame.squashed(rays.origin_step * frame.scale);

        // First about the whole row's centre, whatever part is asked for, so that the rounding of a far eye's distance is the
        // same for all parts; then about the part's own.
        let row_centre = 0.5 * width as f32 - 0.5;
        let half = 0.5 * (end - start) as f32;
        let centre = start as f32 - 0.5 + half;
        let (run, shift_of_row) =
            RayRow { origin: o, origin_step: o1, direction: d, direction_step: d1 }.about(row_centre);
        let (run, shift_of_part) = run.about(centre - row_centre);
        let shift = shift_of_row + shift_of_part;
        let RayRow { origin: mc, origin_step: m1, direction: dc, .. } = run;
        let square = dot(dc, dc);

        // |M + s·D| ≤ size means |s| ≤ |M·D|/D² + size/|D|. M·D vanishes half way, and D² and q are above their
        // tangents there.
        let least = square - 2.0 * half * dot(dc, d1).abs();
        let length = Native::sqrt(least);
        let across = half * (dot(mc, d1) + dot(m1, dc)).abs() + half * half * dot(m1, d1).abs();
        let span = (across / length + frame.size) / length;
        let unit = frame.scale * unit;
        let distance = shift.abs() * length + frame.size + rough * unit;
        // What rounding can do to a place, and to g: four times what it was seen to do.
        let slip = ROUNDING * distance;
        let rounding = frame.rounding * distance;
        let doubt = DOUBT + rounding;
        // So where one of them is within the ball, the one half way is within a larger one, by how far they are apart.
        let near = 1.125 * frame.size + slip + half * (one_norm(m1) + span * one_norm(d1));
        let is_far = dot(mc, mc) > near * near;
        let q = dot_xy(dc, dc) - 2.0 * half * dot_xy(dc, d1).abs();
        let steep = dc.z.abs() + half * d1.z.abs();
        let drift = m1.z.abs() + span * d1.z.abs();
        // If the eye is beyond the span, the run's ends are no farther apart than twice what the one half way is long.
        let is_usable = least > 0.25 * square && q > 0.0 && shift > span + slip && doubt < 0.25;

        let Plane { height, slope } = Plane::of(&run, frame.reach + doubt);
        let slope = slope + slip;
        let (low, high) = (greater(frame.low, height - slope), lesser(frame.high, height + slope));
        let is_far = is_far || is_usable && low > high;
        // What is not seen has no middle: it is all one half.
        let (is_mirrored, middle) = if is_far {
            (false, start)
        } else {
            // Over half the run neither g nor heights, for the solid's ends, must differ by more than rounding may make them,
            // nor the plane of reflection be farther from the axis and the ray half way.
            let lopsided = 8.0 * lopsided(&run, span, drift * (1.0 + frame.steepest));
            let is_mirrored = is_usable
                && frame.squash == 1.0
                && (end - start).is_multiple_of(2)
                && half * lopsided < rounding
                && lopsided < 0.5 * rounding * one_norm(m1);
            let middle = if is_mirrored {
                start + (end - start) / 2
            } else {
                let height = lesser(frame.high, greater(frame.low, height));
                let pixel = centre + towards(&run, vector([0.0, 0.0, height]));
                start.max(end.min((pixel + 0.5) as u32))
            };
            (is_mirrored, middle)
        };
        let (origin, direction) = run.at(middle as f32 - 0.5 - centre);
        // No ray of a usable run is longer than √2 times the one half way.
        let longest = 2.25 * square;
        // A bound on half of g″ on any of them.
        let most = longest + frame.curvature * (steep * steep);
        Sweep {
            lathe,
            is_far,
            is_usable,
            may_follow: is_usable,
            rays: RayRow { origin, direction, ..run },
            shift,
            unit,
            middle,
            end: end - middle,
            left: middle - start,
            is_mirrored,
            is_turned: false,
            span,
            low,
            high,
            steep,
            rising: (is_usable && dc.z.abs() > half * d1.z.abs()).then_some(dc.z > 0.0),
            bulge: q / (steep * steep),
            drift: 0.25 * drift / span,
            doubt,
            slack: 2.0 * Native::sqrt(longest * doubt) + 16.0 * ROOT * most,
            tolerance: ROOT / most,
            following: false,
            sign: 1.0,
            s: 0.0,
            step: 0.0,
            bend: 0.0,
            index: 0,
            segment: lathe.segments.first().unwrap_or(&Segment::EMPTY),
            first: First::UNKNOWN,
            entry: None,
            looked: u32::MAX,
            tries: STEPS,
        }
    }
}

/// By how much g can differ, at the same s within the span, between the rays a pixel before the one half way and a
/// pixel after it; `drop` is a bound on how F differs. Over n pixels it is n times as much: what differs in x² + y²
/// are the terms that change their sign with the pixel's number.
#[inline(always)]
fn lopsided(run: &RayRow, span: f32, drop: f32) -> f32 {
    let RayRow { origin: m, origin_step: m1, direction: d, direction_step: d1 } = *run;
    let lean = dot_xy(m, d1) + dot_xy(m1, d);
    4.0 * (dot_xy(m, m1).abs() + span * (lean.abs() + span * dot_xy(d, d1).abs())) + 2.0 * drop
}

/// The plane of a row's rays.
struct Plane {
    /// The height at which it meets the axis.
    height: f32,
    /// From so much lower to so much higher it is within a cylinder around the axis.
    slope: f32,
}

impl Plane {
    /// Given the square of the cylinder's radius. At each height the plane holds a line, whose distance from the axis
    /// is as the height from there on.
    #[inline(always)]
    fn of(run: &RayRow, reach: f32) -> Self {
        let normal = cross(run.origin_step, run.direction);
        let per_z = 1.0 / normal.z;
        let slope = Native::sqrt(reach * dot_xy(normal, normal)) * per_z.abs();
        Self { height: dot(normal, run.origin) * per_z, slope }
    }
}

/// How many pixels from the one half way the ray is, about, that passes nearest to a point.
#[inline(always)]
fn towards(run: &RayRow, point: F32x3) -> f32 {
    let RayRow { origin, origin_step, direction, direction_step } = *run;
    let there = point - origin;
    let along = dot(there, direction) / dot(direction, direction);
    let step = origin_step + direction_step * along;
    dot(there - direction * along, step) / dot(step, step)
}
