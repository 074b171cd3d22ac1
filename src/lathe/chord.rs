use super::path::Path;
use super::segment::Segment;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::solve::{Crossings, Solver};

/// What of a ray lies in one segment's slab and cylinder, and g along it.
pub(super) struct Chord<'a> {
    pub path: &'a Path,
    pub segment: &'a Segment,
    pub index: usize,
    /// Where it begins, and how long it is, in the path's t.
    pub start: f32,
    pub length: f32,
    /// Whether the ray is inside the solid as the chord begins.
    pub inside: bool,
    /// g over w, from 0 at the chord's start to 1 at its end.
    pub g: Cubic,
}

impl<'a> Chord<'a> {
    /// The chord from `start` to `end`, and g at its start and end. `inside` is whatever the caller knows: `None` for "look at g".
    ///
    /// With P = A + w·V: `g = f(u) − ⟨A,A⟩ − 2·w·⟨A,V⟩ − w²·⟨V,V⟩`, and f by Taylor's formula about the u of A. No division, whatever the slope.
    #[inline(always)]
    pub fn new(
        path: &'a Path,
        segment: &'a Segment,
        index: usize,
        start: f32,
        end: f32,
        inside: Option<bool>,
    ) -> Self {
        let length = end - start;
        let (ax, ay) = (path.x + start * path.dx, path.y + start * path.dy);
        let (vx, vy) = (length * path.dx, length * path.dy);
        let u = segment.parameter(path.z + start * path.dz);
        let du = segment.parameter(path.z + end * path.dz) - u;
        let [f0, f1, f2, f3] = segment.f;
        let c0 = ((f3 * u + f2) * u + f1) * u + f0 - (ax * ax + ay * ay);
        let c1 = ((3.0 * f3 * u + 2.0 * f2) * u + f1) * du - 2.0 * (ax * vx + ay * vy);
        let c2 = (3.0 * f3 * u + f2) * (du * du) - (vx * vx + vy * vy);
        let c3 = f3 * (du * du * du);
        Self {
            path,
            segment,
            index,
            start,
            length,
            inside: match inside {
                Some(inside) => inside,
                None => c0 > 0.0,
            },
            g: Cubic::new([c0, c1, c2, c3]),
        }
    }

    /// Whether the Bernstein ordinates of g have all the sign that g starts with: a certain miss, since g lies between them.
    #[inline(always)]
    pub fn is_clear(&self) -> bool {
        let [c0, c1, c2, c3] = self.g.c;
        let g1 = c0 + c1 * (1.0 / 3.0);
        let g2 = c0 + (2.0 * c1 + c2) * (1.0 / 3.0);
        let g3 = c0 + c1 + c2 + c3;
        if self.inside {
            c0 >= 0.0 && g1 > 0.0 && g2 > 0.0 && g3 > 0.0
        } else {
            c0 <= 0.0 && g1 < 0.0 && g2 < 0.0 && g3 < 0.0
        }
    }

    /// The crossings along the chord, in order.
    #[inline(always)]
    pub fn hits<S: Solver>(&self) -> impl Iterator<Item = Hit> {
        let mut inside = self.inside;
        Crossings::<S>::new(self.g, 0.0, 1.0, inside).map(move |w| {
            inside = !inside;
            self.hit(w, inside)
        })
    }

    /// Whether there is a crossing beyond `t_min`.
    #[inline(always)]
    pub fn crosses<S: Solver>(&self, t_min: f32) -> bool {
        self.hits::<S>().any(|hit| hit.t > t_min)
    }

    /// The hit near w. One Newton step on the segment itself, whose squared radius at a point is off by units of that squared radius, not of the largest on the
    /// chord: what matters at poles and in narrow necks.
    #[inline(always)]
    fn hit(&self, w: f32, enters: bool) -> Hit {
        let path = self.path;
        let t = self.start + w * self.length;
        let (x, y) = (path.x + t * path.dx, path.y + t * path.dy);
        let u = self.segment.parameter(path.z + t * path.dz);
        let (f, slope) = self.segment.at(u);
        let g = f - (x * x + y * y);
        let rate = slope * (path.dz * self.segment.per_height) - 2.0 * (x * path.dx + y * path.dy);
        let step = g / rate;
        // Beside a silhouette the slope is mostly rounding, and so would the step be. The frame's lengths are of the order of one.
        let step = if step.abs() < 1.0 / 1024.0 { step } else { 0.0 };
        let t = t - step;
        Hit {
            t: path.distance(t),
            segment: self.index,
            u: self.segment.parameter(path.z + t * path.dz),
            enters,
            part: Part::Wall,
        }
    }
}

impl Segment {
    /// The profile's parameter at a height of the frame, held to the segment.
    #[inline(always)]
    fn parameter(&self, z: f32) -> f32 {
        let u = (z - self.low) * self.per_height;
        if u > 0.0 { if u < 1.0 { u } else { 1.0 } } else { 0.0 }
    }
}
