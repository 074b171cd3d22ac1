use super::path::Path;
use super::segment::Segment;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::math::order::{greater, lesser};
use crate::solve::{Solver, first_crossing, first_piece};
use core::ops::ControlFlow;

/// What of a ray lies in one segment's slab and cylinder, and g along it.
pub(super) struct Chord<'a> {
    path: &'a Path,
    segment: &'a Segment,
    index: usize,
    /// Whether the ray is inside the solid as the chord begins.
    pub inside: bool,
    /// Whether the chord begins beyond `t_min`, not there.
    later: bool,
    /// Where on the path s = 0.
    origin: f32,
    /// g over s.
    g: Cubic,
    /// The chord's ends, in s.
    from: f32,
    to: f32,
}

impl<'a> Chord<'a> {
    /// The chord between two of the path's t. `inside` is what is known where it begins: `None` for "see for
    /// yourself".
    ///
    /// Taylor's formula about a point of the chord,
    ///
    /// `g = f(u) − (x² + y²) + s·(f′·κ − 2·(x·dx + y·dy)) + s²·(f″/2·κ² − q) + s³·f₃·κ³`, κ = du/ds = dz/h.
    ///
    /// No division, whatever the slope; a horizontal ray has κ = 0. The point is the one nearest to the axis,
    /// where x² + y² is least, unless f and x² + y² are less where the segment is narrowest, as they can be
    /// for a steep ray: so that by a pole or in a narrow neck the coefficients are as small as the solid is
    /// there.
    #[inline(always)]
    pub fn new(
        path: &'a Path,
        segment: &'a Segment,
        index: usize,
        [from, to]: [f32; 2],
        inside: Option<bool>,
        later: bool,
    ) -> Self {
        let within = |t: f32| lesser(to, greater(from, t));
        let mut origin = within(path.nearest);
        let mut here = Place::new(path, segment, origin);
        let narrow = within(path.plane(segment.narrowest));
        let away = narrow - path.nearest;
        if path.q * (away * away) < here.f {
            let there = Place::elsewhere(path, segment, narrow);
            if there.f + path.q * (away * away) < here.f {
                (origin, here) = (narrow, there);
            }
        }
        let kappa = path.dz * segment.per_height;
        let [_, _, f2, f3] = segment.f;
        let c2 = (3.0 * f3 * here.u + f2) * (kappa * kappa) - path.q;
        let c3 = f3 * (kappa * kappa * kappa);
        Self {
            path,
            segment,
            index,
            inside: match inside {
                Some(inside) => inside,
                None => Place::elsewhere(path, segment, from).g > 0.0,
            },
            later,
            origin,
            g: Cubic::new([here.g, here.slope, c2, c3]),
            from: from - origin,
            to: to - origin,
        }
    }

    /// Whether g certainly keeps the sign that it starts with.
    ///
    /// From outside: since |s| ≤ l on the chord, `g ≤ c0 + c1·s + (c2 + |c3|·l)·s²`, a parabola, and where that opens
    /// downwards its vertex is at `c0 − c1²/4(c2 + |c3|·l)`. That is close, for c3 is small. Otherwise, and from
    /// inside, the Bernstein ordinates tell.
    #[inline(always)]
    pub fn is_clear(&self) -> bool {
        if self.inside {
            return self.ordinates().iter().all(|&ordinate| ordinate > 0.0);
        }
        let [c0, c1, c2, c3] = self.g.c;
        let l = if self.to > -self.from { self.to } else { -self.from };
        let c2 = c2 + c3.abs() * l;
        (c2 < 0.0 && c0 < 0.0 && c1 * c1 < 4.0 * c2 * c0)
            || self.ordinates().iter().all(|&ordinate| ordinate < 0.0)
    }

    /// The Bernstein ordinates of g over the chord: g lies between the least and the largest.
    #[inline(always)]
    fn ordinates(&self) -> [f32; 4] {
        let third = (self.to - self.from) * (1.0 / 3.0);
        let (g0, g3) = (self.g.at(self.from), self.g.at(self.to));
        [g0, g0 + third * self.g.slope(self.from), g3 - third * self.g.slope(self.to), g3]
    }

    /// The crossings along the chord, in order, until told to stop; then whether the ray is inside at its
    /// end. A cubic has at most three.
    #[inline(always)]
    pub fn each_hit<S: Solver, B>(
        &self,
        mut meet: impl FnMut(Hit) -> ControlFlow<B>,
    ) -> ControlFlow<B, bool> {
        let (mut from, mut inside) = (self.from, self.inside);
        for _ in 0..3 {
            let Some(s) = first_crossing::<S>(&self.g, from, self.to, inside) else {
                break;
            };
            inside = !inside;
            if let ControlFlow::Break(found) = meet(self.hit(s, inside)) {
                return ControlFlow::Break(found);
            }
            from = s;
            if !(from < self.to) {
                break;
            }
        }
        ControlFlow::Continue(inside)
    }

    /// Whether any crossing of it lies beyond `t_min`, and no farther than a number can tell.
    #[inline(always)]
    pub fn is_beyond(&self) -> bool {
        self.later && self.path.distance(self.origin + self.to) < f32::INFINITY
    }

    /// Whether there is a crossing at all: signs, no root.
    #[inline(always)]
    pub fn crosses<S: Solver>(&self) -> bool {
        first_piece::<S::Math>(&self.g, self.from, self.to, self.inside).is_some()
    }

    #[inline(always)]
    fn hit(&self, s: f32, enters: bool) -> Hit {
        let t = self.origin + s;
        Hit {
            t: self.path.distance(t),
            segment: self.index,
            u: self.segment.parameter(self.path.z + t * self.path.dz),
            enters,
            part: Part::Wall,
        }
    }
}

/// A point of a path in a segment's slab.
struct Place {
    u: f32,
    f: f32,
    g: f32,
    /// dg/dt along the path.
    slope: f32,
}

impl Place {
    #[inline(always)]
    fn new(path: &Path, segment: &Segment, t: f32) -> Self {
        let (x, y) = (path.x + t * path.dx, path.y + t * path.dy);
        let u = segment.parameter(path.z + t * path.dz);
        let (f, slope) = segment.at(u);
        Self {
            u,
            f,
            g: f - (x * x + y * y),
            slope: slope * (path.dz * segment.per_height) - 2.0 * (x * path.dx + y * path.dy),
        }
    }

    /// The same, apart: what few chords ask for need not be in line everywhere.
    #[inline(never)]
    fn elsewhere(path: &Path, segment: &Segment, t: f32) -> Self {
        Self::new(path, segment, t)
    }
}

impl Segment {
    /// The profile's parameter at a height of the frame, held to the segment.
    #[inline(always)]
    fn parameter(&self, z: f32) -> f32 {
        let u = (z - self.low) * self.per_height;
        lesser(1.0, greater(0.0, u))
    }
}
