//! The traversal of a row: neighbouring rays, one after another, each looked at in the light of what the last
//! one met.
//!
//! In the lathe's frame the rays of a row are `P = M + s·D`, M and D linear in the pixel's number i, with s
//! counted from where the row passes the solid. Pixels are counted from the one whose ray passes nearest to
//! the axis, 0, to the right, and, in the other half of the row, to the left. So silhouettes are met from
//! within; beyond one the rays diverge from the solid, and one probe certifies that the rest of the half
//! misses.

use super::bounds::RowBounds;
use super::ray_row::RayRow;
use crate::lathe::ray::LocalRay;
use crate::lathe::segment::Segment;
use crate::vector::F32x3;

/// How often a step of Newton's method, or a change of segment, is tried before the pixel is cast as a ray of
/// its own.
///
/// Each step squares the error, in units of the slope over the curvature: from a quarter of that, four come
/// below f32's roundoff, (2⁻²)¹⁶ = 2⁻³². What takes longer lies beside a double root, where the row decides
/// nothing anyway.
pub(super) const STEPS: u32 = 4;

/// Neighbouring pixels that are alike. The i-th pixel is the first of each; `to` is the one after the last.
pub(crate) enum Span {
    /// A root is tracked, and, unless tracking ends before, known to be the nearest: to be painted by
    /// [`Sweep::track`].
    Tracked { to: u32 },
    /// A cap is seen: the upper one if `up` is 1, the lower one if it is −1.
    Cap { to: u32, up: f32 },
    /// The solid is missed. `to` may lie beyond the end.
    Empty { to: u32 },
    /// Undecided: the i-th pixel is to be cast as a ray of its own, and a hit to be reported by
    /// [`Sweep::found`].
    Single,
}

/// One half of a row of rays at a lathe, then the other: what is known of all rays, which way pixels are
/// counted, and the root that is tracked from ray to ray.
pub(crate) struct Sweep<'a> {
    pub(super) bounds: RowBounds<'a>,
    pub(super) direction: Direction,
    pub(super) root: TrackedRoot<'a>,
}

/// Which way pixels are counted: changed by [`Sweep::reverse`] alone.
pub(super) struct Direction {
    /// M and D, in the frame, x scaled by √k. Pixel i is at i + ½.
    pub rays: RayRow,
    /// Whether pixels are counted to the left.
    pub is_reversed: bool,
    /// The number of pixels this way.
    pub len: u32,
}

/// The root that is tracked, if one is, and what the search for one has come to.
pub(super) struct TrackedRoot<'a> {
    pub is_tracked: bool,
    /// 1 if the ray enters the solid at the root, −1 if it leaves it. One that leaves is tracked as one that
    /// enters along the ray reversed: `sign·s` is what is kept of it.
    pub sign: f32,
    /// `sign·s` predicted for the next pixel, its last change from pixel to pixel, and the change of that.
    pub s: f32,
    pub step: f32,
    pub bend: f32,
    /// The segment that the root is in. `segment` is that of number `index` once the root has been looked for
    /// there.
    pub index: usize,
    pub segment: &'a Segment,
    /// Why it is the nearest.
    pub certificate: Certificate,
    /// Why tracking ended, until [`Sweep::next`] has seen to it.
    pub end: Option<TrackEnd>,
    /// How many changes of segment or of the root may still be tried before a pixel has to be found.
    pub tries: u32,
    /// A pixel that need not be probed: it was in vain, or would be.
    pub probed: u32,
    /// Where the last probe that could not rule out a root says that it may be.
    pub start: Option<RootStart>,
}

/// Why tracking ended at a pixel.
#[derive(Clone, Copy)]
pub(super) enum TrackEnd {
    /// The limit that was asked for is reached.
    Limit,
    /// The root is not known to be the nearest.
    Uncertified,
    /// The root has left the segment through its upper end.
    LeftUpwards,
    /// Through its lower end.
    LeftDownwards,
    /// Newton's method finds no root.
    Diverged,
}

