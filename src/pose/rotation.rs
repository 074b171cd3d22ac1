//! How a solid is turned: a rotation, made from angles, a quaternion or a matrix.

use crate::math::const_fn::sin_cos;
use crate::scene_error::SceneError;
use crate::vector::{F32x3, array, cross, dot, finite, scale, sum_scaled, to_one, unit, vector};

/// A right-handed rotation about the origin, by an angle in radians.
///
/// The angle may be from −10 000 to 10 000. There the spacing of f32 numbers is already 0.001, so that a
/// larger angle would be too inexact. For an angle outside the limits, or NaN, [`Rotation::about`] returns an
/// error. `about_x`, `about_y` and `about_z` return no `Result`: from such an angle they make a matrix that
/// contains NaN, for which [`Pose::new`](super::Pose::new) returns [`SceneError::Rotation`].
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

    /// The rotation of a quaternion `w + x·i + y·j + z·k`, given w and `[x, y, z]`. It need not be a unit
    /// quaternion: its length is divided out. A quaternion and its negative make the same rotation.
    ///
    /// ```
    /// use embedded_lathe::Rotation;
    ///
    /// // An IMU lists w first or last: look it up. A quarter turn about z:
    /// let turn = Rotation::from_quaternion(0.5, [0.0, 0.0, 0.5])?;
    /// assert_eq!(turn.apply([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
    /// # Ok::<(), embedded_lathe::SceneError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SceneError::RotationQuaternion`] if all four numbers are zero or subnormal, or if one is infinite or
    /// NaN.
    pub const fn from_quaternion(w: f32, v: [f32; 3]) -> Result<Self, SceneError> {
        let error = SceneError::RotationQuaternion { w, v };
        let largest = crate::vector::largest(vector([w, crate::vector::largest(vector(v)), 0.0]));
        // All four numbers times the power of two that brings the largest into [1, 4): so no square
        // overflows.
        let Some((_, power)) = to_one(vector([largest, 0.0, 0.0])) else {
            return Err(error);
        };
        let (w, v) = (w * power, scale(vector(v), power));
        if !(w.is_finite() && finite(v)) {
            return Err(error);
        }
        let F32x3 { x, y, z } = v;
        let two = 2.0 / (w * w + dot(v, v));
        Ok(Self {
            rows: [
                vector([1.0 - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)]),
                vector([two * (x * y + w * z), 1.0 - two * (x * x + z * z), two * (y * z - w * x)]),
                vector([two * (x * z - w * y), two * (y * z + w * x), 1.0 - two * (x * x + y * y)]),
            ],
        })
    }

    /// The rotation nearest to a matrix, given by rows, that is nearly a rotation's: as an IMU computes it,
    /// or as it is after many multiplications. Nearest means that the sum of the squares of the nine
    /// differences is least; no axis is preferred.
    ///
    /// The matrix M is accepted if it does not mirror, and if no element of `M·Mᵀ` differs by more than 0.1
    /// from that of the identity: the rows' lengths may be wrong by 5 %, and the angles between them by 5°.
    ///
    /// ```
    /// use embedded_lathe::{Rotation, SceneError};
    ///
    /// let turn = Rotation::from_rows([[0.0, -1.01, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.99]])?;
    /// let [_, [x, _, _], _] = turn.rows();
    /// assert!((x - 1.0).abs() < 1e-6);
    ///
    /// let stretched = Rotation::from_rows([[1.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    /// assert_eq!(stretched, Err(SceneError::RotationRows { row: 0, other: 0, product: 2.25 }));
    /// # Ok::<(), SceneError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SceneError::RotationRows`] with the first two rows whose product differs by more than 0.1, or is
    /// NaN; [`SceneError::RotationMirrors`] if the determinant is negative.
    pub const fn from_rows(rows: [[f32; 3]; 3]) -> Result<Self, SceneError> {
        let [a, b, c] = rows;
        let mut m = [vector(a), vector(b), vector(c)];
        let mut i = 0;
        while i < 9 {
            let (row, other) = (i / 3, i % 3);
            let product = dot(m[row], m[other]);
            let right = if row == other { 1.0 } else { 0.0 };
            if !((product - right).abs() <= MOST_SKEW) {
                return Err(SceneError::RotationRows { row, other, product });
            }
            i += 1;
        }
        let determinant = dot(m[0], cross(m[1], m[2]));
        if !(determinant > 0.0) {
            return Err(SceneError::RotationMirrors { determinant });
        }
        // Newton's iteration for the nearest rotation, M ← ½·(3 − M·Mᵀ)·M. With E = M·Mᵀ − 1 a step turns E
        // into −¾·E² + ¼·E³. The norm of E is 0.3 at most at first, three times the largest element; then
        // 0.075, 0.0044, 1.5·10⁻⁵, and after the fourth step 1.7·10⁻¹⁰, below rounding.
        let mut step = 0;
        while step < 4 {
            let [a, b, c] = m;
            let (ab, bc, ca) = (-0.5 * dot(a, b), -0.5 * dot(b, c), -0.5 * dot(c, a));
            m = [
                sum_scaled(sum_scaled(scale(a, 1.5 - 0.5 * dot(a, a)), b, ab), c, ca),
                sum_scaled(sum_scaled(scale(b, 1.5 - 0.5 * dot(b, b)), a, ab), c, bc),
                sum_scaled(sum_scaled(scale(c, 1.5 - 0.5 * dot(c, c)), a, ca), b, bc),
            ];
            step += 1;
        }
        Ok(Self { rows: m })
    }

    /// The matrix, by rows: `[row 0, row 1, row 2]`. Row 0 is the world's x axis in the coordinates of the
    /// solid's own space, row 1 its y axis, row 2 its z axis. Column 0 is the solid's own x axis in the
    /// coordinates of the world, column 1 its y axis, column 2 its z axis.
    #[must_use]
    pub const fn rows(&self) -> [[f32; 3]; 3] {
        let [a, b, c] = self.rows;
        [array(a), array(b), array(c)]
    }

    /// The rotation that turns back: this one, then its inverse, is no rotation.
    #[must_use]
    pub const fn inverse(self) -> Self {
        let [a, b, c] = self.rows;
        Self { rows: [vector([a.x, b.x, c.x]), vector([a.y, b.y, c.y]), vector([a.z, b.z, c.z])] }
    }

    /// The rotation that does this one first, and then another.
    ///
    /// Each call may add a rounding error of some 2⁻²³ to an element. A rotation that is composed of many
    /// thousands, one a frame, is made a rotation again by `Rotation::from_rows(rotation.rows())`.
    #[must_use]
    pub const fn then(self, next: Self) -> Self {
        let columns = self.inverse().rows;
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
}

/// By how much an element of a matrix times its transpose may differ from the identity's, for
/// [`Rotation::from_rows`]. The value is a choice: a matrix that is off by more is most likely no rotation's.
const MOST_SKEW: f32 = 0.1;

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
