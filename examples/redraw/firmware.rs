//! The program: each line is a scene, whether its frames were drawn whole, the pixels of a frame and its instructions.

use crate::bare::{entry, exit};
use crate::clock;
use crate::region::measure;
use crate::scenes::{
    dial::{DIAL, dial},
    orbit::{ORBIT, orbit},
};
use crate::sink::Sink;
use core::f32::consts::TAU;
use core::hint::black_box;
use embedded_graphics::{prelude::*, primitives::Rectangle};
use embedded_lathe::{Redraw, Scene, SceneError, Solid};
use semihosting::println;

core::arch::global_asm!(include_str!("../bench/memory.s"));

#[cfg(target_abi = "eabihf")]
mod display {
    pub use embedded_graphics::pixelcolor::Rgb565 as Color;
    pub const BLANK: Color = Color::new(0, 0, 0);
    pub const WIDTH: u32 = 240;
    pub const HEIGHT: u32 = 240;
}

#[cfg(not(target_abi = "eabihf"))]
mod display {
    pub use embedded_graphics::pixelcolor::Gray4 as Color;
    pub const BLANK: Color = Color::new(0);
    pub const WIDTH: u32 = 128;
    pub const HEIGHT: u32 = 64;
}

use display::{BLANK, Color, HEIGHT, WIDTH};

/// Frames of a turn.
const FRAMES: u32 = 24;

const SCREEN: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT));

type Solids = Result<[Solid<'static>; 2], SceneError>;

/// The solids at an angle in radians.
type Turn = fn(f32) -> Solids;

#[entry]
fn main() -> ! {
    clock::start();
    println!("scene,drawn,pixels,instructions");
    let scenes: [(&str, &Scene, Turn); 2] = [("turning knob", &DIAL, dial), ("moving ball", &ORBIT, orbit)];
    for (name, scene, solids) in scenes {
        for (drawn, is_whole) in [("whole", true), ("rectangle", false)] {
            let (pixels, instructions) = measure(|| turn(scene, solids, is_whole));
            let Ok(pixels) = pixels else { exit(false) };
            println!("{},{},{},{}", name, drawn, pixels / FRAMES, instructions / u64::from(FRAMES));
        }
    }
    exit(true)
}

/// Draws a turn; returns how many pixels. The second solid is the one that moves.
#[inline(never)]
fn turn(scene: &Scene, solids: Turn, is_whole: bool) -> Result<u32, SceneError> {
    let mut display = Sink::<Color>::new(WIDTH, HEIGHT);
    let mut row = [BLANK; WIDTH as usize];
    let mut pixels = 0;
    // The frame before the first.
    let last = solids(-TAU / FRAMES as f32)?;
    let mut redraw = Redraw::new(scene.picture(WIDTH, HEIGHT).covered_by(&last[1]));
    for n in 0..FRAMES {
        let solids = solids(black_box(n) as f32 * (TAU / FRAMES as f32))?;
        let picture = scene.with_solids(&solids).picture(WIDTH, HEIGHT);
        let area = if is_whole { SCREEN } else { redraw.next(picture.covered_by(&solids[1])) };
        let Ok(()) = picture.at(Point::zero()).only(&area).draw_by_rows(&mut display, &mut row);
        pixels += area.size.width * area.size.height;
    }
    Ok(pixels)
}
