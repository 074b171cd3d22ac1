//! A knob with a pointer on it. Turned about its axis a knob alone looks the same as before.

use super::{DAYLIGHT, KNOB, KNOB_SCENE, SKY};
use embedded_lathe::{Lathe, Pose, Profile, Rgb, Rotation, Scene, SceneError, Segment, Solid, valid};

/// A flat pointer, an ellipse seen from above: four times as long as it is wide.
static POINTER: Lathe<[Segment; 1]> =
    Lathe::turn(valid!(Profile::cylinder(0.045, 0.03)?.squash(0.0625)?.closed()));

/// Where it lies on the knob, whose flat top is at the height 0.38.
const ON_THE_KNOB: Pose = valid!(Pose::new([0.23, 0.0, 0.38], Rotation::IDENTITY, 1.0));

/// The knob and its pointer, turned by an angle in radians.
pub fn dial(angle: f32) -> Result<[Solid<'static>; 2], SceneError> {
    let knob = Pose::new([0.0; 3], Rotation::about_z(angle), 1.0)?;
    Ok([
        Solid::new(&KNOB, Rgb::gray(0.75)).posed(knob).shiny(20),
        Solid::new(&POINTER, Rgb::new(0.85, 0.25, 0.15)).posed(ON_THE_KNOB.then(knob)?),
    ])
}

/// What sees it, as the knob is seen.
pub static DIAL: Scene = KNOB_SCENE.with_solids(&[]).with_light(DAYLIGHT).with_background(SKY);
