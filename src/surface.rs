//! What is seen of a hit: its point and its normal. Paid for by visible hits only.

use crate::hit::Hit;
use crate::lathe::{Lathe, Segment};
use crate::math::{Math, Native};
use crate::ray::Ray;
use crate::vector::{F32x3, Vector, largest};

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
        let normal = unit(self.gradient_at(point, hit));
        Surface { point, normal }
    }
}

/// The unit vector along `v`, which is not zero.
///
/// Lengths in a lathe's frame are near one, but a very flat or very tall profile's slopes are not: those are
/// brought there first.
#[inline]
pub(crate) fn unit(v: F32x3) -> F32x3 {
    let square = v.dot(v);
    if square > 1e-24 && square < 1e24 { v * (1.0 / Native::sqrt(square)) } else { unit_of_odd_length(v) }
}

#[cold]
#[inline(never)]
fn unit_of_odd_length(v: F32x3) -> F32x3 {
    let v = v * (1.0 / largest(v));
    v * (1.0 / Native::sqrt(v.dot(v)))
}
