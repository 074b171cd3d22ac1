//! Instructions executed, by SysTick.
//!
//! QEMU's `-icount shift=0` lets one instruction take one nanosecond of emulated time, and this board's SysTick runs at
//! 25 MHz: a tick is 40 instructions, and so is the resolution.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use cortex_m::peripheral::{SYST, syst::SystClkSource};
use cortex_m_rt::exception;

const TICK: u64 = 40;
const TOP: u32 = 0x00ff_ffff;

static WRAPS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    WRAPS.fetch_add(1, Relaxed);
}

pub fn start(mut systick: SYST) {
    systick.set_clock_source(SystClkSource::Core);
    systick.set_reload(TOP);
    systick.clear_current();
    systick.enable_counter();
    systick.enable_interrupt();
}

/// Instructions since `start`, give or take a tick.
pub fn instructions() -> u64 {
    loop {
        let wraps = WRAPS.load(Relaxed);
        let left = SYST::get_current();
        if wraps == WRAPS.load(Relaxed) {
            return (u64::from(wraps) * (u64::from(TOP) + 1) + u64::from(TOP - left)) * TICK;
        }
    }
}
