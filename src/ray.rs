//! A ray, whose numbers are checked when it is made.

use crate::math::minmax::{greater, lesser};
use crate::message::Piece::{Text, Vector};
use crate::message::{Message, impl_error};
use crate::vector::{F32x3, array, finite, saturated, scale, to_one, vector};

/// The points `origin + t·direction`. The direction need not be a unit vector: t is measured in lengths of
/// it.
///
/// ```
/// use embedded_lathe::{Ray, RayError};
///
/// let ray = Ray::new([0.0, -2.0, 0.5], [0.0, 2.0, 0.0])?;
/// assert_eq!(ray.at(0.5), [0.0, -1.0, 0.5]);
/// assert_eq!(Ray::new([0.0; 3], [0.0; 3]), Err(RayError::NoDirection { direction: [0.0; 3] }));
/// # Ok::<(), RayError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point where the ray starts.
    pub(crate) origin: F32x3,
    /// The direction that the caller gave, divided by a power of two so that its largest component is in [1,
    /// 4). The direction of a camera's ray is not divided: its length in a picture is from 1 to √(1 + 30²·(1
    /// + (height/width)²)), where 30 is the largest half-width of a camera's picture at unit distance.
    pub(crate) direction: F32x3,
    /// The factor between t and `direction`: the point at t is `origin + (t·unit)·direction`. It is the power
    /// of two that the direction was divided by. For a ray that was moved into a solid's own space, it is
    /// that power divided by the scale of the solid's pose, so that t is the same there as in the world.
    pub(crate) unit: f32,
}

impl Ray {
    /// A ray from a point in a direction, each `[x, y, z]`.
    ///
    /// # Errors
    ///
    /// [`RayError`] if a number is infinite or NaN, or if the direction's largest component is smaller than
    /// f32's smallest positive normal number, 1.2·10⁻³⁸.
    pub const fn new(origin: [f32; 3], direction: [f32; 3]) -> Result<Self, RayError> {
        if !finite(vector(origin)) {
            return Err(RayError::OriginNotFinite { origin });
        }
        if !finite(vector(direction)) {
            return Err(RayError::DirectionNotFinite { direction });
        }
        match to_one(vector(direction)) {
            Some((direction, power)) => Ok(Self { origin: vector(origin), direction, unit: 1.0 / power }),
            None => Err(RayError::NoDirection { direction }),
        }
    }

    /// The point where the ray starts.
    #[must_use]
    pub const fn origin(&self) -> [f32; 3] {
        array(self.origin)
    }

    /// The direction, as long as it was given.
    ///
    /// The ray stores it divided by a power of two, so a component that is less than 10⁻³⁷ of the largest may
    /// be returned rounded.
    #[must_use]
    pub const fn direction(&self) -> [f32; 3] {
        array(scale(self.direction, self.unit))
    }

    /// A ray whose direction is known to be finite and, except for rounding, 1 or longer. It is kept as it
    /// is, with a unit of 1.
    pub(crate) const fn new_unchecked(origin: F32x3, direction: F32x3) -> Self {
        Self { origin, direction, unit: 1.0 }
    }

    /// The point at t. It is finite if t is: a coordinate beyond f32's range becomes f32's largest number, or
    /// its negative.
    #[must_use]
    pub fn at(&self, t: f32) -> [f32; 3] {
        let point = self.origin + self.direction * (t * self.unit);
        array(if finite(point) { point } else { self.far_at(t) })
    }

    /// Returns the same point as `at`, where a product or a sum in `at` overflowed; that can happen although
    /// the point itself is in range. It adds halves of the two terms, which are finite, and doubles their
    /// sum. A coordinate beyond f32's range becomes f32's largest number, or its negative.
    #[cold]
    #[inline(never)]
    fn far_at(&self, t: f32) -> F32x3 {
        let way = lesser(f32::MAX, greater(f32::MIN, t * self.unit));
        let half = self.origin * 0.5 + self.direction * (0.5 * way);
        saturated(half * 2.0)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Ray {
    fn format(&self, f: defmt::Formatter) {
        let (o, d) = (self.origin, self.direction);
        defmt::write!(
            f,
            "Ray {{ origin: ({}, {}, {}), direction: ({}, {}, {}) * {} }}",
            o.x,
            o.y,
            o.z,
            d.x,
            d.y,
            d.z,
            self.unit
        );
    }
}

/// Why numbers do not make a ray, and which numbers they are.
///
/// ```
/// use embedded_lathe::{Ray, RayError};
///
/// let error = Ray::new([f32::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]).unwrap_err();
/// assert_eq!(error, RayError::OriginNotFinite { origin: [f32::NAN, 0.0, 0.0] });
/// assert_eq!(error.to_string(), "the ray's origin must be finite, and is [NaN, 0.0, 0.0]");
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RayError {
    /// A coordinate of the origin is infinite or NaN.
    OriginNotFinite {
        /// The origin given.
        origin: [f32; 3],
    },
    /// A component of the direction is infinite or NaN.
    DirectionNotFinite {
        /// The direction given.
        direction: [f32; 3],
    },
    /// The direction is zero, or its largest component is smaller than f32's smallest positive normal number,
    /// 1.2·10⁻³⁸.
    NoDirection {
        /// The direction given.
        direction: [f32; 3],
    },
}

impl RayError {
    /// The words of the error.
    const fn message(self) -> Message {
        match self {
            Self::OriginNotFinite { origin } => {
                Message::of([Text("the ray's origin must be finite, and is "), Vector(origin)])
            }
            Self::DirectionNotFinite { direction } => {
                Message::of([Text("the ray's direction must be finite, and is "), Vector(direction)])
            }
            Self::NoDirection { direction } => {
                Message::of([Text("the ray's direction must not be zero, and is "), Vector(direction)])
            }
        }
    }
}

impl_error!(RayError);
