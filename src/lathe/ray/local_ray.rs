use crate::cubic::Cubic;
use crate::lathe::frame::Frame;
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::ray::Ray;
use crate::vector::{F32x3, dot, dot_xy};

/// A ray in the lathe's frame, its origin moved along it to where it is nearest to the frame's, so that what
/// follows has the size of the solid however far away the ray comes from. x is scaled by √k: there every
/// lathe is round, and of x and y no more matters than the square of the distance from the axis,
/// `square + q·(t − nearest)²`.
pub(crate) struct LocalRay {
    pub z: f32,
    pub dz: f32,
    /// Infinite for a horizontal path.
    pub per_dz: f32,
    /// dx² + dy².
    pub q: f32,
    /// The t at which the path is nearest to the axis, and the square of the distance there.
    pub nearest: f32,
    pub square: f32,
    /// Where the path's origin lies on the ray, in the path's t.
    pub shift: f32,
    /// A path's t (from the ray's origin) is a distance along the ray, in units of its own direction, times
    /// this.
    pub unit: f32,
}

impl LocalRay {
    /// A ray of object space.
    #[inline(always)]
    pub fn new(frame: &Frame, ray: &Ray) -> Self {
        let (o, d) = (frame.squashed(frame.point(ray.origin)), frame.squashed(ray.direction));
        let back = dot(o, d) / dot(d, d);
        Self { shift: -back, unit: frame.scale * ray.unit, ..Self::through(o - d * back, d) }
    }

    /// A line of the frame, x scaled by √k, about a point of its own that lies near the solid. t counts from that point, and in
    /// units of `direction`.
    #[inline(always)]
    pub fn through(point: F32x3, direction: F32x3) -> Self {
        let (p, d) = (point, direction);
        let q = dot_xy(d, d);
        // Parallel to the axis, it is as near everywhere.
        let nearest = if q > f32::MIN_POSITIVE { -dot_xy(p, d) / q } else { 0.0 };
        let (x, y) = (p.x + nearest * d.x, p.y + nearest * d.y);
        // −0 + 0 = +0: a horizontal path counts as rising.
        let per_dz = 1.0 / (d.z + 0.0);
        Self { z: p.z, dz: d.z, per_dz, q, nearest, square: x * x + y * y, shift: 0.0, unit: 1.0 }
    }

    /// Whether it rises, or runs level.
    #[inline(always)]
    pub fn rises(&self) -> bool {
        self.per_dz > 0.0
    }

    /// From where to where it is between two heights.
    #[inline(always)]
    pub fn slab(&self, low: f32, high: f32) -> (f32, f32) {
        let (low, high) = (self.plane(low), self.plane(high));
        if self.rises() { (low, high) } else { (high, low) }
    }

    /// Of the points between two, the one nearest to the axis.
    #[inline(always)]
    pub fn closest(&self, from: f32, to: f32) -> f32 {
        lesser(to, greater(from, self.nearest))
    }

    /// g about a point of the path in a segment's slab, by Taylor's formula: over the distance s from there, a
    /// from where the path is nearest to the axis,
    ///
    /// `g = f(u) − (x² + y²) + s·(f′·κ − 2·q·a) + s²·(f″/2·κ² − q) + s³·f₃·κ³`, κ = du/ds = dz/h.
    ///
    /// No division, whatever the slope; a level path has κ = 0.
    #[inline]
    pub fn g_about(&self, segment: &Segment, t: f32) -> Cubic {
        let (square, pull) = self.around(t);
        let [f0, f1, f2, f3] = segment.along(segment.parameter(self.height(t)), self.dz);
        Cubic::new([f0 - square, f1 - 2.0 * pull, f2 - self.q, f3])
    }

    /// The square of the distance from the axis, and half its derivative.
    #[inline(always)]
    pub fn around(&self, t: f32) -> (f32, f32) {
        let away = t - self.nearest;
        let pull = self.q * away;
        (self.square + pull * away, pull)
    }

    #[inline(always)]
    pub fn height(&self, t: f32) -> f32 {
        self.z + t * self.dz
    }

    /// Where the path passes a height.
    #[inline(always)]
    pub fn plane(&self, z: f32) -> f32 {
        (z - self.z) * self.per_dz
    }

    /// The distance along the ray, in units of its own direction, at the path's t.
    #[inline(always)]
    pub fn distance(&self, t: f32) -> f32 {
        (t + self.shift) / self.unit
    }
}
