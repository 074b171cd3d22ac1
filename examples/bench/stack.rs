//! How deep the stack goes.

use cortex_m::{interrupt, register::msp};

const PAINT: u32 = 0xc0ff_ee11;
const WORDS: u32 = 4096;

/// Bytes of stack that `work` uses: those below are painted first, and looked at afterwards.
///
/// Words that it reserves but never writes, at the very end, do not count. `WORDS * 4` means that or more.
#[inline(never)]
pub fn depth(work: impl FnOnce()) -> u32 {
    #[inline(never)]
    fn call(work: impl FnOnce()) {
        work();
    }

    interrupt::free(|_| {
        let top = msp::read();
        let word = |i: u32| (top - 4 * i) as *mut u32;
        // SAFETY: memory below the stack's pointer is nobody's, interrupts are off, and the board's RAM is far larger.
        (1..=WORDS).for_each(|i| unsafe { word(i).write_volatile(PAINT) });
        call(work);
        // SAFETY: as above.
        4 * (1..=WORDS).rev().find(|&i| unsafe { word(i).read_volatile() } != PAINT).unwrap_or(0)
    })
}
