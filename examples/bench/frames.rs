//! Whole frames of the reference scenes.

use crate::{region::measure, report::line, scenes, sink::Sink};
use core::hint::black_box;
use embedded_lathe::Scene;

#[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
mod display {
    pub use embedded_graphics::pixelcolor::Rgb565 as Color;
    pub const BLANK: Color = Color::new(0, 0, 0);
    pub const WIDTH: u32 = 240;
    pub const HEIGHT: u32 = 240;
}

/// The OLED demo's: without hardware for floats a frame takes ten times as long.
#[cfg(all(not(target_abi = "eabihf"), target_os = "none"))]
mod display {
    pub use embedded_graphics::pixelcolor::Gray4 as Color;
    pub const BLANK: Color = Color::new(0);
    pub const WIDTH: u32 = 128;
    pub const HEIGHT: u32 = 64;
}

pub use display::{HEIGHT, WIDTH};

type Row = [display::Color; WIDTH as usize];

const BLANK: Row = [display::BLANK; WIDTH as usize];

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

/// Shoulders, walls with thickness, solids that no plane parts: not where floats are slow.
#[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
const SHAPES: [(&str, &Scene); 14] = {
    use scenes::shapes::{BOWLS, BOWLS_BALL, CROSSINGS, RISERS};
    [
        ("knob with a riser of 1e-2", &RISERS[0]),
        ("knob with a riser of 1e-3", &RISERS[1]),
        ("knob with a riser of 1e-4", &RISERS[2]),
        ("knob with a riser of 1e-6", &RISERS[3]),
        ("outer wall", &BOWLS[0]),
        ("inner wall", &BOWLS[1]),
        ("outer and inner wall", &BOWLS[2]),
        ("ball of the bowl", &BOWLS_BALL),
        ("one rippled solid", &CROSSINGS[0]),
        ("two through one another", &CROSSINGS[1]),
        ("three through one another", &CROSSINGS[2]),
        ("six through one another", &CROSSINGS[3]),
        ("one from within", &CROSSINGS[4]),
        ("six from within", &CROSSINGS[5]),
    ]
};

/// Columns and rows of all pixels.
pub fn pixels() -> impl Iterator<Item = (u32, u32)> {
    (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)))
}

/// By rows into one buffer; the vase drawn as well, with and without a buffer.
pub fn measured() {
    let mut row = BLANK;
    for (name, scene) in SCENES {
        frame(name, scene, || rows(scene, &mut row));
    }
    #[cfg(any(target_abi = "eabihf", not(target_os = "none")))]
    for (name, scene) in SHAPES {
        frame(name, scene, || rows(scene, &mut row));
    }
    frame("vase drawn by rows", &scenes::VASE_SCENE, || draw_by_rows(&scenes::VASE_SCENE, &mut row));
    frame("vase drawn", &scenes::VASE_SCENE, || draw(&scenes::VASE_SCENE));
}

/// How much stack they take below their caller's.
#[cfg(target_os = "none")]
pub fn stacks() {
    use crate::stack::depth;

    let mut row = BLANK;
    for (name, scene) in SCENES {
        let (rows, draw) = (depth(|| rows(scene, &mut row)), depth(|| draw(scene)));
        crate::report::println!("# {}: {} bytes of stack by rows, {} drawn", name, rows, draw);
    }
}

fn frame(name: &str, scene: &Scene, work: impl FnOnce()) {
    let ((), instructions) = measure(work);
    let seen = |(x, y): &(u32, u32)| {
        let ray = scene.camera.ray(*x, *y, WIDTH, HEIGHT);
        scene.solids.iter().any(|solid| solid.nearest(&ray, 0.0).is_some())
    };
    line(name, (WIDTH * HEIGHT).into(), pixels().filter(seen).count() as u64, instructions);
}

#[inline(never)]
fn rows(scene: &Scene, row: &mut Row) {
    let picture = black_box(scene).picture(WIDTH, HEIGHT);
    for y in 0..HEIGHT {
        picture.row(y, black_box(&mut row[..]));
    }
}

#[inline(never)]
fn draw(scene: &Scene) {
    let Ok(()) = black_box(scene).draw(&mut Sink::<display::Color>::new(WIDTH, HEIGHT));
}

#[inline(never)]
fn draw_by_rows(scene: &Scene, row: &mut Row) {
    let Ok(()) = black_box(scene).draw_by_rows(&mut Sink::<display::Color>::new(WIDTH, HEIGHT), row);
}
