//! The OLED demo with its solids' segments but without its scenes, to subtract: what is left is the library's part,
//! and what the demo says to it. `laboratory/tests/footprint.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[path = "../oled/card.rs"]
mod card;
#[cfg(target_os = "none")]
#[path = "../oled/firmware.rs"]
mod firmware;
#[cfg(target_os = "none")]
#[path = "../oled/host.rs"]
mod host;
#[cfg(target_os = "none")]
#[path = "../oled/panel.rs"]
mod panel;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

#[cfg(target_os = "none")]
mod show {
    use embedded_graphics::{pixelcolor::Gray4, prelude::*};

    // The demo's, so that it is subtracted.
    pub const TITLE: &[u8] =
        b"On the board's panel, 128 by 64 pixels in 16 grays: a test card, then a vase, swung about,\n\
then a ball that goes round a pawn. 24 frames each.\n";
    pub const NAMES: [&[u8]; 1] = [b"card"];
    pub const FRAMES: u32 = 24;

    pub fn draw<D: DrawTarget<Color = Gray4>>(name: &[u8], n: u32, display: &mut D) -> Option<()> {
        core::hint::black_box((&crate::scenes::VASE, &crate::scenes::PAWN, &crate::scenes::BALL));
        match name {
            b"card" => crate::card::card((n % FRAMES) as i32, display).ok(),
            _ => None,
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo test --test footprint -- --ignored --nocapture");
}
