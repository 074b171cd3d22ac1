//! Neighbouring rays, one after another: where one meets the wall is where the next one is looked for.
//!
//! In the lathe's frame the rays of a row are `P = M + s·D`, M and D linear in the pixel's number i, with s
//! counted from where the row passes the solid. A pixel is one of three things, the cheapest asked first:
//!
//! - **A root, followed** from the last pixel's by Newton's method, one step mostly (`follow.rs`), and
//!   certified to be the ray's first (`first.rs`).
//! - **One of a run of misses**, certified together ([`Sweep::look`], `clear.rs`).
//! - **Nothing certain**: within `doubt` of a silhouette, a rim or a cap. Its ray goes alone, as any other.

use super::first::First;
use super::follow::STEPS;
use super::path::{Path, flat};
use super::segment::{Cover, Segment};
use super::{Lathe, View};
use crate::hit::{Hit, Part};
use crate::math::{Math, Native};
use crate::rays::Rays;
use crate::vector::{F32x3, cross, dot, vector};
use crate::math::order::{greater, lesser};

/// A run of rays at a lathe, and the root that is followed along it.
pub(crate) struct Sweep<'a> {
    pub(super) lathe: View<'a>,
    /// Whether none of the rays comes near the solid.
    pub is_far: bool,
    /// Not if the rays spread too wide, or begin too near the solid, for what they share to be of use.
    is_usable: bool,
    /// M and D, in the frame, x scaled by √k.
    pub(super) rays: Rays,
    /// Where s = 0 is on the rays; that times `per_unit` is a distance along them.
    pub(super) shift: f32,
    pub(super) per_unit: f32,
    /// The pixel that all are counted from: to the right at first.
    pub middle: u32,
    /// How many pixels there are in this direction, and to the left of the middle.
    pub end: u32,
    left: u32,
    is_mirrored: bool,
    pub is_turned: bool,
    /// Every point of the solid on every ray of the run has |s| ≤ span.
    pub(super) span: f32,
    /// From where to where in height rays of the run can meet the solid.
    pub(super) low: f32,
    pub(super) high: f32,
    /// The largest |dz| and the least q of any ray of the run.
    pub(super) steep: f32,
    pub(super) q: f32,
    /// Whether they rise, or fall, or, as some do either: neither.
    pub(super) rising: Option<bool>,
    /// The largest |∂z/∂i| within the span.
    pub(super) drift: f32,
    /// What lies nearer than this to a decision, in g or in z, is not decided here.
    pub(super) doubt: f32,
    /// The slope of a root behind which g comes to more than that: A² > 4·q·doubt.
    pub(super) slack: f32,
    /// A step s leaves an error of `s²/slope` over this.
    pub(super) tolerance: f32,

    /// Whether there is a root to follow, and whether it enters the solid, 1, or leaves it, −1.
    pub(super) following: bool,
    pub(super) sign: f32,
    /// Where it is looked for at the next pixel, how far it moved at the last one, and how much farther than
    /// before.
    pub(super) s: f32,
    pub(super) step: f32,
    pub(super) bend: f32,
    /// The segment it is in.
    pub(super) index: usize,
    pub(super) segment: &'a Segment,
    /// How it is known to be the first.
    pub(super) first: First,
    /// The pixel last looked at in vain.
    pub(super) looked: u32,
    /// How often something else may be tried at one pixel.
    pub(super) tries: u32,
}

/// In units of the frame, where the largest radius is between 1 and 2: what silhouettes are left in doubt.
const DOUBT: f32 = 1.0 / 4096.0;

/// What rounding can do at a unit's distance: sixteen units of 2⁻²⁴, four times what it was seen to do.
const ROUNDING: f32 = 16.0 / 16_777_216.0;

/// How far from the root a step may leave off.
const ROOT: f32 = 1.0 / 2_097_152.0;

