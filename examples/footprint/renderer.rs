//! A scene into rows of pixels, without a display's driver: `laboratory/tests/footprint.rs`.
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
    embedded_graphics::{pixelcolor::Rgb565, prelude::*},
};

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    static mut ROW: [Rgb565; 240] = [Rgb565::BLACK; 240];
    loop {
        let scene = black_box(&scenes::VASE_SCENE);
        #[cfg(feature = "defmt")]
        defmt::info!("{}", scene);
        let picture = scene.picture(240, 240);
        for y in 0..240 {
            picture.row(y, black_box(&mut ROW[..]));
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo test --test footprint -- --ignored --nocapture");
}
