use super::local_ray::LocalRay;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::lathe::segment::Segment;
use crate::math::UNIT_ROUNDOFF;
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
    /// The chord between two of the ray's t.
    ///
    /// g is formed about the point nearest to the axis, where x² + y² is least, unless f and x² + y² are less where the segment
    /// is narrowest, as they can be for a steep ray: so that by a pole or in a narrow neck the coefficients are as small as the
    /// solid is there.
    #[inline(always)]
    pub fn new(path: &'a LocalRay, segment: &'a Segment, index: usize, [from, to]: [f32; 2]) -> Self {
        let mut origin = path.closest(from, to);
        let mut g = path.g_about(segment, origin);
        let f = g.c[0] + path.around(origin).0;
        let narrow = lesser(to, greater(from, path.plane(segment.narrowest)));
        let square = path.around(narrow).0;
        if square - path.square < f {
            let there = path.g_about(segment, narrow);
            if there.c[0] + square + (square - path.square) < f {
                (origin, g) = (narrow, there);
            }
        }
        Self { path, segment, index, origin, g, from: from - origin, to: to - origin }
    }

    /// Where g crosses zero along the chord, given the sides that the ray is on where it begins and where it ends.
    #[inline(always)]
    pub fn crossings(&self, inside: bool, ends_inside: bool) -> Crossings<'_> {
        Crossings::between(&self.g, [self.from, self.to], [inside, ends_inside])
    }

    /// The hit at a root of g.
    #[inline]
    pub fn hit(&self, s: f32, enters: bool) -> Hit {
        let ends = [self.origin + self.from, self.origin + self.to];
        let t = refined(self.path, self.segment, self.origin + s, ends);
        Hit {
            t: self.path.distance(t),
            segment: self.index,
            u: self.segment.parameter(self.path.height(t)),
            enters,
            part: Part::Wall,
        }
    }
}

/// The root of a parabola that all but touches zero is half as far after each step: from 2⁻¹² of the chord, where a double root
/// may be misplaced by the root of 2⁻²⁴, to 2⁻²⁴.
const MOST_STEPS: u32 = 12;

/// The place of a root between two of the ray's t, found anew from near it.
///
/// Far from where g is formed it is known to a few units of 2⁻²⁴ of all its terms there; formed about the root it is
/// known to those of f and x² + y². Newton's steps take that in: one, or two, but where a segment comes to a point that is
/// blunt only from very near. There the root is all but double, and each step halves what is left. A step of four units of
/// 2⁻²⁴, of t or of the frame's unit, no more than the largest radius, is the last.
#[inline(never)]
fn refined(path: &LocalRay, segment: &Segment, mut t: f32, [from, to]: [f32; 2]) -> f32 {
    for _ in 0..MOST_STEPS {
        let [c0, c1, c2, _] = path.g_about(segment, t).c;
        // Otherwise g's parabola has no root that way, or one nearer than half a step.
        if !(4.0 * (c0 * c2).abs() < c1 * c1) {
            break;
        }
        let step = c0 / c1;
        t = lesser(to, greater(from, t - step));
        if step.abs() <= 4.0 * UNIT_ROUNDOFF * (1.0 + t.abs()) {
            break;
        }
    }
    t
}
