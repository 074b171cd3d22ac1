//! A stretch of the program that is measured: by the clock and, on a Cortex-M, by m4cycles.c from outside.

use crate::clock;
#[cfg(target_arch = "arm")]
use core::arch::asm;
use core::hint::black_box;

/// Runs `work`, on a Cortex-M between m4cycles' two marks; with its result, the clock's instructions.
///
/// QEMU counts by blocks, and each `isb` ends one: so m4cycles sees `work` and 3 instructions more (4 if an
/// `isb` crosses a page), the clock at most 80 more or fewer.
#[inline(always)]
pub fn measure<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let start = clock::instructions();
    // SAFETY: moving a register to itself and waiting for the pipeline change nothing.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!("mov r10, r10", "isb")
    };
    let result = black_box(black_box(work)());
    // SAFETY: as above.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!("isb", "mov r11, r11", "isb")
    };
    (result, clock::instructions() - start)
}
