//! The point and the normal of a hit, computed for visible hits only.

use crate::hit::Hit;
use crate::lathe::{Lathe, Segment};
use crate::math::{Math, Native, UNIT_ROUNDOFF};
use crate::ray::{Ray, RayError};
use crate::vector::{F32x3, Vector, array, difference, dot, largest, one_norm, vector};

/// A point of a surface.
///
/// ```
/// use embedded_lathe::{Lathe, Profile, Ray, valid};
///
/// let ball = Lathe::turn(valid!(Profile::sphere(1.0)));
/// let ray = Ray::new([0.0, -3.0, 0.0], [0.0, 1.0, 0.0])?;
/// let hit = ball.nearest(&ray, 0.0).unwrap();
/// let seen = ball.surface(&ray, &hit);
/// assert_eq!(seen.point, [0.0, -1.0, 0.0]);
/// assert_eq!(seen.normal, [0.0, -1.0, 0.0]);
/// # Ok::<(), embedded_lathe::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Surface {
    /// The point, in the ray's space.
    pub point: [f32; 3],
    /// The unit normal, which points out of the solid. Where the surface comes to a point and has no normal,
    /// it is along the axis.
    pub normal: [f32; 3],
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// The point and the normal of a hit of this lathe by that ray. Cost: one root, one division, about 50
    /// other operations.
    #[must_use]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        Surface { point: ray.at(hit.t), normal: array(self.normal(ray, hit)) }
    }

    /// The unit normal at a hit of this lathe by that ray.
    #[inline]
    pub(crate) fn normal(&self, ray: &Ray, hit: &Hit) -> F32x3 {
        unit(self.gradient_at(ray.point(hit.t), hit))
    }

    /// A ray that goes on from a hit of this lathe by `ray`: a reflection, or towards a light. It starts
    /// beside the hit's point, off the surface by the bound of what rounding can do to either ray (graphics
    /// texts call that an offset ray origin), to the side that `direction` points to. So with a `t_min` of
    /// zero it does not meet the place again that it leaves; and what else it meets is at most as far from
    /// where it should be as the offset is long:
    ///
    /// `16·2⁻²⁴·(4·R + distance + |point|)`, R the radius of the smallest ball around the solid, both others
    /// measured by the sum of the coordinates, from the middle of its axis to the ray's origin, and from the
    /// origin of space to the point.
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Profile, Ray, valid};
    ///
    /// let ball = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// let ray = Ray::new([0.2, -3.0, 0.1], [0.0, 1.0, 0.0])?;
    /// let hit = ball.nearest(&ray, 0.0).unwrap();
    /// assert!(!ball.is_hit(&ball.spawn(&ray, &hit, [0.5, -1.0, 0.5])?, 0.0)); // lit from the front
    /// assert!(ball.is_hit(&ball.spawn(&ray, &hit, [0.0, 1.0, 0.0])?, 0.0)); // in its own shadow from behind
    /// # Ok::<(), embedded_lathe::RayError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`Ray::new`]: of the direction, and of a place beyond f32's range.
    pub fn spawn(&self, ray: &Ray, hit: &Hit, direction: [f32; 3]) -> Result<Ray, RayError> {
        let from_middle = difference(ray.origin, vector([0.0, 0.0, self.middle()]));
        self.surface(ray, hit).spawn(direction, 4.0 * self.ball() + one_norm(from_middle))
    }
}

/// The offset of a spawned ray, over the lengths that its rounding is measured by.
///
/// The promise puts the hit within 4 *units* of the surface, a unit 2⁻²⁴·(size + distance + the hit's own
/// distance), and that is no more than 2·(size + distance); `Ray::at` rounds a product and a sum, 1 more and
/// |point|; and the ray that leaves has to clear the surface by 4 units of 2⁻²⁴·(size + size), its origin
/// being rounded once more, |point|. In all 18·size + 10·distance + 2·|point|, size at most 2·R: 16 times
/// (4·R + distance + |point|) is more than that by half.
const OFFSET: f32 = 16.0 * UNIT_ROUNDOFF;

impl Surface {
    /// The ray from here, off the surface by what rounding can do to numbers as large as `lengths` and the
    /// point.
    pub(crate) fn spawn(self, direction: [f32; 3], lengths: f32) -> Result<Ray, RayError> {
        let (point, normal) = (vector(self.point), vector(self.normal));
        let offset = OFFSET * (lengths + one_norm(point));
        let side = normal * offset.copysign(dot(normal, vector(direction)));
        Ray::new(array(point + side), direction)
    }
}

/// The unit vector along `v`, which must not be zero.
///
/// Gradients have lengths near 1, except those of very flat and very tall profiles, which are first divided
/// by their largest component. From 10⁻²⁴ to 10²⁴ the square of the length needs no such care: the squares of
/// all components that count, 2⁻²³ of the largest and more, are then normal numbers (10⁻²⁴·2⁻⁴⁶ is
/// 1.4·10⁻³⁸), and so is its root's inverse.
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