impl Lathe {
    /// The pixels from `start` to `end` of a row of rays, in object space. `unit` is the rays' own.
    #[inline(always)]
    pub(crate) fn sweep(
        &self,
        rays: &Rays,
        unit: f32,
        start: u32,
        end: u32,
        is_lone: bool,
    ) -> Sweep<'_> {
        let lathe = self.view();
        let frame = lathe.frame;
        let (d, d1) = (frame.squashed(rays.direction), frame.squashed(rays.direction_step));
        let o = frame.squashed(frame.point(rays.origin));
        let o1 = frame.squashed(rays.origin_step * frame.scale);

        let half = 0.5 * (end - start) as f32;
        let centre = start as f32 - 0.5 + half;
        let (oc, dc) = (o + o1 * centre, d + d1 * centre);
        let square = dot(dc, dc);
        let shift = -dot(oc, dc) / square;
        let (mc, m1) = (oc + dc * shift, o1 + d1 * shift);

        // Where one of them is within the ball, the middle one is within a ball larger by how far they are apart
        // there, half·|∂M/∂i + s·∂D/∂i| and |s| no more than its radius over |D|.
        let one_norm = |v: F32x3| v.x.abs() + v.y.abs() + v.z.abs();
        let (apart, spread) = (half * one_norm(m1), half * one_norm(d1));
        let near = (8.0 / 7.0) * (frame.size + apart);
        let is_far = 64.0 * (spread * spread) < square && dot(mc, mc) > near * near;

        // |M + s·D| ≤ size means |s| ≤ |M·D|/D² + size/|D|. M·D vanishes in the middle of the run, and D² and
        // q are above their tangents there.
        let least = square - 2.0 * half * dot(dc, d1).abs();
        let length = Native::sqrt(least);
        let lean = flat(mc, d1) + flat(m1, dc);
        let across = half * (lean + mc.z * d1.z + m1.z * dc.z).abs() + half * half * dot(m1, d1).abs();
        let span = (across / length + frame.size) / length;
        let q = flat(dc, dc) - 2.0 * half * flat(dc, d1).abs();
        let steep = dc.z.abs() + half * d1.z.abs();
        let distance = shift.abs() * length + frame.size;
        let rounding = ROUNDING * distance * (2.0 + frame.steepest);
        let doubt = DOUBT + rounding;
        let drift = m1.z.abs() + span * d1.z.abs();
        // By how much g can differ, at the same s, on the ray as far on the other side of the middle.
        let lopsided = flat(mc, m1).abs() + span * (lean.abs() + span * flat(dc, d1).abs());
        let lopsided = half * (4.0 * lopsided + 2.0 * drift * frame.steepest);
        let is_usable =
            least > 0.25 * square && q > 0.0 && shift > span && doubt < 0.25 && frame.steepest < 1e9;
        let is_mirrored =
            is_usable && is_lone && frame.squash == 1.0 && (end - start) % 2 == 0 && 8.0 * lopsided < rounding;
        // The row's plane holds a horizontal line at each height: where that meets the axis, and from where to where it
        // is within the cylinder around the solid.
        let normal = cross(m1, dc);
        let height = dot(normal, mc) / normal.z;
        let slope = Native::sqrt((frame.reach + doubt) * flat(normal, normal)) / normal.z.abs() + ROUNDING * distance;
        let (low, high) = (greater(frame.low, height - slope), lesser(frame.high, height + slope));
        let middle = if is_mirrored {
            start + (end - start) / 2
        } else {
            let height = lesser(frame.high, greater(frame.low, height));
            let there = vector([-mc.x, -mc.y, height - mc.z]);
            let across = m1 + d1 * (dot(there, dc) / square);
            let across = across - dc * (dot(across, dc) / square);
            let pixels = dot(there, across) / dot(across, across);
            start.max(end.min((centre + pixels + 0.5) as u32))
        };
        let from_centre = middle as f32 - centre;
        let (m, d) = (mc + m1 * from_centre, dc + d1 * from_centre);
        // No ray of a usable run is longer than three halves of the middle one.
        let longest = 2.25 * square;
        Sweep {
            lathe,
            is_far,
            is_usable,
            rays: Rays { origin: m, origin_step: m1, direction: d, direction_step: d1 },
            shift,
            per_unit: 1.0 / (frame.scale * unit),
            end: end - middle,
            is_mirrored,
            middle,
            left: middle - start,
            is_turned: false,
            span,
            low,
            high,
            steep,
            rising: (dc.z.abs() > half * d1.z.abs()).then_some(dc.z > 0.0),
            q,
            drift,
            doubt,
            slack: 4.0 * Native::sqrt(doubt),
            tolerance: ROOT / (longest + frame.curvature * (steep * steep)),
            following: false,
            sign: 1.0,
            s: 0.0,
            step: 0.0,
            bend: 0.0,
            index: 0,
            segment: lathe.segments.first().unwrap_or(&Segment::EMPTY),
            first: First::UNKNOWN,
            looked: u32::MAX,
            tries: STEPS,
        }
    }
}

