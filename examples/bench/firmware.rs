//! The program: what is measured, a CSV line each, in the order of m4cycles' regions.

use crate::{bare::exit, clock, frames, rays, region::measure, report, solvers};
use core::arch::asm;
use cortex_m::Peripherals;
use cortex_m_rt::entry;

core::arch::global_asm!(include_str!("memory.s"));

#[entry]
fn main() -> ! {
    if let Some(core) = Peripherals::take() {
        clock::start(core.SYST);
    }

    report::head();
    report::line("nothing", 1, 1, measure(|| ()).1);
    report::line("loop of 2001", 1, 1, measure(loop_of_2001).1);
    frames::measured();
    rays::measured();
    solvers::measured();
    frames::stacks();
    exit(true)
}

/// As many instructions, to check the counting by.
fn loop_of_2001() {
    // SAFETY: counts a register down.
    unsafe { asm!("mov {n}, #1000", "2:", "subs {n}, #1", "bne 2b", n = out(reg) _) };
}
