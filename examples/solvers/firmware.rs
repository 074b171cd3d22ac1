//! The program.

use crate::bare::exit;
use crate::contenders::{EVERYWHERE, FirstRoot};
use crate::workload::{COUNT, FAMILIES, Item, Make};
use core::{arch::asm, hint::black_box};
use cortex_m as _; // its critical section
use cortex_m_rt::entry;
use semihosting::println;

core::arch::global_asm!(include_str!("../bench/memory.s"));

#[entry]
fn main() -> ! {
    for (family, make) in FAMILIES {
        solves("call alone", "", family, make, |_, lo, _| Some(lo));
        for contender in EVERYWHERE {
            solves(contender.method, contender.backend, family, make, contender.first_root);
        }
    }
    exit(true)
}

fn solves(method: &str, backend: &str, family: &str, make: Make, first_root: FirstRoot) {
    for i in 0..COUNT {
        let Item { c, lo, hi } = make(i);
        let (c, lo, hi) = black_box((c, lo, hi));
        let first_root = black_box(first_root);
        // SAFETY: moving a register to itself and waiting for the pipeline change nothing; the plugin takes the one for a mark, and the
        // other ends the block that it counts by.
        unsafe { asm!("mov r10, r10", "isb") };
        let root = first_root(&c, lo, hi);
        unsafe { asm!("isb", "mov r11, r11", "isb") };
        black_box(root);
    }
    println!("solver,{},{},{},{}", method, backend, family, COUNT);
}
