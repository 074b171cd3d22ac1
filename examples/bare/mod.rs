//! What every firmware without an operating system or a HAL must bring.

use core::panic::PanicInfo;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, ExitStatus};

/// Ends the emulator, and with it `cargo run`.
pub fn exit(status: ExitStatus) -> ! {
    loop {
        debug::exit(status);
    }
}

/// Nothing here panics: `laboratory/tests/panics.rs` sees that this never gets linked, `bench`'s printing aside.
#[panic_handler]
#[inline(never)]
fn panic(_: &PanicInfo) -> ! {
    exit(EXIT_FAILURE)
}

/// No interrupts, so their table is one unused word; elsewhere cortex-m-rt brings a full one (see Cargo.toml on the HAL).
#[cfg(target_abi = "eabihf")]
#[unsafe(link_section = ".vector_table.interrupts")]
#[unsafe(no_mangle)]
static __INTERRUPTS: [usize; 1] = [0];
