//! What the panel shows: the firmware draws it there, `laboratory/tests/panel.rs` on the host, and both must agree.

use core::f32::consts::TAU;
use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use embedded_lathe::{
    Background, Camera, Lathe, Light, Pose, Profile, Rgb, Rotation, Scene, Segment, Sheet, Solid, valid,
};

include!("vase.rs");

/// What there is to see.
pub const TITLE: &[u8] =
    b"On the board's panel, 128 by 64 pixels in 16 grays: the vase of examples/outlines/vase.svg, swung about.\n";

/// The names of the scenes.
pub const NAMES: [&[u8]; 1] = [b"drawing"];

/// A turn.
pub const FRAMES: u32 = 24;

/// How high the drawing is, in millimeters.
const HEIGHT: f32 = 86.5;

const CAMERA: Camera = valid!(Camera::perspective([0.0, -2.2, 0.6], [0.0; 3], [0.0, 0.0, 1.0], 0.58));
const LIGHT: Light = valid!(Light::new([-0.5, -0.7, 0.5], 0.15));

/// Draws frame `n`; `None` for a name that is not there or a display that fails.
pub fn draw<D: DrawTarget<Color = Gray4>>(name: &[u8], n: u32, display: &mut D) -> Option<()> {
    let angle = (n % FRAMES) as f32 * (TAU / FRAMES as f32);
    let turn = Rotation::about_x(0.6).then(Rotation::about_z(angle));
    let pose = Pose::new(turn.apply([0.0, 0.0, -0.5]), turn, 1.0 / HEIGHT).ok()?;
    let background = Background::Gradient { top: Rgb::gray(0.05), bottom: Rgb::gray(0.25) };
    let vase = [VASE.colored(Rgb::gray(0.95)).posed(pose)];
    let scene = Scene::new(&vase, CAMERA, LIGHT).with_background(background);
    (name == NAMES[0]).then(|| scene.draw(display).ok())?
}
