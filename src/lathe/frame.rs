//! What the segments of a lathe have in common, and a lathe seen whatever its number of segments.

use super::segment::Segment;
use crate::hit::Part;
use crate::vector::{F32x3, vector};

/// Doubt is this times `(2 + S)·(BASE_DISTANCE·size + |back|·(q + dz²))`, S the profile's max_slope: sixteen units of 2⁻²⁴.
///
/// Rounding puts the square of the distance from the axis off by 23·r² units at most, r the radius, and 4·|back|·√q; the
/// squared radius by 10·r² + 4.5·S·size, and by S times what the height is off by, 9·size + 3·r·|dz|/√q + 11·|back·dz|.
/// On an end's plane the former is off by what the height is, times |2·q·away/dz|, more: there doubt is 1 + |q·away/dz| times
/// as large.
/// Where K is below zero, |dz|/√q is below 8; where q is no less than 1/4, √q is at most 2·(q + dz²), |dz| at most q + dz².
pub const LENGTH_TOLERANCE: f32 = 16.0 / 16_777_216.0;
/// How many times the solid's size.
pub const BASE_DISTANCE: f32 = 2.5;

/// The least that `convexity` is taken for.
pub const LEAST_CONVEXITY: f32 = 1.0 / 64.0;

/// What the segments of a lathe have in common.
///
/// Its own frame is object space moved so that the origin is half way up, and scaled.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Frame {
    /// How many segments there are.
    pub len: usize,
    pub squash: f32,
    pub root_squash: f32,
    /// A power of two: lengths in the frame are lengths in object space times it. It brings the largest
    /// squared radius into [1, 4).
    pub scale: f32,
    /// The height in object space of the frame's origin.
    pub middle: f32,
    /// The lowest and the highest height, in the frame.
    pub low: f32,
    pub high: f32,
    /// The square of the bounding cylinder's radius, in the frame.
    pub bounding_square: f32,
    /// The radius of a ball around all of it.
    pub size: f32,
    /// Half its height, and the radius of a cylinder around it, infinite around a sheet, in object space.
    pub half_height: f32,
    pub radius: f32,
    /// Bounds on the first derivative of the squared radius by height, and on half the second.
    pub max_slope: f32,
    pub curvature: f32,
    /// Half the largest second derivative, or `LEAST_CONVEXITY` if that is more, and half the sum of all jumps upwards of the
    /// first, at joins.
    pub convexity: f32,
    pub half_slope_jumps: f32,
    /// The lower end's plane, and the upper one's.
    pub base: EndPlane,
    pub top: EndPlane,
    /// Whether there are steps between segments, or rings at the ends.
    pub has_rings: bool,
    /// Whether g may jump upwards between the ends, or on their planes from without: the fast path certifies no hits then.
    pub has_jumps: bool,
    /// A power of two, no less than half of `len`: the first step of a search.
    pub stride: usize,
    /// √k·scale: a ray's moment about the axis, in object space, times this is that in the frame.
    pub moment_scale: f32,
    /// What rounding can do to g at a unit's distance, and how much more doubt there is at least: see `glance.rs`.
    pub g_tolerance: f32,
    pub base_distance: f32,
}

/// The plane of an end, in the frame.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct EndPlane {
    /// What part of the surface the ring is between the two radii: nothing if the end is open, and the wall itself where that
    /// closes to a point.
    pub part: Option<Part>,
    /// The squared radii of the wall, and of what goes on beyond it: the same if the end is open, zero if it is capped.
    pub wall: f32,
    pub beyond: f32,
}

impl EndPlane {
    /// Of the part given, if it is not open, nor a point.
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

    /// The square of the cap's radius: zero if there is none.
    pub const fn cap(&self) -> f32 {
        if self.beyond == 0.0 { self.wall } else { 0.0 }
    }

    /// Whether a part of the end is closed, and a part is open.
    pub const fn is_ring(&self) -> bool {
        self.wall != self.beyond && self.beyond != 0.0
    }

    /// By how much it is wider beyond.
    pub const fn flange(&self) -> f32 {
        (self.beyond - self.wall).max(0.0)
    }
}

impl Frame {
    /// A point of object space, before x is scaled by √k.
    #[inline(always)]
    pub fn point(&self, p: F32x3) -> F32x3 {
        (p - vector([0.0, 0.0, self.middle])) * self.scale
    }

    /// x scaled by √k: there every lathe is round.
    #[inline(always)]
    pub fn squashed(&self, v: F32x3) -> F32x3 {
        vector([v.x * self.root_squash, v.y, v.z])
    }
}

/// A lathe whatever its size.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub frame: &'a Frame,
    pub segments: &'a [Segment],
}

impl View<'_> {
    /// The number of the segment at a height, by steps each half of the one before. Spare room lies above any height.
    #[inline]
    pub fn index_at(&self, z: f32) -> usize {
        let (mut index, mut stride) = (0, self.frame.stride);
        loop {
            if self.segments.get(index + stride).is_some_and(|segment| segment.low <= z) {
                index += stride;
            }
            stride /= 2;
            if stride == 0 {
                return index;
            }
        }
    }
    /// The number of the segment at a height, by steps from one that is near. Beyond the ends of the solid, a number that
    /// no segment has.
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
