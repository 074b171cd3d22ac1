//! Whole frames of the reference scenes.

use crate::{region::measure, report::line, scenes, sink::Sink};
use core::hint::black_box;
#[cfg(all(not(target_abi = "eabihf"), target_os = "none"))]
use embedded_graphics::pixelcolor::Gray4;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565};
use embedded_lathe::{Paint, Scene};

/// A display: its colors and its size.
pub trait Panel {
    type Color: PixelColor + Paint;
    const WIDTH: u32;
    const HEIGHT: u32;
    const BLANK: Self::Color;
}

/// A color TFT, 240×240.
pub struct Tft;

impl Panel for Tft {
    type Color = Rgb565;
    const WIDTH: u32 = 240;
    const HEIGHT: u32 = 240;
    const BLANK: Rgb565 = Rgb565::new(0, 0, 0);
}

/// The panel that all is measured on.
#[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
pub use Tft as Usual;

/// The panel that all is measured on, the OLED demo's: without hardware for floats a large frame takes ten times as long.
#[cfg(all(not(target_abi = "eabihf"), target_os = "none"))]
pub struct Usual;

#[cfg(all(not(target_abi = "eabihf"), target_os = "none"))]
impl Panel for Usual {
    type Color = Gray4;
    const WIDTH: u32 = 128;
    const HEIGHT: u32 = 64;
    const BLANK: Gray4 = Gray4::new(0);
}

const SCENES: [(&str, &Scene); 10] = [
    ("vase", &scenes::VASE_SCENE),
    ("tilted vase", &scenes::TILTED_SCENE),
    ("still life", &scenes::STILL_LIFE),
    ("bowl", &scenes::BOWL_SCENE),
    ("knob", &scenes::KNOB_SCENE),
    ("vase of 64 segments", &scenes::fine::SCENE),
    ("ball", &scenes::BALL_SCENE),
    ("vase and ball", &scenes::VASE_AND_BALL),
    ("ball in bowl", &scenes::BALL_IN_BOWL),
    ("pawns", &scenes::PAWNS),
];

/// Shoulders, by a step and by segments that are all but level.
const SHOULDERS: [(&str, &Scene); 5] = {
    use scenes::shapes::{RISERS, STEPPED};
    [
        ("knob with a step", &STEPPED),
        ("knob with a riser of 1e-2", &RISERS[0]),
        ("knob with a riser of 1e-3", &RISERS[1]),
        ("knob with a riser of 1e-4", &RISERS[2]),
        ("knob with a riser of 1e-6", &RISERS[3]),
    ]
};

/// Walls with thickness, solids that no plane parts: not where floats are slow.
#[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
const SHAPES: [(&str, &Scene); 12] = {
    use scenes::shapes::{BOWL_OF_SHEETS, BOWLS, BOWLS_BALL, CROSSINGS, PAWN_OF_SHEETS};
    [
        ("outer wall", &BOWLS[0]),
        ("inner wall", &BOWLS[1]),
        ("outer and inner wall", &BOWLS[2]),
        ("bowl of two sheets", &BOWL_OF_SHEETS),
        ("ball of the bowl", &BOWLS_BALL),
        ("pawn of six sheets", &PAWN_OF_SHEETS),
        ("one rippled solid", &CROSSINGS[0]),
        ("two through one another", &CROSSINGS[1]),
        ("three through one another", &CROSSINGS[2]),
        ("six through one another", &CROSSINGS[3]),
        ("one from within", &CROSSINGS[4]),
        ("six from within", &CROSSINGS[5]),
    ]
};

/// On a large display as well, where floats are slow.
#[cfg(all(not(target_abi = "eabihf"), target_os = "none"))]
const LARGE: [(&str, &Scene); 3] = [
    ("vase 240x240", &scenes::VASE_SCENE),
    ("tilted vase 240x240", &scenes::TILTED_SCENE),
    ("bowl 240x240", &scenes::BOWL_SCENE),
];