/// Why a tracked root is its ray's nearest: one of two tests a pixel, and how long both hold.
pub(super) struct Certificate {
    /// The root is the nearest if the slope of g is more than this.
    pub slope: f32,
    /// If it is not, by [`Sweep::is_nearest_by_cubic`], given this: |f₃| of the root's own segment, or zero
    /// if the test would say no more than the slope.
    pub bump: f32,
    /// The first pixel that it does not hold for.
    pub until: u32,
}

/// Where a root may be: where tracking may begin.
#[derive(Clone, Copy)]
pub(super) struct RootStart {
    pub index: usize,
    /// About where it is, along the ray.
    pub s: f32,
    /// Whether the ray enters the solid there, 1, or leaves it, −1.
    pub sign: f32,
}

impl<'a> TrackedRoot<'a> {
    /// No root, in a lathe of which `segment` is any segment.
    pub fn none(segment: &'a Segment) -> Self {
        Self {
            is_tracked: false,
            sign: 1.0,
            s: 0.0,
            step: 0.0,
            bend: 0.0,
            index: 0,
            segment,
            certificate: Certificate { slope: f32::INFINITY, bump: 0.0, until: u32::MAX },
            end: None,
            tries: STEPS,
            probed: u32::MAX,
            start: None,
        }
    }

    /// Begins to track a root near a place, uncertified as yet: no certificate holds for any pixel.
    pub fn begin(&mut self, RootStart { index, s, sign }: RootStart) {
        (self.sign, self.s, self.step, self.bend) = (sign, sign * s, 0.0, 0.0);
        (self.index, self.certificate.until, self.is_tracked) = (index, 0, true);
    }
}

impl Sweep<'_> {
    /// Whether no ray of the row comes near the solid.
    pub fn is_culled(&self) -> bool {
        self.bounds.is_culled
    }

    /// The number of pixels of the half that is being swept.
    #[inline(always)]
    pub fn len(&self) -> u32 {
        self.direction.len
    }

    /// Whether columns fall as pixel numbers grow.
    #[inline(always)]
    pub fn is_reversed(&self) -> bool {
        self.direction.is_reversed
    }

    /// The column of the i-th pixel.
    #[inline(always)]
    pub fn column(&self, i: u32) -> u32 {
        let middle = self.bounds.middle;
        if self.direction.is_reversed { middle - 1 - i } else { middle + i }
    }

    /// The column of the i-th pixel's mirror image, where the row has one.
    #[inline(always)]
    pub fn mirrored_column(&self, i: u32) -> u32 {
        self.bounds.middle - 1 - i
    }

    /// A normal of the plane that reflects the right half of the row into the left one, in object space, if
    /// one does; then the right half tells what both see.
    pub fn mirror(&self) -> Option<F32x3> {
        self.bounds.is_mirrored.then_some(self.direction.rays.origin_step)
    }

    /// Goes over to the left half of the row, counted to the left, with no root tracked. False, and no
    /// change, if it is the right one's mirror image or has been swept.
    pub fn reverse(&mut self) -> bool {
        let Self { bounds, direction, root } = self;
        if bounds.is_mirrored || direction.is_reversed {
            return false;
        }
        *direction = Direction { rays: direction.rays.reversed(), is_reversed: true, len: bounds.left };
        (root.is_tracked, root.end, root.probed) = (false, None, u32::MAX);
        true
    }

    /// The i-th ray, with s for its t. Not inline: three functions call it, and none of them often.
    #[inline(never)]
    pub(super) fn path(&self, (m, d): (F32x3, F32x3)) -> LocalRay {
        LocalRay::through(m, d)
    }

    /// M and D of the i-th ray.
    #[inline(always)]
    pub(super) fn ray(&self, i: u32) -> (F32x3, F32x3) {
        self.direction.rays.at(i as f32 + 0.5)
    }
}
