//! The traversal of a row: neighbouring rays, one after another; what one ray meets is the first guess for
//! the next.
//!
//! In the lathe's frame the rays of a row are `P = M + s·D`. M and D are linear in the pixel's number i, and
//! s is zero near the point where the ray passes the solid. Pixel 0 is the one whose ray passes nearest to
//! the axis; from there pixels are counted to the right, and then, for the other half of the row, to the
//! left. So silhouettes are met from within; beyond a silhouette the rays diverge from the solid, and one
//! probe certifies that the rest of the half misses.

use super::bounds::{RowBounds, SegmentBounds};
use super::ray_row::RayRow;
use crate::arithmetic::{Flat, Numbers, Rays};
use crate::lathe::segment::Segment;
use crate::vector::F32x3;
use core::ops::Range;

/// How many Newton steps are tried for a pixel before it becomes a *single ray*; also, one more than how many
/// changes of the segment, the root or its certificate are.
///
/// Count the error of s in units of |dg/ds| divided by |g″/2|. In these units a Newton step squares the
/// error. An error of 1/4 becomes (2⁻²)¹⁶ = 2⁻³² in four steps, below f32's roundoff. A root that takes
/// longer lies beside a double root, in the *undecided band*.
pub(super) const NEWTON_STEPS: u8 = 4;

/// How many pixels a single ray counts for in [`TrackedRoot::spent`]. So where one pixel after another is a
/// single ray, one of this many begins to track the root that it finds.
pub(super) const RETRY: u32 = 4;

/// How many pixels a probe counts for there, and how many a search for a certificate does. So a row in which
/// these serve for less than two pixels each gives up. The value is a choice.
pub(super) const WORK: u32 = 2;

/// How far ahead of the row's pixels [`TrackedRoot::spent`] may be. The value is a choice: it is that of
/// ten single rays, more than there are at a silhouette.
const PATIENCE: u32 = 40;

/// Neighbouring pixels that are computed in the same way. The span begins with the i-th pixel, the one that
/// [`Sweep::next`] was asked for; `to` is the pixel after the last one.
pub(crate) enum Span {
    /// A root is tracked. [`Sweep::track`] hands over what these pixels see; it may end before `to`.
    Tracked { to: u32 },
    /// A cap or a ring is seen where [`Sweep::passes`] says so: by the i-th pixel, and by those up to `to` or
    /// to the first that does not.
    Flat { to: u32 },
    /// The rays miss the solid. `to` may be more than [`Sweep::len`].
    Empty { to: u32 },
    /// The row is undecided: a ray of its own is to be cast for the i-th pixel alone, and a hit to be
    /// reported with [`Sweep::found`].
    Single,
}

/// What converts a row's s to the t of a ray: the shift of [`RowBounds`], and one over its unit.
#[derive(Clone, Copy, Default)]
pub(crate) struct Scale {
    shift: f32,
    per_unit: f32,
}

impl Scale {
    /// The t that belongs to a given s.
    #[inline(always)]
    pub fn distance(self, s: f32) -> f32 {
        (s + self.shift) * self.per_unit
    }
}

/// One half of a row of rays at a lathe, then the other: what is known of all rays, which way pixels are
/// counted, and the root that is tracked from ray to ray.
pub(crate) struct Sweep<'a> {
    pub(super) bounds: RowBounds<'a>,
    pub(super) direction: Direction,
    pub(super) root: TrackedRoot<'a>,
    /// The cap or the ring that is seen.
    pub(super) flat: Flat,
}

/// Which way pixels are counted: changed by [`Sweep::reverse`] alone.
pub(super) struct Direction {
    /// M and D of the rays, in the frame. Ray 0 of these passes through the left edge of the right half's
    /// first pixel, or, if pixels are counted to the left, through the right edge of the left half's first,
    /// which is the same edge. So the ray of pixel i is ray i + ½.
    pub rays: RayRow,
    /// The same rays in the row's arithmetic.
    pub numbers: Rays,
    /// Whether pixels are counted to the left.
    pub is_reversed: bool,
    /// The number of pixels this way.
    pub len: u32,
}

