//! A ray, whose numbers are checked when it is made.

use crate::math::minmax::{greater, lesser};
use crate::message::Piece::{Text, Vector};
use crate::message::{Message, says};
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
    pub(crate) origin: F32x3,
    /// The direction given, divided by `unit`, so that its largest component is in [1, 4). A camera's rays
    /// keep theirs as it is: from 1 to 1 + 30·√(1 + (height/width)²) long, 30 the largest half-width.
    pub(crate) direction: F32x3,
    /// The length of the direction given over that of `direction`: a power of two, divided by the scale of
    /// the solid in whose space the ray is. The parameter t of the ray is t·unit along `direction`.
    pub(crate) unit: f32,
}

impl Ray {
    /// A ray from a point in a direction, each `[x, y, z]`.
    ///
    /// # Errors
    ///
    /// [`RayError`] if a number is not finite, or the direction's largest component is smaller than the least
    /// normal number, 1.2·10⁻³⁸.
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
    /// It is kept with a power of two taken out, so a component that is less than 10⁻³⁷ of the largest may
    /// come back rounded.
    #[must_use]
    pub const fn direction(&self) -> [f32; 3] {
        array(scale(self.direction, self.unit))
    }

    /// A ray whose direction is known to be finite and, except for rounding, 1 or longer.
    pub(crate) const fn new_unchecked(origin: F32x3, direction: F32x3) -> Self {
        Self { origin, direction, unit: 1.0 }
    }

    /// The point at t, finite if t is: of a coordinate beyond f32's range, the largest number with its sign.
    #[must_use]
    pub fn at(&self, t: f32) -> [f32; 3] {
        array(self.point(t))
    }

    /// As [`Ray::at`].
    pub(crate) fn point(&self, t: f32) -> F32x3 {
        let point = self.origin + self.direction * (t * self.unit);
        if finite(point) { point } else { self.far_at(t) }
    }

    /// The same where a product overflows although the point may not: computed at half the size, where the
    /// two terms that cancel are finite.
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

/// What keeps numbers from being a ray, and which numbers they are.
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
    /// The direction is zero, or its largest component smaller than the least normal number, 1.2·10⁻³⁸.
    NoDirection {
        /// The direction given.
        direction: [f32; 3],
    },
}

impl RayError {
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

says!(RayError);
