//! What every firmware without an operating system or a HAL must bring.

use core::panic::PanicInfo;
use semihosting::process;

#[cfg(target_arch = "arm")]
#[allow(unused_imports)]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
#[allow(unused_imports)]
pub use riscv_rt::entry;

// Only for its critical section, which defmt asks for.
#[cfg(target_arch = "riscv32")]
use riscv as _;

/// Ends the emulator, and with it `cargo run`: in success or in failure.
pub fn exit(is_success: bool) -> ! {
    process::exit(if is_success { 0 } else { 1 })
}

/// Nothing here panics: `laboratory/tests/panics.rs` sees that this never gets linked, `bench`'s printing aside.
#[panic_handler]
#[inline(never)]
fn panic(_: &PanicInfo) -> ! {
    exit(false)
}

/// No interrupts, so their table is one unused word; elsewhere cortex-m-rt brings a full one (see Cargo.toml on the HAL).
#[cfg(all(target_abi = "eabihf", not(cortex_m33)))]
#[unsafe(link_section = ".vector_table.interrupts")]
#[unsafe(no_mangle)]
static __INTERRUPTS: [usize; 1] = [0];
