//! A vase from a drawing, on the OLED demo's panel: `show.rs` includes what was printed for `vase.svg`.
//!
//! ```text
//! cargo run --profile small --target thumbv7m-none-eabi    --example outlines            Cortex-M3, soft float
//! cargo run --profile small --target thumbv7em-none-eabihf --example outlines            Cortex-M4F
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
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
mod show;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo run --profile small --target thumbv7m-none-eabi --example outlines");
}
