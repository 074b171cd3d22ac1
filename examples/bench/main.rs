//! Instructions of the reference scenes, of rays one by one and of every solver on an emulated Cortex-M4F, as CSV.
//!
//! ```text
//! cargo run --release --target thumbv7em-none-eabihf --example bench       240×240, Rgb565
//! cargo run --release --target thumbv7m-none-eabi    --example bench       Cortex-M3, soft float: 128×64, Gray4
//! .ci/cycles                          the first, with cycles estimated as well
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

#[cfg(target_os = "none")]
mod clock;
#[cfg(target_os = "none")]
mod cubics;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
mod frames;
#[cfg(target_os = "none")]
mod rays;
#[cfg(target_os = "none")]
mod region;
#[cfg(target_os = "none")]
mod report;
#[cfg(target_os = "none")]
mod sink;
#[cfg(target_os = "none")]
mod solvers;
#[cfg(target_os = "none")]
mod stack;
#[cfg(target_os = "none")]
mod textbook;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo run --release --target thumbv7em-none-eabihf --example bench");
}
