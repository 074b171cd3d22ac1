//! What the segments of a lathe have in common: the frame, the planes of its ends, and bounds of the whole
//! profile.

use super::segment::{Segment, greater_or_nan};
use crate::hit::Part;
use crate::math::UNIT_ROUNDOFF;
use crate::vector::{F32x3, difference, scale, vector};

/// By how much rounding may change a length or a height at a point of a ray, relative to the sum of the
/// solid's size and the distance of the ray's origin: 16 units of 2⁻²⁴.
///
/// The fast path's tolerance in g is built on it. At a place on a ray, the tolerance in g is
///
/// `LENGTH_TOLERANCE·(2 + S)·(BASE_DISTANCE·size + |back|·(q + dz²))`,
///
/// with S the largest slope of the profile, size as in [`Frame::size`], `back` the distance from the place to
/// the ray's origin in units of the direction, and q = dx² + dy², x scaled by √k.
///
/// Rounding changes, in units of 2⁻²⁴, x² + y² by at most 23·r² + 4·|back|·√q, r the largest radius; f by at
/// most 10·r² + 4.5·S·size; and the height by at most 9·size + 3·r·|dz|/√q + 11·|back·dz|, which changes f by
/// S times that. Here r² ≤ 2·r ≤ 2·size, since r < 2. The fast path leaves a ray undecided unless q exceeds
/// both convexity·dz² and 1/4. So |dz|/√q < 8, by [`LEAST_CONVEXITY`], and √q ≤ 2·q and |dz| ≤ q + dz², by q
/// ≥ 1/4. Then the tolerance is larger than the rounding in each of four groups of terms:
///
/// | terms with the factor | rounding, at most | tolerance |
/// |---|---|---|
/// | 1 | 33·r² ≤ 66·size | 80·size |
/// | S | 13.5·size + 24·r ≤ 37.5·size | 40·size |
/// | \|back\| | 4·√q ≤ 8·(q + dz²) | 32·(q + dz²) |
/// | S·\|back\| | 11·\|dz\| ≤ 11·(q + dz²) | 16·(q + dz²) |
///
/// For the point where the ray passes the plane of an end, at the distance s from its point nearest to the
/// axis, x² + y² has a further error: the error of the height times |2·q·s/dz|. By the bound above, with
/// 3·r·|dz|/√q < 24·r ≤ 24·size, twice the error of the height is at most 66·size + 22·|back|·(q + dz²), less
/// than the tolerance allows for the terms without S. So there the tolerance is multiplied by 1 + |q·s/dz|.
pub const LENGTH_TOLERANCE: f32 = 16.0 * UNIT_ROUNDOFF;

/// The distance that the tolerance allows for even where the ray's origin is near, in units of the size of
/// the solid: see [`LENGTH_TOLERANCE`].
pub const BASE_DISTANCE: f32 = 2.5;

/// The least value of [`Frame::convexity`]. With it, convexity·dz² < q means that dz² < 64·q, which
/// [`LENGTH_TOLERANCE`] takes for granted.
pub const LEAST_CONVEXITY: f32 = 1.0 / 64.0;

