//! The debugging host, over semihosting.

use cortex_m_semihosting::{hio, syscall};

/// The words after the program's own name on its command line.
pub fn arguments(buffer: &mut [u8; 64]) -> impl Iterator<Item = &[u8]> {
    // SAFETY: the host writes at most that many bytes, a zero after the last.
    unsafe { syscall!(GET_CMDLINE, buffer.as_mut_ptr(), buffer.len() - 1) };
    buffer.split(|&b| b == b' ' || b == 0).filter(|word| !word.is_empty()).skip(1)
}

/// Writes to the host's standard output; nothing without a host to read it.
pub fn say(line: &[u8]) {
    if let Ok(mut out) = hio::hstdout() {
        out.write_all(line).ok();
    }
}
