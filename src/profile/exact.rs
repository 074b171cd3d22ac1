use super::{Profile, ProfileError};

/// Exact profiles of one segment: quadrics, whose cubic coefficient is zero. Both ends are capped.
impl Profile<1> {
    /// A cylinder from z = 0 to z = height.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn cylinder(radius: f32, height: f32) -> Result<Self, ProfileError> {
        Self::frustum(radius, radius, height)
    }

    /// A cone with its base at z = 0 and its apex at z = height.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn cone(radius: f32, height: f32) -> Result<Self, ProfileError> {
        Self::frustum(radius, 0.0, height)
    }

    /// A frustum of a cone, `base` its radius at z = 0, `top` that at z = height. Radii of opposite sign make
    /// a double cone.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn frustum(base: f32, top: f32, height: f32) -> Result<Self, ProfileError> {
        // r = base·(1 − u) + top·u
        Self::quadratic(0.0, height, [base * base, base * top, top * top])
    }

    /// A sphere about the origin.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn sphere(radius: f32) -> Result<Self, ProfileError> {
        Self::spheroid(radius, radius)
    }

    /// A spheroid about the origin: `radius` at its equator, from z = −half_height to z = half_height.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn spheroid(radius: f32, half_height: f32) -> Result<Self, ProfileError> {
        // r² = radius²·4·u·(1 − u)
        Self::quadratic(-half_height, half_height, [0.0, 2.0 * radius * radius, 0.0])
    }

    /// A paraboloid with its apex at the origin, `radius` its radius at z = height.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn paraboloid(radius: f32, height: f32) -> Result<Self, ProfileError> {
        // r² = radius²·u
        let square = radius * radius;
        Self::quadratic(0.0, height, [0.0, 0.5 * square, square])
    }

    /// A hyperboloid of one sheet, like a cooling tower, `waist` its radius at z = 0, `rim` that at z =
    /// ±half_height.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], as [`Profile::from_squared_radii`].
    pub const fn hyperboloid(waist: f32, rim: f32, half_height: f32) -> Result<Self, ProfileError> {
        // r² = waist² + (rim² − waist²)·(2·u − 1)²
        let (waist, rim) = (waist * waist, rim * rim);
        Self::quadratic(-half_height, half_height, [rim, 2.0 * waist - rim, rim])
    }

    /// A quadratic's three ordinates, raised to a cubic's four.
    const fn quadratic(z: f32, top: f32, [q0, q1, q2]: [f32; 3]) -> Result<Self, ProfileError> {
        let ordinates = [q0, (q0 + 2.0 * q1) / 3.0, (2.0 * q1 + q2) / 3.0, q2];
        match Self::from_squared_radii(&[z, top], &ordinates) {
            Ok(profile) => Ok(profile.closed()),
            Err(error) => Err(error),
        }
    }
}
