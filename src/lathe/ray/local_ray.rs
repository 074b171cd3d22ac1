//! A ray in the lathe's frame.

use crate::cubic::Cubic;
use crate::lathe::frame::Frame;
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::ray::Ray;
use crate::vector::{F32x3, dot, dot_xy};

/// A ray in the lathe's frame. Its t counts from the point of the ray that is nearest to the frame's origin.
/// So all numbers have the size of the solid, however far away the ray's own origin is.
///
/// In the frame every lathe is round, because x is scaled by √k. So of x and y only the squared distance from
/// the axis is kept, `x² + y² = square + q·(t − nearest)²`.
pub(crate) struct LocalRay {
    /// The height at t = 0.
    pub z: f32,
    /// The derivative of the height over t.
    pub dz: f32,
    /// 1/dz: +∞ for a horizontal ray.
    pub per_dz: f32,
    /// dx² + dy².
    pub q: f32,
    /// The t at which the ray is nearest to the axis; zero for a ray parallel to the axis.
    pub nearest: f32,
    /// The squared distance from the axis there.
    pub square: f32,
    /// The sum `t + shift` counts from the ray's own origin.
    pub shift: f32,
    /// The factor between the two parameters: a t of the [`Ray`] times `unit` is `t + shift` of this ray.
    pub unit: f32,
}

impl LocalRay {
    /// The ray in the frame, given in object space.
    #[inline(always)]
    pub fn new(frame: &Frame, ray: &Ray) -> Self {
        let (o, d) = (frame.point(ray.origin), frame.squashed(ray.direction));
        let back = dot(o, d) / dot(d, d);
        Self { shift: -back, unit: frame.scale * ray.unit, ..Self::through(o - d * back, d) }
    }

    /// The ray through a point in a direction, both in the frame. Its t counts from the point, in units of
    /// `direction`; its shift is 0 and its unit 1. The point should lie near the solid: the rounding errors
    /// of `z` and `square` are relative to the point's distance from the frame's origin.
    #[inline(always)]
    pub fn through(point: F32x3, direction: F32x3) -> Self {
        let (p, d) = (point, direction);
        let q = dot_xy(d, d);
        // A ray parallel to the axis is equally near everywhere.
        let nearest = if q > f32::MIN_POSITIVE { -dot_xy(p, d) / q } else { 0.0 };
        let (x, y) = (p.x + nearest * d.x, p.y + nearest * d.y);
        // −0 + 0 = +0: a horizontal ray counts as rising.
        let per_dz = 1.0 / (d.z + 0.0);
        Self { z: p.z, dz: d.z, per_dz, q, nearest, square: x * x + y * y, shift: 0.0, unit: 1.0 }
    }

    /// Whether the ray rises or is horizontal.
    #[inline(always)]
    pub fn rises(&self) -> bool {
        self.per_dz.is_sign_positive()
    }

    /// The t at which the ray enters the slab between the heights `low` and `high`, and the t at which it
    /// leaves. For a horizontal ray each is infinite, or NaN if the ray lies at that height.
    #[inline(always)]
    pub fn slab(&self, low: f32, high: f32) -> (f32, f32) {
        let (low, high) = (self.plane(low), self.plane(high));
        if self.rises() { (low, high) } else { (high, low) }
    }

    /// The t in [from, to] at which the ray is nearest to the axis.
    #[inline(always)]
    pub fn closest(&self, from: f32, to: f32) -> f32 {
        lesser(to, greater(from, self.nearest))
    }

    /// g along the ray as a cubic in s, the distance from the point at t, which lies in the segment's slab:
    /// Taylor's formula,
    ///
    /// `g = f(u) − (x² + y²) + s·(f′·κ − 2·q·a) + s²·(f″/2·κ² − q) + s³·f₃·κ³`,
    ///
    /// with `κ = du/ds = dz/h` and `a = t − nearest`. It takes no division, whatever the ray's slope; a
    /// horizontal ray has κ = 0.
    #[inline]
    pub fn g_about(&self, segment: &Segment, t: f32) -> Cubic {
        let (square, half_slope) = self.around(t);
        let [f0, f1, f2, f3] = segment.along(segment.parameter(self.height(t)), self.dz);
        Cubic::new([f0 - square, f1 - 2.0 * half_slope, f2 - self.q, f3])
    }

    /// The squared distance from the axis at t, and half its derivative, `x·dx + y·dy`.
    #[inline]
    pub fn around(&self, t: f32) -> (f32, f32) {
        let away = t - self.nearest;
        let half_slope = self.q * away;
        (self.square + half_slope * away, half_slope)
    }

    /// The height at t.
    #[inline(always)]
    pub fn height(&self, t: f32) -> f32 {
        self.z + t * self.dz
    }

    /// The t at which the ray passes a height. For a horizontal ray ±∞, or NaN at its own height.
    #[inline(always)]
    pub fn plane(&self, z: f32) -> f32 {
        (z - self.z) * self.per_dz
    }

    /// The t of the [`Ray`] at the point with this t.
    #[inline(always)]
    pub fn distance(&self, t: f32) -> f32 {
        (t + self.shift) / self.unit
    }
}