/// The root that is tracked, if one is, and what the search for one has come to.
pub(super) struct TrackedRoot<'a> {
    /// Whether a root is tracked.
    pub is_tracked: bool,
    /// 1 if the ray enters the solid at the root, −1 if it leaves it. A root where the ray leaves is tracked
    /// as one where the reversed ray enters: its s has the other sign there. Of a cap or a ring that is seen
    /// this says whether the ray enters the solid there.
    pub sign: f32,
    /// `sign·s` as predicted for the next pixel; its last change from pixel to pixel; and the last change of
    /// that: the bits of numbers of the row's arithmetic.
    pub motion: [u32; 3],
    /// The segment that the root is in, as an index and by reference. After [`TrackedRoot::begin`] only
    /// `index` is right, until [`Sweep::next`] has looked the segment up.
    pub index: usize,
    pub segment: &'a Segment,
    /// The bounds of that segment.
    pub own: SegmentBounds,
    /// Why it is the nearest.
    pub certificate: Certificate,
    /// Why tracking ended, until [`Sweep::next`] has seen to it.
    pub end: Option<TrackEnd>,
    /// One more than how often the segment, the root or its certificate may still be changed before a pixel's
    /// root is found. Each change takes one from it; where it comes to zero, tracking ends instead. When a
    /// pixel's root has been found, it is [`NEWTON_STEPS`] again.
    pub tries: u8,
    /// The pixel that is not to be probed, because that has been done or would find no more; `u32::MAX` if
    /// there is none.
    pub probed: u32,
    /// [`RETRY`] pixels for each single ray of this half of the row, and [`WORK`] for each probe and for each
    /// search for a certificate. Where this is far ahead of the pixel that the row is at, they serve for too
    /// few pixels: at a wall as low as a ring, for example, or along steep rays at many segments.
    pub spent: u32,
    /// The number of the knot on whose plane the next pixels may see a cap or a ring; `usize::MAX` if there
    /// is none.
    pub plane: usize,
    /// What the last probe that could not certify a miss said about where the surface may be.
    pub start: Option<Start>,
}

/// Why tracking ended at a pixel.
#[derive(Clone, Copy)]
pub(super) enum TrackEnd {
    /// [`Sweep::track`] has come to the pixel `to` that it was given, or the root has no certificate for the
    /// pixel.
    Limit,
    /// The root at this pixel is not certain to be its ray's nearest.
    Uncertified,
    /// The root has left the segment: through its upper end, if `upper`, or through its lower end.
    Left { upper: bool },
    /// Newton's method finds no root.
    Diverged,
}

/// Why a tracked root is its ray's nearest: a test of the slope at each pixel, a second one where that fails,
/// and how long they hold.
pub(super) struct Certificate {
    /// The root is the nearest if the slope of g at it is more than this.
    pub certain: f32,
    /// The same for a root that lies behind the point where the rays begin by more than the tolerance divided
    /// by the slope.
    pub slope: f32,
    /// For the second test, [`Sweep::is_nearest_at`]: |f3| of the root's own segment, or zero if the slope of
    /// g alone proves that g keeps its sign in that segment. NaN if that test does not apply, because the
    /// certificate is how fast the ray approaches the axis.
    pub bump: f32,
    /// The first pixel for which the certificate does not hold.
    pub until: u32,
}

/// Where a ray may meet the surface: where tracking may begin, or the plane of a cap or a ring.
#[derive(Clone, Copy)]
pub(super) struct Start {
    /// The index of the segment that the root would be in; for a plane, the number of its knot.
    pub index: usize,
    /// About where the root is along the ray.
    pub s: f32,
    /// 1 if the ray enters the solid at the root, −1 if it leaves it. Zero for a plane.
    pub sign: f32,
}

impl<'a> TrackedRoot<'a> {
    /// No root is tracked.
    pub fn none() -> Self {
        Self {
            is_tracked: false,
            sign: 1.0,
            motion: [0; 3],
            index: 0,
            // No segment of a lathe, so that the bounds of the first one will be computed.
            segment: &Segment::EMPTY,
            // These numbers are not zero, because the compiler would write a longer run of zeros by a call of
            // `memclr`, a function that the crate links for no other purpose.
            own: SegmentBounds { tolerance: f32::INFINITY, slack: f32::INFINITY, newton_tolerance: 0.0 },
            certificate: Certificate {
                certain: f32::INFINITY,
                slope: f32::INFINITY,
                bump: 0.0,
                until: u32::MAX,
            },
            end: None,
            tries: NEWTON_STEPS,
            probed: u32::MAX,
            spent: 0,
            plane: usize::MAX,
            start: None,
        }
    }