impl Sweep<'_> {
    /// The i-th ray.
    pub(super) fn path(&self, i: u32) -> Path {
        let (m, d) = self.rays.at(i);
        Path::about(m, d, 0.0, 1.0)
    }

    /// From where to where any of the run's rays can meet the solid at the height that this one has there.
    pub(super) fn reach(&self, path: &Path) -> (f32, f32) {
        // Others come to a height later or earlier.
        let apart = if self.drift > 0.0 { self.end as f32 * self.drift * path.per_dz.abs() } else { 0.0 };
        let (near, far) = path.slab(self.low, self.high);
        (greater(-self.span - apart, near), lesser(self.span + apart, far))
    }

    /// Looks for roots in the segment of that number, if there is one.
    #[inline(always)]
    pub(super) fn enter(&mut self, index: usize) -> bool {
        let Some(segment) = self.lathe.segments.get(index) else {
            return false;
        };
        (self.index, self.segment) = (index, segment);
        true
    }

    /// The whole profile's bounds.
    pub(super) fn all(&self) -> Cover {
        self.lathe.segments.first().map_or(Cover::NONE, |segment| segment.above)
    }

    /// After the middle and all to the right of it, all to the left of it. Not if that is the mirror image, and all
    /// is done.
    pub fn turn(&mut self) -> bool {
        if self.is_mirrored || self.is_turned {
            return false;
        }
        self.rays = self.rays.turned();
        (self.end, self.is_turned, self.following, self.looked) = (self.left, true, false, u32::MAX);
        true
    }

    /// What the run's rays lie side by side along, if its left half is the mirror image of its right one.
    pub fn mirror(&self) -> Option<F32x3> {
        self.is_mirrored.then_some(self.rays.origin_step)
    }

    /// With nothing to follow: do this pixel and the next ones certainly see nothing, or where may a root be?
    pub fn look(&mut self, i: u32) -> Option<u32> {
        if !self.is_usable || self.looked == i {
            return None;
        }
        self.looked = i;
        let next = self.clear_until(i);
        (next > i || self.following).then_some(next)
    }

    /// There is a root near s in that segment to follow from the next pixel asked for on.
    pub(super) fn begin(&mut self, index: usize, s: f32, sign: f32) {
        (self.sign, self.s, self.step, self.bend, self.tries) = (sign, s, 0.0, 0.0, STEPS);
        (self.index, self.first.until, self.following) = (index, 0, self.is_usable);
    }

    /// A ray gone alone meets the lathe here: there the next one's root is looked for.
    pub fn found(&mut self, hit: &Hit) {
        if hit.part == Part::Wall {
            let s = hit.t / self.per_unit - self.shift;
            self.begin(hit.segment, s, if hit.enters { 1.0 } else { -1.0 });
        }
    }
}
