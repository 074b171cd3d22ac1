//! The CSV.

#[cfg(target_os = "none")]
pub use semihosting::{print, println};
#[cfg(not(target_os = "none"))]
pub use std::{print, println};

pub fn head() {
    println!("scene,pixels,hits,instructions,per_pixel,per_hit_pixel");
}

pub fn line(name: &str, items: u64, hits: u64, instructions: u64) {
    print!("{},{},{},{},{:.1},", name, items, hits, instructions, instructions as f64 / items as f64);
    if hits > 0 {
        print!("{:.1}", instructions as f64 / hits as f64);
    }
    println!();
}