/// A row of pixels of a panel, or a longer one.
type Row<P> = [<P as Panel>::Color; 240];

/// Columns and rows of all pixels.
pub fn pixels<P: Panel>() -> impl Iterator<Item = (u32, u32)> {
    (0..P::HEIGHT).flat_map(|y| (0..P::WIDTH).map(move |x| (x, y)))
}

/// By rows into one buffer; the vase drawn as well, with and without a buffer.
pub fn measured() {
    let mut row = [Usual::BLANK; 240];
    for (name, scene) in SCENES {
        frame::<Usual>(name, scene, || rows::<Usual>(scene, &mut row));
    }
    for (name, scene) in SHOULDERS {
        frame::<Usual>(name, scene, || rows::<Usual>(scene, &mut row));
    }
    #[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
    for (name, scene) in SHAPES {
        frame::<Usual>(name, scene, || rows::<Usual>(scene, &mut row));
    }
    #[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
    frame::<Usual>("sheets of the bowl one by one", &scenes::shapes::BOWL_OF_SHEETS, || {
        scenes::shapes::SHEETS_OF_BOWL.iter().for_each(|scene| rows::<Usual>(scene, &mut row));
    });
    #[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
    frame::<Usual>("sheets of the pawn one by one", &scenes::shapes::PAWN_OF_SHEETS, || {
        scenes::shapes::SHEETS_OF_PAWN.iter().for_each(|scene| rows::<Usual>(scene, &mut row));
    });
    let vase = &scenes::VASE_SCENE;
    frame::<Usual>("vase drawn by rows", vase, || draw_by_rows::<Usual>(vase, &mut row));
    frame::<Usual>("vase drawn", vase, || draw::<Usual>(vase));
    #[cfg(all(not(target_abi = "eabihf"), target_os = "none"))]
    for (name, scene) in LARGE {
        let mut row = [Tft::BLANK; 240];
        frame::<Tft>(name, scene, || rows::<Tft>(scene, &mut row));
    }
}

/// How much stack they take below their caller's.
#[cfg(all(target_arch = "arm", target_os = "none"))]
pub fn stacks() {
    use crate::stack::depth;

    let mut row = [Usual::BLANK; 240];
    for (name, scene) in SCENES {
        let (rows, draw) = (depth(|| rows::<Usual>(scene, &mut row)), depth(|| draw::<Usual>(scene)));
        crate::report::println!("# {}: {} bytes of stack by rows, {} drawn", name, rows, draw);
    }
}

pub fn frame<P: Panel>(name: &str, scene: &Scene, work: impl FnOnce()) {
    let ((), instructions) = measure(work);
    let seen = |(x, y): &(u32, u32)| {
        let ray = scene.camera.ray(*x, *y, P::WIDTH, P::HEIGHT);
        scene.solids.iter().any(|solid| solid.nearest(&ray, 0.0).is_some())
    };
    let hits = pixels::<P>().filter(seen).count() as u64;
    line(name, (P::WIDTH * P::HEIGHT).into(), hits, instructions);
}

#[inline(never)]
fn rows<P: Panel>(scene: &Scene, row: &mut Row<P>) {
    let picture = black_box(scene).picture(P::WIDTH, P::HEIGHT);
    for y in 0..P::HEIGHT {
        picture.row(y, black_box(&mut row[..P::WIDTH as usize]));
    }
}

#[inline(never)]
fn draw<P: Panel>(scene: &Scene) {
    let Ok(()) = black_box(scene).draw(&mut Sink::<P::Color>::new(P::WIDTH, P::HEIGHT));
}

#[inline(never)]
fn draw_by_rows<P: Panel>(scene: &Scene, row: &mut Row<P>) {
    let row = &mut row[..P::WIDTH as usize];
    let Ok(()) = black_box(scene).draw_by_rows(&mut Sink::<P::Color>::new(P::WIDTH, P::HEIGHT), row);
}
