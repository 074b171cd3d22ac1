//! Instructions of the reference scenes, of rays one by one and of every solver, as CSV.
//!
//! ```text
//! cargo run --release --features std --example bench                        the host, counted by valgrind: 240×240, Rgb565
//! cargo run --release --target thumbv7em-none-eabihf --example bench        an emulated Cortex-M4F: the same
//! cargo run --release --target thumbv7m-none-eabi    --example bench        Cortex-M3, soft float: 128×64, Gray4
//! cargo run --release --target thumbv6m-none-eabi    --example bench        the code of a Cortex-M0+, on that Cortex-M3
//! cargo run --release --target riscv32imc-unknown-none-elf --example bench  a RISC-V without floats: as on the Cortex-M3
//! .ci/cycles                          the second, with cycles estimated as well
//! .ci/record                          all into docs/instructions.csv
//! .ci/record --check                  all against it
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

mod cubics;
mod frames;
// Not for the two slowest, which have no atomic exchanges either.
#[cfg(any(target_has_atomic = "32", not(target_os = "none")))]
mod lone;
mod rays;
mod report;
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;
mod sink;
mod solvers;
mod textbook;

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
mod clock;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
mod region;
#[cfg(all(target_arch = "arm", target_os = "none"))]
mod stack;

#[cfg(not(target_os = "none"))]
mod host;
#[cfg(not(target_os = "none"))]
#[path = "host_region.rs"]
mod region;

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    host::run()
}
