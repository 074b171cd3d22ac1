//! Where a solid stands, how it is turned, and how large it is.

use crate::math::const_fn::sin_cos;
use crate::scene_error::SceneError;
use crate::vector::{F32x3, array, dot, finite, scale, unit, vector};

/// A position, a rotation and a uniform scale: `world = position + scale·(rotation · object)`.
///
/// ```
/// use embedded_lathe::{Pose, Rotation, valid};
///
/// const LEANING: Pose = valid!(Pose::new([0.0, 0.0, 0.5], Rotation::about_x(0.5), 2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where the origin of the solid's own space is in the world.
    pub(crate) position: F32x3,
    /// How the solid is turned about that origin.
    pub(crate) rotation: Rotation,
    /// The factor by which the solid is enlarged: from 10⁻³⁰ to 10³⁰.
    pub(crate) scale: f32,
}

impl Default for Pose {
    /// [`Pose::IDENTITY`].
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Pose {
    /// The pose that leaves a solid in its own space: its axis along z.
    pub const IDENTITY: Self = Self { position: vector([0.0; 3]), rotation: Rotation::IDENTITY, scale: 1.0 };

    /// A pose: the position of the origin of the solid's own space in the world, the rotation of the solid
    /// about that origin, and the factor by which the solid is enlarged.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if a coordinate is infinite or NaN, if the rotation was made from an angle outside −10
    /// 000 to 10 000 or NaN, or if the scale is outside 10⁻³⁰ to 10³⁰. (Within these limits the inverse of
    /// the scale is a normal number, too.)
    pub const fn new(position: [f32; 3], rotation: Rotation, scale: f32) -> Result<Self, SceneError> {
        if !finite(vector(position)) {
            return Err(SceneError::Position { position });
        }
        if !rotation.is_finite() {
            return Err(SceneError::Rotation);
        }
        if !(scale >= 1e-30 && scale <= 1e30) {
            return Err(SceneError::Scale { scale });
        }
        Ok(Self { position: vector(position), rotation, scale })
    }

    /// Where the origin of the solid's own space is.
    #[must_use]
    pub const fn position(&self) -> [f32; 3] {
        array(self.position)
    }

    /// How the solid is turned.
    #[must_use]
    pub const fn rotation(&self) -> Rotation {
        self.rotation
    }

    /// The factor by which the solid is larger than in its own space.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// Converts a point of the world to the solid's own space.
    #[inline]
    pub(crate) fn point_into(&self, world: F32x3) -> F32x3 {
        self.rotation.back(world - self.position) * (1.0 / self.scale)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Pose {
    fn format(&self, f: defmt::Formatter) {
        let p = self.position;
        defmt::write!(
            f,
            "Pose {{ position: ({}, {}, {}), rotation: {}, scale: {} }}",
            p.x,
            p.y,
            p.z,
            self.rotation,
            self.scale
        );
    }
}

/// A right-handed rotation about the origin, by an angle in radians.
///
/// The angle may be from −10 000 to 10 000. There the spacing of f32 numbers is already 0.001, so that a
/// larger angle would be too inexact. For an angle outside the limits, or NaN, [`Rotation::about`] returns an
/// error. `about_x`, `about_y` and `about_z` return no `Result`: from such an angle they make a matrix that
/// contains NaN, for which [`Pose::new`] returns [`SceneError::Rotation`].
///
/// All constructors are `const`, and compute the same bits at compile time and at run time.
///
/// ```
/// use embedded_lathe::Rotation;
///
/// const TILT: Rotation = Rotation::about_x(0.5).then(Rotation::about_z(1.0));
/// let up = TILT.apply([0.0, 0.0, 1.0]);
/// assert!((up[2] - 0.5f32.cos()).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// The matrix by rows.
    rows: [F32x3; 3],
}

impl Default for Rotation {
    /// [`Rotation::IDENTITY`].
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self =
        Self { rows: [vector([1.0, 0.0, 0.0]), vector([0.0, 1.0, 0.0]), vector([0.0, 0.0, 1.0])] };

    /// About the x axis: y turns towards z.
    #[must_use]
    pub const fn about_x(angle: f32) -> Self {
        let (s, c) = sin_cos(angle);
        Self { rows: [vector([1.0, 0.0, 0.0]), vector([0.0, c, -s]), vector([0.0, s, c])] }
    }

    /// About the y axis: z turns towards x.
    #[must_use]
    pub const fn about_y(angle: f32) -> Self {
        let (s, c) = sin_cos(angle);
        Self { rows: [vector([c, 0.0, s]), vector([0.0, 1.0, 0.0]), vector([-s, 0.0, c])] }
    }

    /// About the z axis: x turns towards y.
    #[must_use]
    pub const fn about_z(angle: f32) -> Self {
        let (s, c) = sin_cos(angle);
        Self { rows: [vector([c, -s, 0.0]), vector([s, c, 0.0]), vector([0.0, 0.0, 1.0])] }
    }

    /// About any axis, which need not be a unit vector.
    ///
    /// # Errors
    ///
    /// [`SceneError::RotationAxis`] if the axis is zero or not finite, [`SceneError::RotationAngle`] if the
    /// angle is outside −10 000 to 10 000 or NaN.
    pub const fn about(axis: [f32; 3], angle: f32) -> Result<Self, SceneError> {
        let (s, c) = sin_cos(angle);
        if !s.is_finite() {
            return Err(SceneError::RotationAngle { angle });
        }
        let Some(F32x3 { x, y, z }) = unit(vector(axis)) else {
            return Err(SceneError::RotationAxis { axis });
        };
        let v = 1.0 - c;
        Ok(Self {
            rows: [
                vector([c + x * x * v, x * y * v - z * s, x * z * v + y * s]),
                vector([y * x * v + z * s, c + y * y * v, y * z * v - x * s]),
                vector([z * x * v - y * s, z * y * v + x * s, c + z * z * v]),
            ],
        })
    }

    /// The rotation that does this one first, and then another.
    #[must_use]
    pub const fn then(self, next: Self) -> Self {
        let [a, b, c] = self.rows;
        let columns = [vector([a.x, b.x, c.x]), vector([a.y, b.y, c.y]), vector([a.z, b.z, c.z])];
        let [p, q, r] = next.rows;
        Self { rows: [times(p, columns), times(q, columns), times(r, columns)] }
    }

    /// Turns a vector.
    #[must_use]
    pub const fn apply(&self, v: [f32; 3]) -> [f32; 3] {
        array(self.turn(vector(v)))
    }

    /// Does what [`Rotation::apply`] does.
    pub(crate) const fn turn(&self, v: F32x3) -> F32x3 {
        times(v, self.rows)
    }

    /// The z axis, turned by this rotation.
    pub(crate) const fn axis(&self) -> F32x3 {
        let [a, b, c] = self.rows;
        vector([a.z, b.z, c.z])
    }

    /// Turns a vector back, by the inverse of this rotation.
    pub(crate) const fn back(&self, v: F32x3) -> F32x3 {
        let [a, b, c] = self.rows;
        let (a, b, c) = (scale(a, v.x), scale(b, v.y), scale(c, v.z));
        vector([a.x + b.x + c.x, a.y + b.y + c.y, a.z + b.z + c.z])
    }

    /// Whether no element of the matrix is infinite or NaN.
    const fn is_finite(&self) -> bool {
        let [a, b, c] = self.rows;
        finite(a) && finite(b) && finite(c)
    }
}

/// The dot products of a vector with each of three others.
const fn times(v: F32x3, [a, b, c]: [F32x3; 3]) -> F32x3 {
    vector([dot(v, a), dot(v, b), dot(v, c)])
}

#[cfg(feature = "defmt")]
impl defmt::Format for Rotation {
    fn format(&self, f: defmt::Formatter) {
        let [a, b, c] = self.rows;
        defmt::write!(
            f,
            "[[{}, {}, {}], [{}, {}, {}], [{}, {}, {}]]",
            a.x,
            a.y,
            a.z,
            b.x,
            b.y,
            b.z,
            c.x,
            c.y,
            c.z
        );
    }
}
