//! Instructions executed: by SysTick on a Cortex-M, by its own counter on a RISC-V.

#[cfg(target_arch = "arm")]
pub use systick::{instructions, start};

#[cfg(target_arch = "riscv32")]
pub use instret::{instructions, start};

/// QEMU's `-icount shift=0` lets one instruction take one nanosecond of emulated time, and this board's SysTick runs at
/// 25 MHz: a tick is 40 instructions, and so is the resolution.
#[cfg(target_arch = "arm")]
mod systick {
    use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
    use cortex_m::Peripherals;
    use cortex_m::peripheral::{SYST, syst::SystClkSource};
    use cortex_m_rt::exception;

    const TICK: u64 = 40;
    const TOP: u32 = 0x00ff_ffff;

    static WRAPS: AtomicU32 = AtomicU32::new(0);

    /// Counts how often the timer has begun anew. The one place that writes `WRAPS`, so two steps do: a Cortex-M0 has no
    /// single instruction for both.
    #[exception]
    fn SysTick() {
        WRAPS.store(WRAPS.load(Relaxed) + 1, Relaxed);
    }

    pub fn start() {
        let Some(Peripherals { SYST: mut systick, .. }) = Peripherals::take() else { return };
        systick.set_clock_source(SystClkSource::Core);
        systick.set_reload(TOP);
        systick.clear_current();
        systick.enable_counter();
        systick.enable_interrupt();
    }

    /// Instructions since `start`, to within a tick.
    pub fn instructions() -> u64 {
        loop {
            let wraps = WRAPS.load(Relaxed);
            let left = SYST::get_current();
            if wraps == WRAPS.load(Relaxed) {
                return (u64::from(wraps) * (u64::from(TOP) + 1) + u64::from(TOP - left)) * TICK;
            }
        }
    }
}

/// The core counts by itself, each instruction.
#[cfg(target_arch = "riscv32")]
mod instret {
    use riscv::register::minstret;

    pub fn start() {}

    pub fn instructions() -> u64 {
        minstret::read64()
    }
}
