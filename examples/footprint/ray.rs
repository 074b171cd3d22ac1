//! One ray against one solid, and nothing else of the library: `laboratory/tests/footprint.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

#[cfg(all(target_os = "none", feature = "defmt"))]
use {cortex_m as _, defmt_rtt as _};

#[cfg(target_os = "none")]
use {
    core::hint::black_box,
    embedded_lathe::{Hit, Lathe, Ray},
};

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    let vase: &Lathe = &scenes::VASE;
    let (eye, towards) = ([0.0, -2.2, 0.9], [0.0, 2.2, -0.4]);
    loop {
        let hit = meet(black_box(vase), black_box(eye), black_box(towards));
        #[cfg(feature = "defmt")]
        defmt::info!("{}", hit);
        black_box(hit);
    }
}

/// Apart, lest the loop's own numbers get in its way.
#[cfg(target_os = "none")]
#[inline(never)]
fn meet(lathe: &Lathe, origin: [f32; 3], direction: [f32; 3]) -> Option<Hit> {
    lathe.nearest(&Ray::new(origin, direction).ok()?, 0.0)
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo test --test footprint -- --ignored --nocapture");
}
