//! A camera: it turns the columns and rows of a picture into rays.

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
    /// The vector from the picture's middle to the middle of its right edge.
    pub(crate) right: F32x3,
    /// The vector upwards from the picture's middle, as long as `right`.
    pub(crate) up: F32x3,
    pub(crate) projection: Projection,
}

/// How a camera's rays run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum Projection {
    /// All rays start at the eye.
    Perspective,
    /// The rays are parallel, and start in the plane of the eye.
    Orthographic,
}

impl Camera {
    /// A camera whose rays start at `eye`. The half-width is that of the picture at unit distance: the
    /// tangent of half the angle of view.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if the eye is where it looks at, if `up` is zero or along the view, if a number is
    /// infinite or NaN, or if the half-width is below 10⁻⁶, where f32's steps beside 1 are a sixteenth of it,
    /// or above 30, which is an angle of view of 176°.
    pub const fn perspective(
        eye: [f32; 3],
        look_at: [f32; 3],
        up: [f32; 3],
        half_width: f32,
    ) -> Result<Self, SceneError> {
        Self::new([eye, look_at, up], half_width, [1e-6, 30.0], Projection::Perspective)
    }

    /// A camera with parallel rays. The half-width is that of the picture, in the world's unit of length.
    /// What lies behind the plane through the eye is not seen.
    ///
    /// # Errors
    ///
    /// As [`Camera::perspective`], but the half-width may be from 10⁻¹⁵ to 10¹⁵, as the largest radius of a
    /// profile may.
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
        // The sine of the angle between view and up direction must be more than 10⁻⁶. Of a parallel pair
        // rounding leaves 6.5·2⁻²⁴ = 4·10⁻⁷ at most: 2⁻²⁴ each from the difference and from making both unit
        // vectors, 2·√3·2⁻²⁴ from the cross product.
        if !(dot(right, right) > 1e-12) {
            return Err(along);
        }
        let Some(right) = unit(right) else {
            return Err(along);
        };
        let eye = vector(eye);
        Ok(Self {
            eye,
            forward,
            right: scale(right, half_width),
            up: scale(cross(right, forward), half_width),
            projection,
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

    /// From the middle of the picture to the middle of its right edge: as long as the half-width, at a right
    /// angle to the view. A perspective camera's picture is at unit distance from the eye.
    #[must_use]
    pub const fn right(&self) -> [f32; 3] {
        array(self.right)
    }

    /// From the middle of the picture upwards, as long as [`right`](Self::right) and at a right angle to it
    /// and to the view.
    #[must_use]
    pub const fn up(&self) -> [f32; 3] {
        array(self.up)
    }

    /// The ray through the centre of the pixel in column x, row y, of a picture of the given size in pixels;
    /// x and y may lie outside of it. A picture that is no pixel wide has no pixels: any x and y give the ray
    /// through its middle.
    ///
    /// Its t counts in units of the world's along the view: in perspective it is the depth.
    #[must_use]
    pub fn ray(&self, x: u32, y: u32, width: u32, height: u32) -> Ray {
        self.ray_through([x as f32, y as f32], width, height)
    }

    /// As [`Camera::ray`], for a column and a row that need not be whole or positive.
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

/// A row of a picture, and the camera that sees it.
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

    /// A bound on the coordinates, added up, of the origins of the row's rays, if each has an origin of its
    /// own, which is then rounded by itself: the eye's, and the offset of a pixel in the row. Zero if all
    /// rays share the eye.
    pub fn rough(&self) -> f32 {
        let Camera { eye, right, up, projection, .. } = self.camera;
        match projection {
            Projection::Perspective => 0.0,
            Projection::Orthographic => {
                let down = (2.0 * self.y as f32 + 1.0 - self.height as f32) / self.width as f32;
                one_norm(*eye) + one_norm(*right) + one_norm(*up) * down.abs()
            }
        }
    }

    /// The difference between the rays of neighbouring pixels: of their directions in perspective, else of
    /// their origins.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// In pictures of any shape, and in rows below them; with 2⁻²¹ to spare for the rounding of both.
    #[test]
    fn no_origin_of_a_row_is_larger_than_it_says() {
        let camera = Camera::orthographic([3.0, -4.0, 1.0], [0.5, 0.0, 2.0], [0.1, 0.2, 1.0], 0.7).unwrap();
        let mut nearly = 0;
        for (width, height) in [(1, 1), (40, 40), (7, 4000), (4000, 7), (1, 100_000)] {
            for y in [0, height / 3, height - 1, 3 * height] {
                let row = Row { camera: &camera, y, width, height };
                for x in [0, width / 2, width - 1] {
                    let size = one_norm(row.ray(x).origin);
                    assert!(size <= row.rough() * (1.0 + 1.0 / 2_097_152.0), "{size} at {x}, {y}");
                    nearly += u32::from(2.0 * size > row.rough());
                }
            }
        }
        assert!(nearly > 10, "the bound is loose: {nearly}");
        let one_eye = Camera::perspective([3.0, -4.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], 0.3).unwrap();
        assert_eq!(Row { camera: &one_eye, y: 3, width: 7, height: 9 }.rough(), 0.0);
    }
}
