//! What is seen of a hit: its point and its normal. Paid for by visible hits only.

use crate::hit::{Hit, Part};
use crate::lathe::{Lathe, Segment};
use crate::math::{Math, Native};
use crate::ray::Ray;
use crate::vector::{F32x3, Vector, largest, vector};

/// A point of a surface.
///
/// ```
/// use embedded_lathe::{Lathe, Profile, Ray, valid};
///
/// let ball = Lathe::turn(valid!(Profile::sphere(1.0)));
/// let ray = Ray::new([0.0, -3.0, 0.0], [0.0, 1.0, 0.0])?;
/// let hit = ball.nearest(&ray, 0.0).unwrap();
/// let seen = ball.surface(&ray, &hit);
/// assert_eq!(seen.point.to_array(), [0.0, -1.0, 0.0]);
/// assert_eq!(seen.normal.to_array(), [0.0, -1.0, 0.0]);
/// # Ok::<(), embedded_lathe::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point, in the ray's space.
    pub point: F32x3,
    /// The unit normal, out of the solid. At a pole that comes to a point, where there is none, along the
    /// axis.
    pub normal: F32x3,
}

#[cfg(feature = "defmt")]
impl defmt::Format for Surface {
    fn format(&self, f: defmt::Formatter) {
        let (p, n) = (self.point, self.normal);
        defmt::write!(
            f,
            "Surface {{ point: ({}, {}, {}), normal: ({}, {}, {}) }}",
            p.x,
            p.y,
            p.z,
            n.x,
            n.y,
            n.z
        );
    }
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// The point and the normal of a hit of this lathe by that ray. Cost: one root, one division, about 50
    /// other operations.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let point = ray.at(hit.t);
        let normal = unit(self.gradient(point, hit)).unwrap_or(self.pole(hit));
        Surface { point, normal }
    }

    /// A vector along the outward normal at a point of the surface: `(2k·x, 2y, −f′(u)/h)` on the wall, half
    /// of it in the lathe's frame.
    #[inline(always)]
    pub(crate) fn gradient(&self, point: F32x3, hit: &Hit) -> F32x3 {
        let (scale, squash) = self.proportions();
        match hit.part {
            Part::Base => vector([0.0, 0.0, -1.0]),
            Part::Top => vector([0.0, 0.0, 1.0]),
            Part::Wall => vector([squash * scale * point.x, scale * point.y, -0.5 * self.slope(hit)]),
        }
    }

    /// Out of the solid along the axis.
    pub(crate) fn pole(&self, hit: &Hit) -> F32x3 {
        let down = hit.segment == 0 && hit.u < 0.5;
        vector([0.0, 0.0, if down { -1.0 } else { 1.0 }])
    }
}

/// The unit vector along `v`, if it has a direction.
///
/// Lengths in a lathe's frame are near one, but a very flat or very tall profile's are not: those are brought
/// there first.
#[inline(always)]
pub(crate) fn unit(v: F32x3) -> Option<F32x3> {
    const FAR: f32 = 1e12;
    let size = largest(v);
    let v = if size > 1.0 / FAR && size < FAR { v } else { v * (1.0 / size) };
    let square = v.dot(v);
    (square > 0.0).then(|| v * (1.0 / Native::sqrt(square)))
}