/// The lathe's frame, and bounds of the whole lathe. The frame is object space moved along the axis so that
/// the origin is half way up the axis (or half way up that of the first sheet of a body), then scaled by
/// `scale`, then x scaled by √k. [`Frame::point`] does all three. Lengths are in the frame unless a field
/// says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Frame {
    /// How many segments there are.
    pub len: usize,
    /// The squash k.
    pub squash: f32,
    /// √k.
    pub root_squash: f32,
    /// A power of two that brings the largest squared radius into [1, 4). Lengths along y and z in the frame
    /// are those in object space times `scale`; lengths along x, times `scale`·√k.
    pub scale: f32,
    /// The height in object space of the frame's origin.
    pub middle: f32,
    /// The height of the lower end.
    pub low: f32,
    /// The height of the upper end.
    pub high: f32,
    /// The squared radius of the bounding cylinder: the largest squared radius of the profile, widened.
    pub bounding_square: f32,
    /// The radius of a ball about the frame's origin that contains the solid as it is in the frame.
    pub size: f32,
    /// The larger of the distances of the two ends from the frame's origin, in object space.
    pub half_height: f32,
    /// The radius of a cylinder about the axis that contains the solid, in object space. It is infinite for a
    /// sheet (k = 0).
    pub radius: f32,
    /// An upper bound of |F′|, where F is the squared radius by height. NaN or infinite if it, or `curvature`,
    /// is beyond the range of f32.
    pub max_slope: f32,
    /// An upper bound of |F″/2|.
    pub curvature: f32,
    /// An upper bound of F″/2 between knots, at least [`LEAST_CONVEXITY`].
    pub convexity: f32,
    /// Half the sum of all slope jumps, those at steps included.
    pub half_slope_jumps: f32,
    /// The plane of the lower end and that of the upper end.
    pub base: EndPlane,
    pub top: EndPlane,
    /// Whether there are steps between segments, or rings at the ends.
    pub has_rings: bool,
    /// Whether g may jump upwards along a ray: at a step, or at a ring that lies outside the wall of an end
    /// (see [`EndPlane::flange`]). Then the fast path certifies no hits.
    pub has_jumps: bool,
    /// A power of two that is at least half of `len`: the first step of [`View::index_at`].
    pub stride: usize,
    /// √k·scale: the moment of a ray about the axis in object space, times this, is its moment in the frame.
    pub moment_scale: f32,
    /// [`LENGTH_TOLERANCE`]·(2 + max_slope): the tolerance in g is this times the distance
    /// `base_distance + |back|·(q + dz²)`.
    pub g_tolerance: f32,
    /// The part of that distance that is the same for all rays. It is [`BASE_DISTANCE`] times the size, plus
    /// the quotient of the sum of all upward jumps of g and `g_tolerance`. So the tolerance exceeds that sum.
    pub base_distance: f32,
}

/// Bounds of a whole profile.
pub(crate) struct Bounds {
    /// Upper bounds of |F′|, |F″/2| and F″/2 between knots. `max_slope` is NaN or infinite if a segment has
    /// no height in the frame.
    pub max_slope: f32,
    pub curvature: f32,
    pub convexity: f32,
    /// The sum of all slope jumps, those at steps included.
    pub slope_jumps: f32,
    /// The sum of all steps of the squared radius from one segment to the next, upwards or downwards.
    pub steps: f32,
}

impl Bounds {
    /// The bounds of the first `len` segments.
    pub const fn of(segments: &[Segment], len: usize) -> Self {
        let mut all = Self { max_slope: 0.0, curvature: 0.0, convexity: 0.0, slope_jumps: 0.0, steps: 0.0 };
        let mut i = 0;
        while i < len {
            let segment = &segments[i];
            all.max_slope = greater_or_nan(all.max_slope, segment.max_slope);
            all.curvature = greater_or_nan(all.curvature, segment.curvature);
            all.convexity = greater_or_nan(all.convexity, segment.convexity);
            if i + 1 < len {
                all.slope_jumps += segment.slope_jump_to(&segments[i + 1]);
                all.steps += (segments[i + 1].b[0] - segment.b[3]).abs();
            }
            i += 1;
        }
        all
    }
}

/// The plane of an end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct EndPlane {
    /// What lies on the plane between the radii of `wall` and `beyond`: a cap or a ring; `Part::Wall` if the
    /// wall closes to a point; `None` if the end is open.
    pub part: Option<Part>,
    /// The squared radius of the wall at the end: within it a ray on the solid's side of the plane is inside.
    pub wall: f32,
    /// The squared radius within which a ray on the other side of the plane counts as inside. It is equal to
    /// `wall` if the end is open, and zero if the end is capped. Else a ring lies between the two radii:
    /// within the wall if `beyond` is smaller than `wall`, around it if `beyond` is larger.
    pub beyond: f32,
}

impl EndPlane {
    /// The plane of an end with these squared radii. `part` is what lies between them, if they differ.
    pub const fn new(wall: f32, beyond: f32, part: Part) -> Self {
        let part = if wall != beyond {
            Some(part)
        } else if wall == 0.0 {
            Some(Part::Wall)
        } else {
            None
        };
        Self { part, wall, beyond }
    }

