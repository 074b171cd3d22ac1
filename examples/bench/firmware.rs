//! The program: what is measured, a CSV line each, in the order of m4cycles' regions.

use crate::bare::{entry, exit};
#[cfg(target_has_atomic = "32")]
use crate::lone;
use crate::{clock, frames, rays, region::measure, report, solvers};
use core::arch::asm;

#[cfg(target_arch = "arm")]
core::arch::global_asm!(include_str!("memory.s"));

#[entry]
fn main() -> ! {
    clock::start();
    report::head();
    report::line("nothing", 1, 1, measure(|| ()).1);
    report::line("loop of 2001", 1, 1, measure(loop_of_2001).1);
    frames::measured();
    #[cfg(target_has_atomic = "32")]
    lone::measured();
    rays::measured();
    solvers::measured();
    #[cfg(target_arch = "arm")]
    frames::stacks();
    exit(true)
}

/// As many instructions, to check the counting by.
fn loop_of_2001() {
    // SAFETY: counts a register down.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!("2:", "subs {n}, #1", "bne 2b", n = inout(reg) 1000 => _)
    };
    // SAFETY: as above.
    #[cfg(target_arch = "riscv32")]
    unsafe {
        asm!("2:", "addi {n}, {n}, -1", "bnez {n}, 2b", n = inout(reg) 1000 => _)
    };
}
