//! A ball that goes round a pawn, in front of it and behind.

use super::{BALL, CLAY, PAWN, VASE_SCENE};
use embedded_lathe::{Pose, Rgb, Rotation, Scene, SceneError, Solid};

/// The pawn, and the ball at an angle in radians.
pub fn orbit(angle: f32) -> Result<[Solid<'static>; 2], SceneError> {
    let [x, y, _] = Rotation::about_z(angle).apply([0.45, 0.0, 0.0]);
    Ok([
        Solid::new(&PAWN, Rgb::new(0.45, 0.6, 0.45)).shiny(15),
        Solid::new(&BALL, CLAY).posed(Pose::new([x, y, 0.5], Rotation::IDENTITY, 0.5)?),
    ])
}

/// What sees them, as the vase is seen.
pub static ORBIT: Scene = VASE_SCENE.with_solids(&[]);
