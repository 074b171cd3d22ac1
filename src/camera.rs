//! A camera: it turns the columns and rows of a picture into rays.

use crate::math::const_fn;
use crate::math::minmax::greater;
use crate::ray::Ray;
use crate::scene_error::SceneError;
use crate::vector::{F32x3, array, cross, difference, dot, one_norm, scale, sum, unit, vector};

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
    /// Where the camera is.
    pub(crate) eye: F32x3,
    /// The unit vector of the view.
    pub(crate) forward: F32x3,
    /// The vector from the picture's middle to the middle of its right edge.
    pub(crate) right: F32x3,
    /// The vector upwards from the picture's middle, as long as `right`.
    pub(crate) up: F32x3,
    /// Whether the rays meet in the eye or are parallel.
    pub(crate) projection: Projection,
    /// An upper bound of |x| + |y| + |z| over the origins of a square picture's rays, for the rounding of
    /// each; zero if all rays start at the eye, which is not rounded.
    origin_bound: f32,
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

/// The least and the largest half-width of an orthographic camera.
const ORTHOGRAPHIC: [f32; 2] = [1e-15, 1e15];

impl Camera {
    /// A camera whose rays start at `eye`. `half_width` is half the width of the picture at unit distance
    /// from the eye: the tangent of half the horizontal angle of view.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if `eye` and `look_at` are the same point, if `up` is zero or parallel to the view, if
    /// a number is infinite or NaN, or if the half-width is outside 10⁻⁶ to 30. At 10⁻⁶ the spacing of f32
    /// numbers just below 1 is already a sixteenth of the half-width; 30 is an angle of view of 176°.
    pub const fn perspective(
        eye: [f32; 3],
        look_at: [f32; 3],
        up: [f32; 3],
        half_width: f32,
    ) -> Result<Self, SceneError> {
        Self::new([eye, look_at, up], half_width, [1e-6, 30.0], Projection::Perspective)
    }

    /// A camera with parallel rays, which start in the plane through the eye at a right angle to the view:
    /// the camera does not see what lies behind that plane. `half_width` is half the width of the picture, in
    /// the world's unit of length.
    ///
    /// # Errors
    ///
    /// The same as those of [`Camera::perspective`], but the half-width may be from 10⁻¹⁵ to 10¹⁵, the limits
    /// of a profile's largest radius.
    pub const fn orthographic(
        eye: [f32; 3],
        look_at: [f32; 3],
        up: [f32; 3],
        half_width: f32,
    ) -> Result<Self, SceneError> {
        Self::new([eye, look_at, up], half_width, ORTHOGRAPHIC, Projection::Orthographic)
    }

    /// This camera, which must be orthographic, with its half-width times `factor`. [`SceneError::HalfWidth`]
    /// if that is outside the limits.
    pub(crate) const fn widened(self, factor: f32) -> Result<Self, SceneError> {
        let half_width = factor * const_fn::sqrt(dot(self.right, self.right));
        let [least, most] = ORTHOGRAPHIC;
        if !(half_width >= least && half_width <= most) {
            return Err(SceneError::HalfWidth { half_width, least, most });
        }
        let Self { eye, forward, right, up, projection, .. } = self;
        Ok(Self::of(eye, forward, [scale(right, factor), scale(up, factor)], projection))
    }

