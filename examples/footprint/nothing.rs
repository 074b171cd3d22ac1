//! The least firmware there is, and the vase's segments, to subtract from the others: `laboratory/tests/footprint.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    core::hint::black_box(&scenes::VASE);
    loop {
        cortex_m::asm::wfi();
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo test --test footprint -- --ignored --nocapture");
}