    /// Whether the pixels before the i-th took too much: then the i-th gets a single ray, and a root that it
    /// finds is not tracked.
    pub fn is_spent(&self, i: u32) -> bool {
        self.spent > i.wrapping_add(PATIENCE)
    }

    /// Counts some pixels more in [`TrackedRoot::spent`].
    #[inline(always)]
    pub fn spend(&mut self, pixels: u32) {
        self.spent = self.spent.wrapping_add(pixels);
    }

    /// Begins to track a root near a place. It has no certificate yet: that of the last root is ended. If the
    /// place is a plane, this ends tracking, and makes the plane the next one to be looked at. `numbers` are
    /// those of the row.
    pub fn begin(&mut self, numbers: Numbers, Start { index, s, sign }: Start) {
        (self.sign, self.motion) = (sign, [numbers.bits(sign * s), 0, 0]);
        (self.index, self.certificate.until, self.is_tracked) = (index, 0, sign != 0.0);
        if !self.is_tracked {
            self.plane = index;
        }
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

    /// The columns of some pixels if they are counted to the right.
    #[inline(always)]
    pub fn right_columns(&self, pixels: Range<u32>) -> Range<u32> {
        self.bounds.middle + pixels.start..self.bounds.middle + pixels.end
    }

    /// The columns of some pixels if they are counted to the left, from left to right.
    #[inline(always)]
    pub fn left_columns(&self, pixels: Range<u32>) -> Range<u32> {
        self.bounds.middle - pixels.end..self.bounds.middle - pixels.start
    }

    /// The column of the i-th pixel's mirror image, where the row has one.
    #[inline(always)]
    pub fn mirrored_column(&self, i: u32) -> u32 {
        self.bounds.middle - 1 - i
    }

    /// Whether distances are compared with those of other solids.
    #[inline(always)]
    pub fn has_depth(&self) -> bool {
        self.bounds.least_slope > 0.0
    }

    /// Whether the rays of the last [`Span::Tracked`] or [`Span::Flat`] enter the solid where they meet it.
    #[inline(always)]
    pub fn enters(&self) -> bool {
        self.root.sign > 0.0
    }

    /// The conversion of s to the t of a ray.
    #[inline(always)]
    pub fn scale(&self) -> Scale {
        Scale { shift: self.bounds.shift, per_unit: 1.0 / self.bounds.unit }
    }

    /// A bound of the difference, in t, between the distances that the sweep finds and those that single rays
    /// find.
    pub fn depth_error(&self) -> f32 {
        self.bounds.depth_error()
    }

    /// A normal, in object space, of the plane in which the left half of the row is the mirror image of the
    /// right half. `None` if the left half is not known to be a mirror image. Where it is, only the right
    /// half is swept.
    pub fn mirror(&self) -> Option<F32x3> {
        self.bounds.is_mirrored.then_some(self.direction.rays.right)
    }

    /// Turns to the left half of the row, where pixels are counted to the left, with no root tracked, and
    /// returns true. Returns false and changes nothing if the left half is the mirror image of the right one,
    /// or if this has been done before.
    pub fn reverse(&mut self) -> bool {
        let Self { bounds, direction, root, .. } = self;
        if bounds.is_mirrored || direction.is_reversed {
            return false;
        }
        direction.rays.reverse();
        direction.numbers.reverse();
        (direction.is_reversed, direction.len) = (true, bounds.left);
        (root.is_tracked, root.end, root.probed, root.plane) = (false, None, u32::MAX, usize::MAX);
        root.spent = 0;
        true
    }

    /// M and D of the i-th ray.
    #[inline]
    pub(super) fn ray(&self, i: u32) -> (F32x3, F32x3) {
        self.direction.rays.at(i as f32 + 0.5)
    }
}