    /// Whether there is a ring, within the wall or around it. A cap is no ring.
    pub const fn is_ring(&self) -> bool {
        self.wall != self.beyond && self.beyond != 0.0
    }

    /// By how much `beyond` is larger than `wall`; zero if it is not larger.
    pub const fn flange(&self) -> f32 {
        (self.beyond - self.wall).max(0.0)
    }
}

impl Frame {
    /// A point of object space in the frame: moved, scaled, and x scaled by √k.
    #[inline(always)]
    pub const fn point(&self, p: F32x3) -> F32x3 {
        self.squashed(scale(difference(p, vector([0.0, 0.0, self.middle])), self.scale))
    }

    /// A vector with x scaled by √k. It is all that a ray's direction needs, whose length is not scaled: its
    /// t is multiplied by `scale` instead.
    #[inline(always)]
    pub const fn squashed(&self, v: F32x3) -> F32x3 {
        vector([v.x * self.root_squash, v.y, v.z])
    }
}

/// A borrowed lathe of any number of segments.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub frame: &'a Frame,
    pub segments: &'a [Segment],
}

/// The plane of a knot: that between two segments, or that of an end.
pub(crate) struct KnotPlane {
    pub z: f32,
    /// The squared radii just below the plane and just above it: at an end, one is that of the wall, the
    /// other [`EndPlane::beyond`]. A flat part, a cap or a ring, lies between them if they differ.
    pub below: f32,
    pub above: f32,
}

impl View<'_> {
    /// The plane of the knot of a number: 0 is the lower end's, `len` the upper end's. `None` if there is no
    /// such knot.
    #[inline(never)]
    pub fn plane(&self, number: usize) -> Option<KnotPlane> {
        let View { frame, segments } = *self;
        let (lower, upper) = (segments.get(number.wrapping_sub(1)), segments.get(number));
        (number <= frame.len).then(|| KnotPlane {
            z: upper.map_or(frame.high, |segment| segment.low),
            below: lower.map_or(frame.base.beyond, |segment| segment.end(true)),
            above: upper.map_or(frame.top.beyond, |segment| segment.end(false)),
        })
    }

    /// Whether a height differs by less than `margin` from that of an end, or, if there are steps, of any
    /// knot.
    #[inline]
    pub fn is_near_edge(&self, z: f32, margin: f32) -> bool {
        let View { frame, segments } = *self;
        let is_near = |edge: f32| (z - edge).abs() < margin;
        is_near(frame.low)
            || is_near(frame.high)
            || frame.has_rings && segments.iter().any(|segment| is_near(segment.low))
    }

    /// The number of the last segment whose lower end is at the height or below, or 0 if there is none, by
    /// binary search: each step is half the one before. Spare segments begin at +∞ and are never returned.
    #[inline]
    pub fn index_at(&self, z: f32) -> usize {
        self.last_index(|low| low <= z)
    }

    /// The number of the highest segment of which `is_below` is true, given the height at which the segment
    /// begins; 0 if there is none. If `is_below` is true of a height, it must be true of all lower ones.
    #[inline(always)]
    pub fn last_index(&self, is_below: impl Fn(f32) -> bool) -> usize {
        let (mut index, mut stride) = (0, self.frame.stride);
        loop {
            if self.segments.get(index + stride).is_some_and(|segment| is_below(segment.low)) {
                index += stride;
            }
            stride /= 2;
            if stride == 0 {
                return index;
            }
        }
    }

    /// The number of the segment at a height, found by single steps from segment `index`. It is `usize::MAX`
    /// for a height below the solid, at least `len` for one above, and `index` itself if z is NaN.
    #[inline(always)]
    pub fn index_from(&self, mut index: usize, z: f32) -> usize {
        while self.segments.get(index).is_some_and(|segment| z < segment.low) {
            index = index.wrapping_sub(1);
        }
        while self.segments.get(index).is_some_and(|segment| segment.high < z) {
            index += 1;
        }
        index
    }
}
