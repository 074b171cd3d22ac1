use super::local_ray::LocalRay;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::solve::Crossings;

/// What of a ray lies in one segment's slab, and g along it.
pub(super) struct Chord<'a> {
    path: &'a LocalRay,
    segment: &'a Segment,
    index: usize,
    /// Where on the path s = 0.
    origin: f32,
    /// g over s.
    g: Cubic,
    /// The chord's ends, in s.
    from: f32,
    to: f32,
}

impl<'a> Chord<'a> {
    /// The chord between two of the path's t, unless all of it lies outside the segment's cylinder, and the ray where it
    /// begins: if it is inside, it has left the solid there by less than rounding, and the crossing is still to be found.
    ///
    /// g is reckoned about the point nearest to the axis, where x² + y² is least, unless f and x² + y² are less
    /// where the segment is narrowest, as they can be for a steep ray: so that by a pole or in a narrow neck
    /// the coefficients are as small as the solid is there.
    #[inline(always)]
    pub fn new(
        path: &'a LocalRay,
        segment: &'a Segment,
        index: usize,
        [from, to]: [f32; 2],
        inside: bool,
    ) -> Option<Self> {
        let mut origin = path.closest(from, to);
        let square = path.around(origin).0;
        if square > segment.reach && !inside {
            return None;
        }
        let mut g = path.g_about(segment, origin);
        let f = g.c[0] + square;
        let narrow = lesser(to, greater(from, path.plane(segment.narrowest)));
        let square = path.around(narrow).0;
        if square - path.square < f {
            let there = path.g_about(segment, narrow);
            if there.c[0] + square + (square - path.square) < f {
                (origin, g) = (narrow, there);
            }
        }
        Some(Self { path, segment, index, origin, g, from: from - origin, to: to - origin })
    }

    /// Where g crosses zero along the chord, given the side that the ray begins on.
    #[inline(always)]
    pub fn crossings(&self, inside: bool) -> Crossings<'_> {
        Crossings::new(&self.g, self.from, self.to, inside)
    }

    #[inline]
    pub fn hit(&self, s: f32, enters: bool) -> Hit {
        let t = self.origin + s;
        Hit {
            t: self.path.distance(t),
            segment: self.index,
            u: self.segment.parameter(self.path.height(t)),
            enters,
            part: Part::Wall,
        }
    }
}
