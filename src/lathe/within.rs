//! Whether one lathe lies within another about the same axis, and where the two end. All is in lengths of
//! object space; heights count from the middle, which both lathes have in common.

use super::Lathe;
use super::segment::Segment;
use crate::math::minmax::{greater, lesser};

/// Where a lathe ends: a height, the squared radius of the wall there, and that within which a ray beyond
/// the end counts as inside (see [`EndPlane`](super::frame::EndPlane)).
pub(crate) struct Rim {
    pub z: f32,
    pub wall: f32,
    pub beyond: f32,
}

impl Lathe {
    /// The upper end, or the lower one.
    pub(crate) const fn rim(&self, is_upper: bool) -> Rim {
        let (frame, scale) = (&self.frame, self.frame.scale);
        let (z, end) = if is_upper { (frame.high, &frame.top) } else { (frame.low, &frame.base) };
        Rim { z: z / scale, wall: end.wall / (scale * scale), beyond: end.beyond / (scale * scale) }
    }

    /// 2⁻¹² of the length that is 1 in the frame. In a row of pixels, roots nearer to an end than this are
    /// found by single rays.
    pub(crate) const fn clearance(&self) -> f32 {
        1.0 / (4096.0 * self.frame.scale)
    }

    /// Whether this lathe is certain to be narrower than `outer` at every height at which both have a wall:
    /// in squared radius by 2⁻¹² of what is 1 in the frame of `outer`, which is far more than what rounding
    /// does to either. At the lower end, and at the upper one, both walls may have one radius if `edges` says
    /// so. Then the difference grows from there by 2⁻⁶ for each 1 of height: at the clearance from the edge it
    /// is 2⁻¹⁸, still more than what rounding does.
    ///
    /// Where a segment of one shares heights with a segment of the other, the difference of their squared
    /// radii is a cubic. It is no less than the least of its Bernstein ordinates there. If the first of them
    /// is zero, the cubic's slope there is three times the second, divided by the height that is shared.
    pub(crate) const fn is_within(&self, outer: &Lathe, edges: [bool; 2]) -> bool {
        // In spare capacity are segments that share no heights with any.
        let mut segments: &[Segment] = &self.segments;
        while let [own, rest @ ..] = segments {
            let mut others: &[Segment] = &outer.segments;
            while let [other, rest @ ..] = others {
                if !self.clears(own, outer, other, edges) {
                    return false;
                }
                others = rest;
            }
            segments = rest;
        }
        true
    }

    /// Whether what [`Lathe::is_within`] asks for holds at the heights that the segment `own` of this lathe
    /// shares with the segment `other` of `outer`. If they share no height, it does.
    const fn clears(&self, own: &Segment, outer: &Lathe, other: &Segment, edges: [bool; 2]) -> bool {
        let (scale, outer_scale) = (self.frame.scale, outer.frame.scale);
        let from = greater(own.low / scale, other.low / outer_scale);
        let to = lesser(own.high / scale, other.high / outer_scale);
        if from > to {
            return true;
        }
        let least = outer.clearance() / outer_scale;
        let beside_edge = 64.0 * least * greater(1.0, (to - from) * outer_scale);
        let mut clear = [least; 4];
        if edges[0] && from == self.rim(false).z {
            (clear[0], clear[1]) = (f32::NEG_INFINITY, beside_edge);
        }
        if edges[1] && to == self.rim(true).z {
            (clear[3], clear[2]) = (f32::NEG_INFINITY, beside_edge);
        }
        let inner = own.between(from * scale, to * scale);
        let outer = other.between(from * outer_scale, to * outer_scale);
        let mut i = 0;
        while i < 4 {
            if !(outer[i] / (outer_scale * outer_scale) - inner[i] / (scale * scale) > clear[i]) {
                return false;
            }
            i += 1;
        }
        true
    }
}

impl Segment {
    /// The Bernstein ordinates of the squared radius over the part of the segment between two heights of the
    /// frame: the values of its polar form at the two.
    const fn between(&self, from: f32, to: f32) -> [f32; 4] {
        let (u, v) = ((from - self.low) * self.per_height, (to - self.low) * self.per_height);
        [self.polar([u, u, u]), self.polar([u, u, v]), self.polar([u, v, v]), self.polar([v, v, v])]
    }

    /// The polar form of the squared radius, by de Casteljau's interpolations, each at a parameter of its own.
    const fn polar(&self, [u, v, w]: [f32; 3]) -> f32 {
        let [b0, b1, b2, b3] = self.b;
        let (c0, c1, c2) = (b0 + (b1 - b0) * u, b1 + (b2 - b1) * u, b2 + (b3 - b2) * u);
        let (d0, d1) = (c0 + (c1 - c0) * v, c1 + (c2 - c1) * v);
        d0 + (d1 - d0) * w
    }
}
