use super::{Profile, ProfileError};

/// Exact profiles of one segment: quadrics, whose cubic coefficient is zero. Both ends are capped.
///
/// # Errors
///
/// All of these constructors return [`ProfileError::Dimension`] if a height or a radius is not positive and
/// finite; where a function's doc allows it, a radius may be zero. The other errors are those of
/// [`Profile::from_squared_radii`].
impl Profile<1> {
    /// A cylinder from z = 0 to z = height.
    pub const fn cylinder(radius: f32, height: f32) -> Result<Self, ProfileError> {
        if let Err(error) = all_positive([("radius", radius), ("height", height)]) {
            return Err(error);
        }
        Self::cone_between(radius, radius, height)
    }

    /// A cone with its base at z = 0 and its apex at z = height.
    pub const fn cone(radius: f32, height: f32) -> Result<Self, ProfileError> {
        if let Err(error) = all_positive([("radius", radius), ("height", height)]) {
            return Err(error);
        }
        Self::cone_between(radius, 0.0, height)
    }

    /// A frustum of a cone. Its radius is `base` at z = 0 and `top` at z = height. One of the two may be
    /// zero: then it is a cone.
    pub const fn frustum(base: f32, top: f32, height: f32) -> Result<Self, ProfileError> {
        // A radius of zero is not checked, but then the other one must be positive. A negative radius is an
        // error.
        let checked = if base == 0.0 {
            all_positive([("top", top), ("height", height)])
        } else if top == 0.0 {
            all_positive([("base", base), ("height", height)])
        } else {
            all_positive([("base", base), ("top", top), ("height", height)])
        };
        if let Err(error) = checked {
            return Err(error);
        }
        Self::cone_between(base, top, height)
    }

    /// A sphere about the origin, from z = −radius to z = radius.
    pub const fn sphere(radius: f32) -> Result<Self, ProfileError> {
        if let Err(error) = all_positive([("radius", radius)]) {
            return Err(error);
        }
        Self::spheroid(radius, radius)
    }

    /// A spheroid about the origin, from z = −half_height to z = half_height. Its radius at the equator is
    /// `radius`.
    pub const fn spheroid(radius: f32, half_height: f32) -> Result<Self, ProfileError> {
        if let Err(error) = all_positive([("radius", radius), ("half_height", half_height)]) {
            return Err(error);
        }
        // r² = radius²·4·u·(1 − u)
        Self::quadratic(-half_height, half_height, [0.0, 2.0 * radius * radius, 0.0])
    }

    /// A paraboloid with its apex at the origin and its rim at z = height. The radius of the rim is `radius`.
    pub const fn paraboloid(radius: f32, height: f32) -> Result<Self, ProfileError> {
        if let Err(error) = all_positive([("radius", radius), ("height", height)]) {
            return Err(error);
        }
        // r² = radius²·u
        let square = radius * radius;
        Self::quadratic(0.0, height, [0.0, 0.5 * square, square])
    }

    /// A hyperboloid of one sheet, like a cooling tower. Its radius is `waist` at z = 0 and `rim` at z =
    /// ±half_height. If `waist` is zero, the shape is a double cone; if it is larger than `rim`, a barrel,
    /// which is a zone of a spheroid.
    pub const fn hyperboloid(waist: f32, rim: f32, half_height: f32) -> Result<Self, ProfileError> {
        let checked = if waist == 0.0 {
            all_positive([("rim", rim), ("half_height", half_height)])
        } else {
            all_positive([("waist", waist), ("rim", rim), ("half_height", half_height)])
        };
        if let Err(error) = checked {
            return Err(error);
        }
        // r² = waist² + (rim² − waist²)·(2·u − 1)²
        let (waist, rim) = (waist * waist, rim * rim);
        Self::quadratic(-half_height, half_height, [rim, 2.0 * waist - rim, rim])
    }

    /// The frustum, cylinder or cone from z = 0 to z = height. Its dimensions are not checked here.
    const fn cone_between(base: f32, top: f32, height: f32) -> Result<Self, ProfileError> {
        // r = base·(1 − u) + top·u
        Self::quadratic(0.0, height, [base * base, base * top, top * top])
    }

    /// The profile from z to `top`, both ends capped, whose squared radius is the quadratic with these three
    /// Bernstein ordinates. They are converted to a cubic's four (degree elevation).
    const fn quadratic(z: f32, top: f32, [q0, q1, q2]: [f32; 3]) -> Result<Self, ProfileError> {
        let ordinates = [q0, (q0 + 2.0 * q1) / 3.0, (2.0 * q1 + q2) / 3.0, q2];
        match Self::from_squared_radii(&[z, top], &ordinates) {
            Ok(profile) => Ok(profile.closed()),
            Err(error) => Err(error),
        }
    }
}

/// `Ok` if all of the parameters are positive and finite; otherwise [`ProfileError::Dimension`] with the name
/// and the value of the first that is not.
const fn all_positive<const N: usize>(parameters: [(&'static str, f32); N]) -> Result<(), ProfileError> {
    let mut i = 0;
    while i < N {
        let (name, value) = parameters[i];
        if !(value > 0.0 && value < f32::INFINITY) {
            return Err(ProfileError::Dimension { name, value });
        }
        i += 1;
    }
    Ok(())
}
