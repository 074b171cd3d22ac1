//! What a frame costs, drawn whole and by the rectangle that has changed: means over a turn, as CSV.
//!
//! ```text
//! cargo run --release --target thumbv7em-none-eabihf --example redraw        an emulated Cortex-M4F: 240×240, Rgb565
//! cargo run --release --target thumbv7m-none-eabi    --example redraw        Cortex-M3, soft float: 128×64, Gray4
//! cargo test -p embedded-lathe-laboratory --test redraw -- --ignored write   both, into docs/REDRAW.md
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[path = "../bench/clock.rs"]
mod clock;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
#[path = "../bench/region.rs"]
mod region;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;
#[cfg(target_os = "none")]
#[path = "../bench/sink.rs"]
mod sink;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo run --release --target thumbv7em-none-eabihf --example redraw");
}
