//! Neighbouring rays, one after another: where one meets the wall is where the next one is looked for.
//!
//! In the lathe's frame the rays of a row are `P = M + s·D`, M and D linear in the pixel's number i, with s
//! counted from where the row passes the solid. Pixels are counted from the one whose ray passes nearest to the axis:
//! from there to the right, and then, [turned](Sweep::turn), to the left. So past a silhouette the rays part from the
//! solid, and one look tells that the rest sees nothing. A pixel is one of four things, the cheapest asked first:
//!
//! - **A root, followed** from the last pixel's by Newton's method, one step mostly (`follow.rs`), and
//!   certified to be the ray's first (`first.rs`).
//! - **One that sees a cap**, through which its ray comes in (`cap.rs`).
//! - **One of a run of misses**, certified together ([`Sweep::look`], `clear.rs`).
//! - **Nothing certain**: within `doubt` of a silhouette, a rim or a cap. Its ray goes alone, as any other.

use super::certify::First;
use super::ray_row::RayRow;
use super::track::STEPS;
use crate::hit::{Hit, Part};
use crate::lathe::frame::View;
use crate::lathe::ray::LocalRay;
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::vector::F32x3;

/// A run of rays at a lathe, and the root that is followed along it.
pub(crate) struct Sweep<'a> {
    pub(super) lathe: View<'a>,
    /// Whether none of the rays comes near the solid.
    pub is_far: bool,
    /// Not if the rays spread too wide, or begin too near the solid, for what they share to be of use.
    pub(super) is_usable: bool,
    /// Not if another solid may be nearer, either.
    pub(super) may_follow: bool,
    /// M and D, in the frame, x scaled by √k, counted from half a pixel before the first one.
    pub(super) rays: RayRow,
    /// Where s = 0 is on the rays; a distance along them, times `unit`, is counted in s.
    pub(super) shift: f32,
    pub(super) unit: f32,
    /// The column that pixels are counted from: to the right from here on, or, turned, to the left from the one before.
    pub middle: u32,
    pub is_turned: bool,
    /// How many pixels there are this way, and how many to the left.
    pub end: u32,
    pub(super) left: u32,
    /// Whether the left half is the mirror image of the right one.
    pub(super) is_mirrored: bool,
    /// Every point of the solid on every ray of the run has |s| ≤ span.
    pub(super) span: f32,
    /// From where to where in height rays of the run can meet the solid.
    pub(super) low: f32,
    pub(super) high: f32,
    /// The largest |dz| of any ray of the run.
    pub(super) steep: f32,
    /// Where the profile bulges no more than this g is concave along all of them: the least q/dz².
    pub(super) bulge: f32,
    /// Whether they rise, or fall; neither, if some do either, or nothing may be followed.
    pub(super) rising: Option<bool>,
    /// The largest |∂z/∂i| within the span, in four spans.
    pub(super) drift: f32,
    /// What lies nearer than this to a decision, in g or in z, is not decided here.
    pub(super) doubt: f32,
    /// The slope that a root must have: behind it g comes to more than doubt, A² > 4·q·doubt, if nothing bends it more than
    /// q; and there is one where a step leaves off, whatever bends it.
    pub(super) slack: f32,
    /// A step d leaves an error of `d²·|g″/2|/slope`: at most 2⁻¹⁹, if `d²` is no more than this times the slope.
    pub(super) tolerance: f32,

    /// Whether there is a root to follow, and whether it enters the solid, 1, or leaves it, −1.
    pub(super) following: bool,
    pub(super) sign: f32,
    /// Where it is looked for at the next pixel, how far it moved at the last one, and how much farther than
    /// before: in s, or, if it leaves, in −s, along the ray turned round.
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
    /// The root last looked for, if there may be one: segment, place and sign.
    pub(super) entry: Option<(usize, f32, f32)>,
}

impl Sweep<'_> {
    /// M and D of the i-th ray.
    pub(super) fn ray(&self, i: u32) -> (F32x3, F32x3) {
        self.rays.at(i as f32 + 0.5)
    }

    /// A ray of it.
    pub(super) fn path(&self, (point, direction): (F32x3, F32x3)) -> LocalRay {
        LocalRay::through(point, direction)
    }

    /// From where to where rays can meet the solid at the height that this one has there: it itself, and as many more
    /// as [`Sweep::pixels`] reckons with, which come to a height up to four spans earlier or later.
    pub(super) fn reach(&self, path: &LocalRay) -> (f32, f32) {
        let span = 5.0 * self.span;
        let (near, far) = path.slab(self.low, self.high);
        (greater(-span, near), lesser(span, far))
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

    /// From now on nothing but that a ray misses is told here.
    pub fn share(&mut self) {
        (self.may_follow, self.is_mirrored, self.rising) = (false, false, None);
    }

    /// After the right half, the left one. Not if that is the mirror image, or if this was it.
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

    /// With nothing to follow, the next pixel to ask for: this one again, if now there is, or the first that may see
    /// something. None if this one's ray has to go alone.
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
        (self.sign, self.s, self.step, self.bend, self.tries) = (sign, sign * s, 0.0, 0.0, STEPS);
        (self.index, self.first.until, self.following) = (index, 0, self.may_follow);
    }

    /// A ray gone alone meets the lathe here: there the next one's root is looked for.
    pub fn found(&mut self, hit: &Hit) {
        if hit.part == Part::Wall {
            let s = hit.t * self.unit - self.shift;
            self.begin(hit.segment, s, if hit.enters { 1.0 } else { -1.0 });
        }
    }
}
