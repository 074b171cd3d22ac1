//! Where a solid stands, how it is turned, and how large it is.

mod rotation;

pub use rotation::Rotation;

use crate::scene_error::SceneError;
use crate::vector::{F32x3, array, difference, finite, scale, sum, vector};

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
    /// [`SceneError`] if a coordinate is infinite or NaN, if the rotation was made from an angle that is NaN
    /// or outside −10 000 to 10 000, or if the scale is outside 10⁻³⁰ to 10³⁰. (Within these limits the
    /// inverse of the scale is a normal number, too.)
    pub const fn new(position: [f32; 3], rotation: Rotation, scale: f32) -> Result<Self, SceneError> {
        if !finite(vector(position)) {
            return Err(SceneError::Position { position });
        }
        let (rows, mut row) = (rotation.rows(), 0);
        while row < 3 {
            if !finite(vector(rows[row])) {
                return Err(SceneError::Rotation { row, elements: rows[row] });
            }
            row += 1;
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

    /// The pose that turns about a point of the world, the pivot, which stays where it is.
    ///
    /// ```
    /// use embedded_lathe::{Pose, Rotation, valid};
    ///
    /// // A lid, and the same opened by 0.6 about its hinge.
    /// const LID: Pose = valid!(Pose::new([0.0, 0.0, 0.5], Rotation::IDENTITY, 0.8));
    /// const OPEN: Pose = valid!(LID.then(valid!(Pose::about([0.0, 0.5, 0.5], Rotation::about_x(-0.6))))?);
    /// let [_, _, z] = OPEN.position();
    /// assert!((z - (0.5 + 0.5 * 0.6_f32.sin())).abs() < 1e-6);
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Pose::new`], for the position where the origin is turned to and for the rotation.
    pub const fn about(pivot: [f32; 3], rotation: Rotation) -> Result<Self, SceneError> {
        // An infinite or NaN pivot, or a rotation with NaN, makes the position below NaN. This check returns
        // the error that names the one at fault.
        if let Err(error) = Self::new(pivot, rotation, 1.0) {
            return Err(error);
        }
        Self::new(array(difference(vector(pivot), rotation.turn(vector(pivot)))), rotation, 1.0)
    }

    /// The pose that does this one first, and then another. If `next` is the pose of a whole, and this one
    /// that of a part in the whole's own space, the result is the part's pose in the world.
    ///
    /// ```
    /// use embedded_lathe::{Pose, Rotation, valid};
    ///
    /// const POINTER: Pose = valid!(Pose::new([0.0, 0.3, 0.4], Rotation::IDENTITY, 1.0));
    /// let knob = Pose::new([2.0, 0.0, 0.0], Rotation::about_z(1.0), 0.5)?;
    /// let pointer = POINTER.then(knob)?;
    /// assert_eq!(pointer.apply([0.0; 3]), knob.apply([0.0, 0.3, 0.4]));
    /// # Ok::<(), embedded_lathe::SceneError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Pose::new`], for the position and the scale of the result.
    pub const fn then(self, next: Self) -> Result<Self, SceneError> {
        Self::new(next.apply(self.position()), self.rotation.then(next.rotation), self.scale * next.scale)
    }

    /// The pose that leads back: this one, then its inverse, is the identity, except for rounding.
    ///
    /// # Errors
    ///
    /// [`SceneError::Position`] if the position divided by the scale is beyond f32's range.
    pub const fn inverse(self) -> Result<Self, SceneError> {
        let back = scale(self.rotation.back(self.position), -1.0);
        let per_scale = 1.0 / self.scale;
        // The scale is never out of range: its limits, as f32 numbers, are exactly each other's rounded
        // inverse.
        Self::new(array(scale(back, per_scale)), self.rotation.inverse(), per_scale)
    }

    /// The point of the world where the solid has a point of its own space. A coordinate beyond f32's range
    /// is infinite.
    #[must_use]
    pub const fn apply(&self, point: [f32; 3]) -> [f32; 3] {
        array(sum(self.position, scale(self.rotation.turn(vector(point)), self.scale)))
    }

    /// Converts a point of the world to the solid's own space.
    #[inline]
    pub(crate) const fn point_into(&self, world: F32x3) -> F32x3 {
        scale(self.rotation.back(difference(world, self.position)), 1.0 / self.scale)
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
