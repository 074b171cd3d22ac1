//! A camera moved so that its picture holds given solids.

use crate::camera::{Camera, Projection};
use crate::scene_error::SceneError;
use crate::solid::Solid;
use crate::vector::{F32x3, array, difference, dot, finite, scale, sum};

/// What share of the picture's half-width, and of its half-height, stays free on each side. The value is a
/// choice; it is larger than any rounding.
const FREE: f32 = 1.0 / 32.0;

impl Camera {
    /// This camera moved so that a picture of the given size in pixels holds the solids, a thirty-second of
    /// its half-width and of its half-height left free on each side. It looks in the same direction as before.
    ///
    /// A perspective camera keeps its angle of view and moves nearer or farther. An orthographic one gets
    /// another half-width; its eye is placed before all the solids. A solid counts as the cylinder around it,
    /// with the height and the largest radius of its outline, so one that does not fill its cylinder is drawn
    /// a little smaller than it might be.
    ///
    /// ```
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(2.5)));
    /// static BALLS: [Solid; 1] = [Solid::new(&BALL, Rgb::WHITE)];
    /// static SCENE: Scene = Scene::new(
    ///     &BALLS,
    ///     valid!(Camera::perspective([0.0, -1.0, 0.5], [0.0; 3], [0.0, 0.0, 1.0], 0.4)?.framing(&BALLS, 240, 135)?),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let covered = SCENE.picture(240, 135).covered();
    /// assert!(covered.top_left.y > 0 && covered.size.height > 90 && covered.size.height < 135);
    /// ```
    ///
    /// # Errors
    ///
    /// [`SceneError::NothingToFrame`] if there are no solids or no pixels; [`SceneError::Endless`] if a solid
    /// is endless; [`SceneError::HalfWidth`] and [`SceneError::Position`] if the new camera's half-width or eye
    /// is out of range.
    pub const fn framing(self, solids: &[Solid], width: u32, height: u32) -> Result<Self, SceneError> {
        if solids.is_empty() || width == 0 || height == 0 {
            return Err(SceneError::NothingToFrame { solids: solids.len(), width, height });
        }
        let mut i = 0;
        while i < solids.len() {
            if !(solids[i].radius() < f32::INFINITY) {
                return Err(SceneError::Endless { solid: i });
            }
            i += 1;
        }
        match self.projection {
            Projection::Perspective => self.framing_near(solids, height as f32 / width as f32),
            Projection::Orthographic => self.framing_flat(solids, height as f32 / width as f32),
        }
    }

    /// Of a perspective camera, for a picture whose height is `aspect` times its width.
    ///
    /// The new eye is E + x·R + y·U + z·F, with F forward, and R and U of the half-width's length h. A point P
    /// lies left of the picture's right edge if, with v = P − E, `v·R − x·h² ≤ h²·(v·F − z)`, which bounds z
    /// by x and by the largest `v·(R − h²·F)`; and likewise at the other three edges. The largest z that all
    /// four allow is taken, with the x and the y at which opposite edges allow the same.
    const fn framing_near(self, solids: &[Solid], aspect: f32) -> Result<Self, SceneError> {
        let square = dot(self.right, self.right);
        // h² times the half-width, or the half-height, that may be filled, in half-widths.
        let (wide, high) = (square * (1.0 - FREE), square * (1.0 - FREE) * aspect);
        let [right, left] = self.reaches(solids, self.right, scale(self.forward, -wide));
        let [top, bottom] = self.reaches(solids, self.up, scale(self.forward, -high));
        let (by_width, by_height) = (-0.5 * (right + left) / wide, -0.5 * (top + bottom) / high);
        let ahead = if by_width < by_height { by_width } else { by_height };
        let [x, y] = [0.5 * (right - left) / square, 0.5 * (top - bottom) / square];
        self.moved(x, y, ahead)
    }

    /// Of an orthographic camera.
    const fn framing_flat(self, solids: &[Solid], aspect: f32) -> Result<Self, SceneError> {
        const NONE: F32x3 = F32x3 { x: 0.0, y: 0.0, z: 0.0 };
        let square = dot(self.right, self.right);
        let [right, left] = self.reaches(solids, self.right, NONE);
        let [top, bottom] = self.reaches(solids, self.up, NONE);
        let [far, near] = self.reaches(solids, self.forward, NONE);
        // In half-widths of the camera as it is.
        let (wide, high) = (0.5 * (right + left) / square, 0.5 * (top + bottom) / (square * aspect));
        let half = (if wide > high { wide } else { high }) / (1.0 - FREE);
        let [x, y] = [0.5 * (right - left) / square, 0.5 * (top - bottom) / square];
        // The nearest point is as far before the plane of the eye as the solids are deep.
        match self.moved(x, y, -near - (far + near)) {
            Ok(moved) => moved.widened(half),
            Err(error) => Err(error),
        }
    }

    /// How far the solids reach from the eye in the directions `along + bias` and `−along + bias`: the largest
    /// products with the vectors to their points.
    const fn reaches(&self, solids: &[Solid], along: F32x3, bias: F32x3) -> [f32; 2] {
        let directions = [sum(along, bias), difference(bias, along)];
        let (mut reaches, mut i) = ([f32::NEG_INFINITY; 2], 0);
        while i < solids.len() {
            let mut side = 0;
            while side < 2 {
                let n = directions[side];
                let reach = dot(n, solids[i].center_from(self.eye)) + solids[i].support(n);
                if !(reach < reaches[side]) {
                    reaches[side] = reach;
                }
                side += 1;
            }
            i += 1;
        }
        reaches
    }

    /// With its eye moved by x to the right and y upwards, in half-widths, and by z forward.
    const fn moved(self, x: f32, y: f32, z: f32) -> Result<Self, SceneError> {
        let across = sum(scale(self.right, x), scale(self.up, y));
        let eye = sum(self.eye, sum(across, scale(self.forward, z)));
        if finite(eye) {
            Ok(Self { eye, ..self })
        } else {
            Err(SceneError::Position { position: array(eye) })
        }
    }
}
