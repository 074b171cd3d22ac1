//! A turning vase on an STM32F411 "Black Pill" with a 240×240 ST7789 display.
//!
//! Built by `.ci/run`; not yet run on the board.
//!
//! ```text
//! cargo run --release --target thumbv7em-none-eabihf --example stm32f411        flashes and logs by probe-rs
//! ```
//!
//! | display | SCL | SDA | CS  | DC  | RES | BLK  |
//! |---------|-----|-----|-----|-----|-----|------|
//! | board   | PA5 | PA7 | PA4 | PA3 | PA2 | 3.3V |
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo run --release --target thumbv7em-none-eabihf --example stm32f411");
}
