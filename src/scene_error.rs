use core::fmt;

/// What keeps numbers from being part of a scene.
///
/// ```
/// use embedded_lathe::{Light, SceneError};
/// assert_eq!(Light::new([0.0; 3], 0.15), Err(SceneError::LightDirection));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SceneError {
    /// A coordinate of a position is not finite.
    Position,
    /// A rotation's axis is zero, or its angle larger than 10 000 radians or not a number.
    Rotation,
    /// A solid's scale is not between 10⁻³⁰ and 10³⁰.
    Scale,
    /// A camera looks nowhere: its eye is where it looks at, or one of the two is not finite.
    ViewDirection,
    /// A camera's up direction is zero or along its view.
    UpDirection,
    /// A camera's half-width is not between 10⁻⁶ and 30, or, if its rays are parallel, 10⁻¹⁵ and 10¹⁵.
    HalfWidth,
    /// A light's direction is zero or not finite.
    LightDirection,
    /// An ambient share is outside [0, 1].
    Ambient,
}

impl SceneError {
    const fn text(self) -> &'static str {
        match self {
            Self::Position => "a coordinate of the position is not finite",
            Self::Rotation => "the rotation's axis is zero or its angle not within 1e4",
            Self::Scale => "the scale is not between 1e-30 and 1e30",
            Self::ViewDirection => "the camera's eye is where it looks at, or not finite",
            Self::UpDirection => "the camera's up direction is zero or along its view",
            Self::HalfWidth => "the camera's half-width is not between 1e-6 and 30, or 1e-15 and 1e15",
            Self::LightDirection => "the light's direction is zero or not finite",
            Self::Ambient => "the ambient share is not between 0 and 1",
        }
    }

    /// Stops the compilation with the message. Called by [`valid!`](crate::valid).
    #[doc(hidden)]
    #[track_caller]
    pub const fn stop(self) -> ! {
        crate::valid::stop(self.text(), None)
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

impl core::error::Error for SceneError {}
