//! A knob with a pointer on it. Turned about its axis a knob alone looks the same as before.

use super::{DAYLIGHT, KNOB, KNOB_SCENE, SKY};
use embedded_lathe::{Lathe, Pose, Profile, Rgb, Rotation, Scene, SceneError, Segment, Solid, valid};

/// A pointer: a thin spheroid.
static POINTER: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::spheroid(0.045, 0.17)));

/// Where it lies on the knob, whose flat top is at the height 0.38: along a radius, a hair above, so that a plane parts the two.
const ON_THE_KNOB: Pose =
    valid!(Pose::new([0.24, 0.0, 0.426], Rotation::about_y(core::f32::consts::FRAC_PI_2), 1.0));

/// The knob and its pointer, turned by an angle in radians. The knob itself is left as it is: turned about its axis it looks the
/// same, and rows whose halves mirror each other cost half.
pub fn dial(angle: f32) -> Result<[Solid<'static>; 2], SceneError> {
    let turned = Pose::new([0.0; 3], Rotation::about_z(angle), 1.0)?;
    Ok([
        Solid::new(&KNOB, Rgb::gray(0.75)).shiny(20),
        Solid::new(&POINTER, Rgb::new(0.85, 0.25, 0.15)).posed(ON_THE_KNOB.then(turned)?),
    ])
}

/// What sees it, as the knob is seen.
pub static DIAL: Scene = KNOB_SCENE.with_solids(&[]).with_light(DAYLIGHT).with_background(SKY);
