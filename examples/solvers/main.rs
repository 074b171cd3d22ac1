//! Instructions of every solver in f32, one solve at a time, on an emulated Cortex-M4F or Cortex-M3. Run it with `.ci/solvers`.
//!
//! Prints a line `solver,method,backend,family,count` for every stretch of solves; `examples/bench/m4cycles.c`, a plugin of QEMU, then
//! prints the instructions of each solve, in the same order.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[path = "../../laboratory/src/contenders/mod.rs"]
#[allow(dead_code, unused_imports)]
mod contenders;
#[cfg(target_os = "none")]
mod firmware;
#[cfg(target_os = "none")]
#[path = "../../laboratory/src/workload.rs"]
mod workload;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("for a Cortex-M: .ci/solvers");
}
