//! A ray's chord in the *slab* of one segment, and where it crosses the surface.

use super::local_ray::LocalRay;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::lathe::segment::Segment;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::{greater, lesser};
use crate::solve::Crossings;

/// The part of a ray that lies in one segment's slab, and g along it as a cubic in s, the distance from
/// `origin`.
pub(super) struct Chord<'a> {
    ray: &'a LocalRay,
    segment: &'a Segment,
    /// The segment's number.
    index: usize,
    /// The local ray's t at s = 0.
    origin: f32,
    g: Cubic,
    /// The s at which the chord begins.
    from: f32,
    /// The s at which it ends.
    to: f32,
}

impl<'a> Chord<'a> {
    /// The chord in the slab of segment number `index`, between two t of the local ray.
    ///
    /// g is formed about one of two points: the chord's point nearest to the axis, where x² + y² is least, or
    /// its point nearest to the height where the segment is narrowest. The second is taken if there f and the
    /// excess of x² + y² over the ray's least are together less than f at the first, as they can be for a
    /// steep ray. So by a pole or in a narrow neck the coefficients, and their rounding errors, are as small
    /// as the solid is there.
    #[inline(always)]
    pub fn new(ray: &'a LocalRay, segment: &'a Segment, index: usize, [from, to]: [f32; 2]) -> Self {
        let mut origin = ray.closest(from, to);
        let mut g = ray.g_about(segment, origin);
        // g's constant term is f − (x² + y²).
        let f = g.c[0] + ray.around(origin).0;
        let narrow = lesser(to, greater(from, ray.plane(segment.narrowest)));
        let square = ray.around(narrow).0;
        if square - ray.square < f {
            let there = ray.g_about(segment, narrow);
            if there.c[0] + square + (square - ray.square) < f {
                (origin, g) = (narrow, there);
            }
        }
        Self { ray, segment, index, origin, g, from: from - origin, to: to - origin }
    }

    /// The roots of g along the chord, in order, one for each change of sides. `inside` says whether the ray
    /// is inside the solid where the chord begins, `ends_inside` where it ends. The number of roots is odd if
    /// the two differ, else even, even where g at the ends says otherwise.
    #[inline(always)]
    pub fn crossings(&self, inside: bool, ends_inside: bool) -> Crossings<'_> {
        Crossings::between(&self.g, [self.from, self.to], [inside, ends_inside])
    }

    /// The hit on the wall at the root s of g, refined by Newton's method. Its t is that of the
    /// [`Ray`](crate::Ray).
    #[inline(always)]
    pub fn hit(&self, s: f32, enters: bool) -> Hit {
        let ends = [self.origin + self.from, self.origin + self.to];
        let t = refined(self.ray, self.segment, self.origin + s, ends);
        Hit {
            t: self.ray.distance(t),
            segment: self.index,
            u: self.segment.parameter(self.ray.height(t)),
            enters,
            part: Part::Wall,
        }
    }
}

/// The most steps of Newton's method that refine a root. They converge quadratically, except at an almost
/// double root, where each step halves the error. Rounding can misplace a double root by 2⁻¹² of the chord,
/// the square root of 2⁻²⁴; twelve steps bring that to 2⁻²⁴.
const REFINING_STEPS: u32 = 12;

/// Returns the t of a root of g near the t given, by Newton's method. The root is clamped to [from, to].
///
/// Far from the point that g was formed about, rounding changes g by a few units of 2⁻²⁴ of all its terms
/// there, and moves its root accordingly. So g is formed anew about each approximation, where rounding
/// changes it by units of f and x² + y² only. One step or two suffice, except at a tip that is almost that of
/// a cone, where f and f′ are both almost zero: there the root is almost double, and each step halves the
/// error.
///
/// The method ends with a step of at most four units of 2⁻²⁴ times 1 + |t|. That is about what the rounding
/// of t and of g leaves, since the largest radius in the frame is at least 1. It ends before a step for which
/// Newton's method is not sure to come nearer, and then returns the approximation reached.
#[inline(always)]
fn refined(ray: &LocalRay, segment: &Segment, mut t: f32, [from, to]: [f32; 2]) -> f32 {
    for _ in 0..REFINING_STEPS {
        let [c0, c1, c2, _] = ray.g_about(segment, t).c;
        // With c0·c2 ≥ c1²/4 the parabola c0 + c1·s + c2·s² has a double root or none; with c0·c2 ≤ −c1²/4
        // the step to its root, c0/c1, is too long by a fifth or more. NaN ends the method, too.
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
