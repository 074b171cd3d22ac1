//! One directional light.

use crate::arithmetic::Share;
use crate::math::minmax::greater;
use crate::scene_error::SceneError;
use crate::vector::{F32x3, array, unit, vector};

/// A light from far away, and an ambient share that reaches everywhere. Solids cast no shadows: the light
/// falls on every surface that faces it.
///
/// A surface shows the share `ambient + (1 − ambient)·max(0, n·l)` of its color (Lambert's law), where n is
/// its unit normal and l the unit vector towards the light. Where the light falls on a shiny surface, a
/// highlight of white is added: its share is half of Phong's `max(0, r·v)ˢ`, where r is l
/// mirrored by the surface, v the unit vector towards the eye, and s the shininess. It does not depend on the
/// ambient share.
///
/// ```
/// use embedded_lathe::{Light, valid};
/// const LAMP: Light = valid!(Light::new([-0.5, -0.7, 0.5], 0.15));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The unit vector towards the light.
    pub(crate) towards: F32x3,
    ambient: f32,
    /// The ambient share.
    pub(crate) everywhere: Share,
    /// The share of the light itself: what the ambient one leaves of 1.
    pub(crate) direct: f32,
}

/// The share that a light has at least, beside the ambient one: without a share its direction would be lost.
const LEAST_DIRECT: f32 = 1.0 / 1_048_576.0;

/// By this factor a light's share is less than what the ambient one leaves, so that the sum of both is at
/// most 1 where the light falls along the normal. In floats the cosine is off by 2⁻²⁰ for its inverse root,
/// and by ten roundings of 2⁻²⁴ at most.
const SHORTENED: f32 = 1.0 - 1.0 / 524_288.0;

impl Light {
    /// A light and its ambient share, from 0 to 1. The vector `towards` points from the solids to the light;
    /// its length does not matter.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if the direction is zero, infinite or NaN, or if the share is outside 0 to 1 or NaN.
    pub const fn new(towards: [f32; 3], ambient: f32) -> Result<Self, SceneError> {
        if !(ambient >= 0.0 && ambient <= 1.0) {
            return Err(SceneError::Ambient { ambient });
        }
        match unit(vector(towards)) {
            Some(unit) => {
                let direct = greater(LEAST_DIRECT, 1.0 - ambient);
                let everywhere = Share::of_one(1.0 - direct);
                Ok(Self { towards: unit, ambient, everywhere, direct: direct * SHORTENED })
            }
            None => Err(SceneError::LightDirection { towards }),
        }
    }

    /// The direction towards the light, a unit vector.
    #[must_use]
    pub const fn towards(&self) -> [f32; 3] {
        array(self.towards)
    }

    /// The share of light that reaches every point of a surface, 0 to 1.
    #[must_use]
    pub const fn ambient(&self) -> f32 {
        self.ambient
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Light {
    fn format(&self, f: defmt::Formatter) {
        let l = self.towards;
        defmt::write!(f, "Light {{ towards: ({}, {}, {}), ambient: {} }}", l.x, l.y, l.z, self.ambient);
    }
}
