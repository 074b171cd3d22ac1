//! The point and the normal of a hit, computed for visible hits only.

use crate::hit::Hit;
use crate::lathe::{Lathe, Segment};
use crate::math::{Math, Native, UNIT_ROUNDOFF};
use crate::ray::{Ray, RayError};
use crate::vector::{F32x3, Vector, array, difference, dot, one_norm, vector};

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
    /// The point, in the coordinates of the ray.
    pub point: [f32; 3],
    /// The unit normal, which points out of the solid. At the tip of a solid, where the surface has no
    /// normal, it is parallel to the axis.
    pub normal: [f32; 3],
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// The point and the normal of `hit`, which must be a hit of this lathe by `ray`. It costs one square
    /// root, one division and about 50 other operations.
    #[must_use]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        Surface { point: ray.at(hit.t), normal: array(self.normal(ray, hit)) }
    }

    /// The unit normal at a hit of this lathe by `ray`.
    #[inline]
    pub(crate) fn normal(&self, ray: &Ray, hit: &Hit) -> F32x3 {
        let gradient = self.gradient(ray, hit);
        gradient * (1.0 / Native::sqrt(gradient.dot(gradient)))
    }

    /// A ray that goes on from a hit of this lathe by `ray`: a reflection, or towards a light. Its origin is
    /// the hit's point, moved along the normal to the side that `direction` points to (graphics texts call
    /// that an offset ray origin). The offset is an upper bound of the rounding errors of both rays, so that
    /// with a `t_min` of zero the new ray does not hit the surface at the point that it leaves. Its other
    /// hits are displaced by at most the offset, which is
    ///
    /// `16·2⁻²⁴·(4·R + distance + |point|)`.
    ///
    /// R is the radius of a ball about the middle of the axis that contains the solid; if the solid is
    /// stretched along x, the solid without that stretch. `distance` is that of the ray's origin from the
    /// middle of the axis, and `|point|` that of the hit's point from the origin of the coordinates; both are
    /// sums of the coordinates' magnitudes.
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
    /// [`RayError`] as from [`Ray::new`], if the direction is zero, infinite or NaN, or if the new origin is
    /// beyond f32's range.
    pub fn spawn(&self, ray: &Ray, hit: &Hit, direction: [f32; 3]) -> Result<Ray, RayError> {
        let from_middle = difference(ray.origin, vector([0.0, 0.0, self.middle()]));
        self.surface(ray, hit).spawn(direction, 4.0 * self.ball() + one_norm(from_middle))
    }
}

/// The offset of a spawned ray, divided by the sum of the lengths that the rounding errors are proportional
/// to, `4·R + distance + |point|`.
///
/// Three errors add up, counted here in multiples of 2⁻²⁴. First, the hit lies within 4 *units* of the
/// surface. Its unit is size + distance + the hit's own distance, at most 2·(size + distance), so this error
/// is at most 8·(size + distance). Second, `Ray::at` rounds a product, at most 2·(size + distance), and a
/// sum, at most |point|. Third, the new ray must clear the surface by 4 units, where its unit is size +
/// distance with a distance of at most size, and its origin is rounded once, |point|. The total is 18·size +
/// 10·distance + 2·|point|, where size is at most 2·R. The offset, 16·(4·R + distance + |point|), is larger
/// by more than half.
const OFFSET: f32 = 16.0 * UNIT_ROUNDOFF;

impl Surface {
    /// A ray from this point in `direction`, its origin moved off the surface by [`OFFSET`] times (`lengths`
    /// + |point|), to the side that `direction` points to.
    pub(crate) fn spawn(self, direction: [f32; 3], lengths: f32) -> Result<Ray, RayError> {
        let (point, normal) = (vector(self.point), vector(self.normal));
        let offset = OFFSET * (lengths + one_norm(point));
        let side = normal * offset.copysign(dot(normal, vector(direction)));
        Ray::new(array(point + side), direction)
    }
}
