//! A knob among text on the OLED demo's panel: turned step by step, with only its pointer drawn again.
//!
//! ```text
//! cargo run --profile small --target thumbv7m-none-eabi    --example dial            Cortex-M3, soft float
//! cargo run --profile small --target thumbv7em-none-eabihf --example dial            Cortex-M4F
//! cargo run --profile small --target thumbv7m-none-eabi    --example dial turn 3     turn three steps and stay
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
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
mod show;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo run --profile small --target thumbv7m-none-eabi --example dial");
}
