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
    /// its half-width and of its half-height left free on each side. It looks in the same direction as
    /// before.
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
    /// is endless; [`SceneError::HalfWidth`] and [`SceneError::Position`] if the new camera's half-width or
    /// eye is out of range.
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

    /// [`Camera::framing`] of a perspective camera, for a picture whose height is `aspect` times its width.
    ///
    /// The new eye is E + x·R + y·U + z·F, where E is the old one, F the unit vector forward, and R and U the
    /// vectors to the right and up, of the half-width's length h. With v = P − E, a point P lies left of the
    /// picture's right edge if `v·R − x·h² ≤ h²·(v·F − z)`, that is `h²·z ≤ x·h² − v·(R − h²·F)`. The point
    /// with the largest v·(R − h²·F) sets the limit for z. The left edge sets another, by −R instead of R and
    /// −x instead of x. The sum of the two limits does not depend on x, so z is largest where they are equal,
    /// which gives x. The upper and the lower edge give y and a limit for z in the same way, by
    /// `v·U − y·h² ≤ aspect·h²·(v·F − z)`. The smaller of the two limits for z is taken.
    const fn framing_near(self, solids: &[Solid], aspect: f32) -> Result<Self, SceneError> {
        let square = dot(self.right, self.right);
        // The factors of v·F − z, h² and aspect·h², made smaller by the share that stays free.
        let (wide, high) = (square * (1.0 - FREE), square * (1.0 - FREE) * aspect);
        let [right, left] = self.reaches(solids, self.right, scale(self.forward, -wide));
        let [top, bottom] = self.reaches(solids, self.up, scale(self.forward, -high));
        let (by_width, by_height) = (-0.5 * (right + left) / wide, -0.5 * (top + bottom) / high);
        let ahead = if by_width < by_height { by_width } else { by_height };
        let [x, y] = [0.5 * (right - left) / square, 0.5 * (top - bottom) / square];
        self.moved(x, y, ahead)
    }

    /// [`Camera::framing`] of an orthographic camera, for a picture whose height is `aspect` times its width.
    const fn framing_flat(self, solids: &[Solid], aspect: f32) -> Result<Self, SceneError> {
        const ZERO: F32x3 = F32x3 { x: 0.0, y: 0.0, z: 0.0 };
        let square = dot(self.right, self.right);
        let [right, left] = self.reaches(solids, self.right, ZERO);
        let [top, bottom] = self.reaches(solids, self.up, ZERO);
        let [far, near] = self.reaches(solids, self.forward, ZERO);
        // The half-widths that the solids' width and their height ask for, in units of the present
        // half-width.
        let (wide, high) = (0.5 * (right + left) / square, 0.5 * (top + bottom) / (square * aspect));
        let half = (if wide > high { wide } else { high }) / (1.0 - FREE);
        let [x, y] = [0.5 * (right - left) / square, 0.5 * (top - bottom) / square];
        // The eye's plane lies before the nearest point, at a distance that is the depth of all solids
        // together.
        match self.moved(x, y, -near - (far + near)) {
            Ok(moved) => moved.widened(half),
            Err(error) => Err(error),
        }
    }

    /// The largest dot product of `along + bias` with the vectors from the eye to the points of the solids,
    /// and that of `−along + bias`. Each solid counts as the cylinder around it.
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

    /// This camera with its eye moved by x to the right and y upwards, in half-widths, and by z forward.
    /// [`SceneError::Position`] if a coordinate of the new eye is infinite or NaN.
    const fn moved(self, x: f32, y: f32, z: f32) -> Result<Self, SceneError> {
        let across = sum(scale(self.right, x), scale(self.up, y));
        let eye = sum(self.eye, sum(across, scale(self.forward, z)));
        if finite(eye) {
            Ok(Self::of(eye, self.forward, [self.right, self.up], self.projection))
        } else {
            Err(SceneError::Position { position: array(eye) })
        }
    }
}
