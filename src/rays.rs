//! The rays of a row of pixels.

use crate::camera::{Camera, Projection};
use crate::ray::Ray;
use crate::vector::F32x3;

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

    /// All of them, but for rounding.
    #[inline(always)]
    pub fn rays(&self) -> Rays {
        let Camera { eye, forward, right, up, projection } = *self.camera;
        let per_width = 1.0 / self.width as f32;
        let down = (2.0 * self.y as f32 + 1.0 - self.height as f32) * per_width;
        let (first, step) = (right * (per_width - 1.0) - up * down, right * (per_width + per_width));
        let none = F32x3::default();
        match projection {
            Projection::Perspective => {
                Rays { origin: eye, origin_step: none, direction: forward + first, direction_step: step }
            }
            Projection::Orthographic => {
                Rays { origin: eye + first, origin_step: step, direction: forward, direction_step: none }
            }
        }
    }
}

/// The rays of neighbouring pixels: origin and direction are linear in the pixel's number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    pub origin: F32x3,
    pub origin_step: F32x3,
    pub direction: F32x3,
    pub direction_step: F32x3,
}

impl Rays {
    /// Origin and direction of pixel i.
    #[inline(always)]
    pub fn at(&self, i: u32) -> (F32x3, F32x3) {
        let i = i as f32;
        (self.origin + self.origin_step * i, self.direction + self.direction_step * i)
    }
}