    /// A camera of either kind; `least` and `most` are the limits of its half-width.
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
        // The sine of the angle between the view and the up direction must be more than 10⁻⁶. For a parallel
        // pair the computed sine is not zero, but at most 6.5·2⁻²⁴ = 4·10⁻⁷, because of rounding: 2⁻²⁴ comes
        // from the difference, 2⁻²⁴ from each of the two unit vectors, and 2·√3·2⁻²⁴ from the cross product.
        if !(dot(right, right) > 1e-12) {
            return Err(along);
        }
        let Some(right) = unit(right) else {
            return Err(along);
        };
        let up = scale(cross(right, forward), half_width);
        Ok(Self::of(vector(eye), forward, [scale(right, half_width), up], projection))
    }

    /// The camera of these vectors.
    pub(crate) const fn of(
        eye: F32x3,
        forward: F32x3,
        [right, up]: [F32x3; 2],
        projection: Projection,
    ) -> Self {
        let origin_bound = match projection {
            Projection::Perspective => 0.0,
            Projection::Orthographic => one_norm(eye) + one_norm(right) + one_norm(up),
        };
        Self { eye, forward, right, up, projection, origin_bound }
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

    /// The vector from the middle of the picture to the middle of its right edge. It is as long as the
    /// half-width, and at a right angle to the view. A perspective camera's picture is at unit distance from
    /// the eye.
    #[must_use]
    pub const fn right(&self) -> [f32; 3] {
        array(self.right)
    }

    /// The vector upwards from the middle of the picture. It is as long as [`right`](Self::right), and at a
    /// right angle to it and to the view.
    #[must_use]
    pub const fn up(&self) -> [f32; 3] {
        array(self.up)
    }

    /// The ray through the centre of the pixel in column x, row y, of a picture of the given size in pixels;
    /// x and y may lie outside of it. If `width` is 0, every x and y give the ray through the middle of the
    /// picture.
    ///
    /// The ray's direction has length 1 along the view. So a hit's t is its depth: the distance, measured
    /// along the view, from the plane through the eye.
    #[must_use]
    pub fn ray(&self, x: u32, y: u32, width: u32, height: u32) -> Ray {
        self.ray_through([x as f32, y as f32], width, height)
    }

    /// Where a point of the world is seen in a picture of the given size in pixels: the column and the row,
    /// as fractions, counted as [`Camera::ray`] counts them, so that the centre of a pixel is at whole
    /// numbers. They may lie outside the picture. Solids that hide the point are not looked at.
    ///
    /// `None` if the point is behind the camera or in the plane through the eye, if the picture is 0 pixels
    /// wide, or if the point or one of the two results is not finite.
    ///
    /// ```
    /// use embedded_lathe::{Camera, valid};
    ///
    /// const FRONT: Camera = valid!(Camera::perspective([0.0, -2.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 0.5));
    /// assert_eq!(FRONT.project([0.0; 3], 240, 240), Some([119.5, 119.5]));
    /// assert_eq!(FRONT.project([1.0, 0.0, 0.5], 240, 240), Some([239.5, 59.5]));
    /// assert_eq!(FRONT.project([0.0, -3.0, 0.0], 240, 240), None);
    /// ```
    #[must_use]
    pub const fn project(&self, point: [f32; 3], width: u32, height: u32) -> Option<[f32; 2]> {
        let to_point = difference(vector(point), self.eye);
        let depth = dot(to_point, self.forward);
        let square = dot(self.right, self.right) * if self.is_perspective() { depth } else { 1.0 };
        let half_pixels = 0.5 * width as f32 / square;
        let x = dot(to_point, self.right) * half_pixels + (0.5 * width as f32 - 0.5);
        let y = (0.5 * height as f32 - 0.5) - dot(to_point, self.up) * half_pixels;
        if depth > 0.0 && width > 0 && x.is_finite() && y.is_finite() { Some([x, y]) } else { None }
    }

    /// Whether the rays meet in the eye.
    pub(crate) const fn is_perspective(&self) -> bool {
        matches!(self.projection, Projection::Perspective)
    }

    /// Does what [`Camera::ray`] does, for a column and a row that may be fractions and negative.
    #[inline(always)]
    pub(crate) const fn ray_through(&self, [x, y]: [f32; 2], width: u32, height: u32) -> Ray {
        // Divided by infinity, the distances of all pixels from the picture's middle are zero.
        let half_pixels = if width == 0 { f32::INFINITY } else { width as f32 };
        // The pixel's centre, counted in half-pixels from the picture's centre, is a whole number.
        let across = (2.0 * x + 1.0 - width as f32) / half_pixels;
        let down = (2.0 * y + 1.0 - height as f32) / half_pixels;
        let offset = difference(scale(self.right, across), scale(self.up, down));
        match self.projection {
            Projection::Perspective => Ray::new_unchecked(self.eye, sum(self.forward, offset)),
            Projection::Orthographic => Ray::new_unchecked(sum(self.eye, offset), self.forward),
        }
    }
}

/// A row of a picture, and the camera that sees it.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    /// The camera that sees the row.
    pub camera: &'a Camera,
    /// The row's number, 0 at the top.
    pub y: u32,
    /// How many pixels the picture is wide.
    pub width: u32,
    /// How many pixels the picture is high.
    pub height: u32,
}

impl Row<'_> {
    /// The ray through the centre of the pixel in a column of row y of the picture; both may be fractions.
    #[inline(always)]
    pub const fn ray(&self, column: f32, y: f32) -> Ray {
        self.camera.ray_through([column, y], self.width, self.height)
    }

    /// An upper bound of |x| + |y| + |z| over the origins of the row's rays, for the rounding of each origin.
    /// In orthographic view each ray has an origin of its own: the eye plus the pixel's offset, rounded. In
    /// perspective all rays start at the eye, which is not rounded; then the result is zero.
    #[inline(always)]
    pub const fn origin_bound(&self) -> f32 {
        let down = (2.0 * self.y as f32 + 1.0 - self.height as f32) / self.width as f32;
        self.camera.origin_bound * greater(1.0, down.abs())
    }

    /// How many rows the row is below the picture's middle.
    #[inline(always)]
    pub const fn below_middle(&self) -> f32 {
        self.y as f32 + 0.5 - 0.5 * self.height as f32
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
                    let size = one_norm(camera.ray(x, y, width, height).origin);
                    assert!(size <= row.origin_bound() * (1.0 + 1.0 / 2_097_152.0), "{size} at {x}, {y}");
                    nearly += u32::from(2.0 * size > row.origin_bound());
                }
            }
        }
        assert!(nearly > 10, "the bound is loose: {nearly}");
        let one_eye = Camera::perspective([3.0, -4.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], 0.3).unwrap();
        assert_eq!(Row { camera: &one_eye, y: 3, width: 7, height: 9 }.origin_bound(), 0.0);
    }
}
