//! A turning vase on a Stellaris board's 128×64 panel of 16 grays.
//!
//! ```text
//! cargo run --profile small --target thumbv7m-none-eabi    --example oled            Cortex-M3, soft float
//! cargo run --profile small --target thumbv7em-none-eabihf --example oled            Cortex-M4F
//! cargo run --profile small --target thumbv7m-none-eabi    --example oled vase 3     draw up to frame 3 and stay
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
mod card;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
mod host;
#[cfg(target_os = "none")]
mod panel;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;
#[cfg(target_os = "none")]
mod show;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo run --profile small --target thumbv7m-none-eabi --example oled");
}
