//! From pixels to rays.

use crate::ray::Ray;
use crate::scene_error::SceneError;
use crate::vector::{F32x3, array, cross, difference, dot, one_norm, scale, unit, vector};

/// A camera: perspective or orthographic.
///
/// Pixels are square. The picture's half-width is given; its half-height follows from the number of pixels.
/// Column 0 is on the left, row 0 at the top, and rays pass through the pixels' centres.
///
/// ```
/// use embedded_lathe::{Camera, valid};
///
/// const FRONT: Camera = valid!(Camera::perspective([0.0, -2.2, 0.9], [0.0, 0.0, 0.5], [0.0, 0.0, 1.0], 0.3));
/// let ray = FRONT.ray(120, 120, 240, 240);
/// assert_eq!(ray.origin(), [0.0, -2.2, 0.9]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub(crate) eye: F32x3,
    /// The unit vector of the view.
    pub(crate) forward: F32x3,
    /// From the picture's centre to the middle of its right edge.
    pub(crate) right: F32x3,
    /// As long, upwards.
    pub(crate) up: F32x3,
    pub(crate) projection: Projection,
    /// Rays have their origins rounded one by one, as numbers of this size are: nothing, if they have one in common.
    pub(crate) rough: f32,
}

/// How a camera's rays run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum Projection {
    /// From the eye.
    Perspective,
    /// Side by side.
    Orthographic,
}

impl Camera {
    /// Rays from `eye`; `half_width` is that of the picture at unit distance, the tangent of half the angle
    /// of view, which 30 makes 176°.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if the eye is where it looks at, `up` is zero or along the view, the half-width not
    /// between 10⁻⁶ and 30, or a number not finite.
    pub const fn perspective(
        eye: [f32; 3],
        look_at: [f32; 3],
        up: [f32; 3],
        half_width: f32,
    ) -> Result<Self, SceneError> {
        Self::new([eye, look_at, up], half_width, [1e-6, 30.0], Projection::Perspective)
    }

    /// Parallel rays; `half_width` is that of the picture, in the world's unit. What is behind the eye's
    /// plane is not seen.
    ///
    /// # Errors
    ///
    /// As [`Camera::perspective`], but the half-width may be from 10⁻¹⁵ to 10¹⁵.
    pub const fn orthographic(
        eye: [f32; 3],
        look_at: [f32; 3],
        up: [f32; 3],
        half_width: f32,
    ) -> Result<Self, SceneError> {
        Self::new([eye, look_at, up], half_width, [1e-15, 1e15], Projection::Orthographic)
    }

    const fn new(
        [eye, look_at, up]: [[f32; 3]; 3],
        half_width: f32,
        [least, most]: [f32; 2],
        projection: Projection,
    ) -> Result<Self, SceneError> {
        if !(half_width >= least && half_width <= most) {
            return Err(SceneError::HalfWidth { half_width, least, most });
        }
        let Some(forward) = unit(difference(vector(look_at), vector(eye))) else {
            return Err(SceneError::ViewDirection { eye, look_at });
        };
        let along = SceneError::UpDirection { up };
        let Some(up) = unit(vector(up)) else {
            return Err(along);
        };
        let right = cross(forward, up);
        // Two unit vectors: what is left of a parallel pair is rounding.
        if !(dot(right, right) > 1e-12) {
            return Err(along);
        }
        let Some(right) = unit(right) else {
            return Err(along);
        };
        let eye = vector(eye);
        // In a picture as much as three times as high as wide.
        let rough = match projection {
            Projection::Perspective => 0.0,
            Projection::Orthographic => one_norm(eye) + 6.0 * half_width,
        };
        Ok(Self {
            eye,
            forward,
            right: scale(right, half_width),
            up: scale(cross(right, forward), half_width),
            projection,
            rough,
        })
    }

    /// Where the camera is.
    #[must_use]
    pub const fn eye(&self) -> [f32; 3] {
        array(self.eye)
    }

    /// The direction of view, a unit vector.
    #[must_use]
    pub const fn forward(&self) -> [f32; 3] {
        array(self.forward)
    }

    /// From the middle of the picture to the middle of its right edge: as long as the half-width, at a right angle to the
    /// view. A perspective camera's picture is at unit distance from the eye.
    #[must_use]
    pub const fn right(&self) -> [f32; 3] {
        array(self.right)
    }

    /// From the middle of the picture upwards, as long as [`right`](Self::right) and at a right angle to it and to the view.
    #[must_use]
    pub const fn up(&self) -> [f32; 3] {
        array(self.up)
    }

    /// The ray through the centre of the pixel in column x, row y, of a picture of the given size in pixels; x and y may lie
    /// outside of it. A picture that is no pixel wide has no pixels: any x and y give the ray through its middle.
    ///
    /// Its t counts in units of the world's along the view: in perspective it is the depth.
    #[must_use]
    pub fn ray(&self, x: u32, y: u32, width: u32, height: u32) -> Ray {
        self.ray_through([x as f32, y as f32], width, height)
    }

    /// As [`Camera::ray`], for a pixel in the given column and row.
    #[inline(always)]
    pub(crate) fn ray_through(&self, [x, y]: [f32; 2], width: u32, height: u32) -> Ray {
        // Over infinity, all distances from the picture's middle are zero.
        let half_pixels = if width == 0 { f32::INFINITY } else { width as f32 };
        // Centres, in half-pixels from the picture's centre: whole numbers.
        let [across, down] =
            [(x, width), (y, height)].map(|(i, of)| (2.0 * i + 1.0 - of as f32) / half_pixels);
        let offset = self.right * across - self.up * down;
        match self.projection {
            Projection::Perspective => Ray::new_unchecked(self.eye, self.forward + offset),
            Projection::Orthographic => Ray::new_unchecked(self.eye + offset, self.forward),
        }
    }
}

/// A row of a picture, as the camera sees it.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    pub camera: &'a Camera,
    pub y: u32,
    pub width: u32,
    pub height: u32,
}

impl Row<'_> {
    /// The ray of pixel i.
    pub fn ray(&self, i: u32) -> Ray {
        self.camera.ray(i, self.y, self.width, self.height)
    }

    /// By how much the next pixel's ray differs: its direction, or, if they run side by side, its origin.
    pub fn step(&self) -> (F32x3, Projection) {
        (self.camera.right * (2.0 / self.width as f32), self.camera.projection)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Camera {
    fn format(&self, f: defmt::Formatter) {
        let (e, d, r) = (self.eye, self.forward, self.right);
        defmt::write!(
            f,
            "Camera {{ eye: ({}, {}, {}), forward: ({}, {}, {}), right: ({}, {}, {}), {} }}",
            e.x,
            e.y,
            e.z,
            d.x,
            d.y,
            d.z,
            r.x,
            r.y,
            r.z,
            self.projection
        );
    }
}
