//! What the panel shows: the firmware draws it there, `laboratory/tests/panel.rs` on the host, and both must agree.

use crate::{card::card, scenes};
use core::f32::consts::TAU;
use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};
use embedded_lathe::{Background, Camera, Pose, Rgb, Rotation, Scene, Solid, valid};

/// What there is to see.
pub const TITLE: &[u8] =
    b"On the board's panel, 128 by 64 pixels in 16 grays: a test card, then a vase, swung about,\n\
then a ball that goes round a pawn. 24 frames each.\n";

/// The names of the scenes; `card` tries the panel's driver.
pub const NAMES: [&[u8]; 3] = [b"card", b"vase", b"pawn"];

/// A turn.
pub const FRAMES: u32 = 24;

const CAMERA: Camera = valid!(Camera::perspective([0.0, -2.2, 0.6], [0.0; 3], [0.0, 0.0, 1.0], 0.58));

/// Draws frame `n`; `None` for a name that is not there or a display that fails.
pub fn draw<D: DrawTarget<Color = Gray4>>(name: &[u8], n: u32, display: &mut D) -> Option<()> {
    let angle = (n % FRAMES) as f32 * (TAU / FRAMES as f32);
    match name {
        b"card" => card((n % FRAMES) as i32, display),
        b"vase" => see(&[vase(angle)?], display),
        b"pawn" => see(&pawn(angle)?, display),
        _ => return None,
    }
    .ok()
}

/// Row by row, each sent as soon as it is reckoned: a row shares more than the pixels of a whole picture can.
fn see<D: DrawTarget<Color = Gray4>>(solids: &[Solid], display: &mut D) -> Result<(), D::Error> {
    let background = Background::Gradient { top: Rgb::gray(0.05), bottom: Rgb::gray(0.25) };
    let scene = Scene::new(solids, CAMERA, scenes::DAYLIGHT).with_background(background);
    let Rectangle { top_left, size } = display.bounding_box();
    let picture = scene.picture(size.width, size.height);
    let mut row = [Gray4::BLACK; WIDTH];
    for y in 0..size.height {
        picture.row(y, &mut row);
        let line = Rectangle::new(top_left + Point::new(0, y as i32), Size::new(size.width, 1));
        display.fill_contiguous(&line, row)?;
    }
    Ok(())
}

/// How wide the panel is, in pixels.
const WIDTH: usize = 128;

/// The vase, leaning, swung about the upright through its middle: spin about its own axis would not show.
fn vase(angle: f32) -> Option<Solid<'static>> {
    let turn = Rotation::about_x(0.6).then(Rotation::about_z(angle));
    let foot = turn.apply([0.0, 0.0, -0.5]);
    let pose = Pose::new(foot, turn, 1.0).ok()?;
    Some(Solid::new(&scenes::VASE, Rgb::gray(0.95)).posed(pose))
}

/// A pawn with a ball going round it, in front and behind.
fn pawn(angle: f32) -> Option<[Solid<'static>; 2]> {
    let ball = Rotation::about_z(angle).apply([0.55, 0.0, 0.0]);
    let pose = |place, scale| Pose::new(place, Rotation::IDENTITY, scale).ok();
    Some([
        Solid::new(&scenes::PAWN, Rgb::gray(0.9)).posed(pose([0.0, 0.0, -0.5], 1.0)?).shiny(20),
        Solid::new(&scenes::BALL, Rgb::gray(0.7)).posed(pose(ball, 0.7)?).shiny(40),
    ])
}
