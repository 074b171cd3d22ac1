//! The reference scenes' pictures and the solvers' roots, a number each: every machine prints the same.
//!
//! ```text
//! cargo run --release --example machines                                 the host
//! cargo run --release --target thumbv6m-none-eabi --example machines     an emulated Cortex-M0
//! ```
//!
//! `.cargo/run-firmware` knows an emulated machine for each target of `laboratory/tests/machines.rs`, which compares
//! what they print.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod checksum;
mod roots;
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;

#[cfg(target_os = "none")]
use semihosting::println;

#[cfg(all(target_arch = "arm", not(cortex_m33)))]
core::arch::global_asm!(include_str!("memory.s"));
#[cfg(all(target_arch = "arm", cortex_m33))]
core::arch::global_asm!(include_str!("memory_m33.s"));

#[cfg(target_os = "none")]
#[bare::entry]
fn start() -> ! {
    print();
    bare::exit(true)
}

#[cfg(not(target_os = "none"))]
fn main() {
    print();
}

/// A line for each scene: its name, and the checksum of its picture. Then a line for each solver: its name,
/// and the checksum of its roots.
fn print() {
    for (name, scene) in scenes::NAMED {
        println!("{},{:016x}", name, checksum::of(scene));
    }
    for (name, checksum) in roots::SOLVERS {
        println!("{},{:016x}", name, checksum());
    }
}
