//! A line of the CSV.

use cortex_m_semihosting::{hprint, hprintln};

pub fn line(name: &str, items: u64, hits: u64, instructions: u64) {
    hprint!("{},{},{},{},{:.1},", name, items, hits, instructions, instructions as f64 / items as f64);
    if hits > 0 {
        hprint!("{:.1}", instructions as f64 / hits as f64);
    }
    hprintln!();
}
