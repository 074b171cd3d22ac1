//! The debugging host, over semihosting.

use cortex_m_semihosting::{hio, syscall};

/// The words after the program's own name on its command line.
pub fn arguments(buffer: &mut [u8; 64]) -> impl Iterator<Item = &[u8]> {
    // SAFETY: the host writes at most that many bytes, a zero after the last.
    unsafe { syscall!(GET_CMDLINE, buffer.as_mut_ptr(), buffer.len() - 1) };
    buffer.split(|&b| b == b' ' || b == 0).filter(|word| !word.is_empty()).skip(1)
}

/// A number in decimal digits.
pub fn number(digits: &[u8]) -> u32 {
    digits.iter().fold(0, |n, d| n.wrapping_mul(10).wrapping_add(u32::from(d & 15)))
}

/// What to say to whoever sees only a terminal.
pub const WHERE_TO_LOOK: &[u8] = b"The panel is the window that QEMU opens. Where there is no screen, this saves nine of its frames in docs/panel.png:\n\
cargo test -p embedded-lathe-laboratory --test panel -- --ignored write\n";

/// Writes to the host's standard output; nothing without a host to read it.
pub fn say(line: &[u8]) {
    if let Ok(mut out) = hio::hstdout() {
        out.write_all(line).ok();
    }
}
