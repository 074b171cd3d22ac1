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

/// In flash, with the scene and the order of its solids.
#[cfg(target_os = "none")]
static PICTURE: embedded_lathe::Picture = scenes::VASE_SCENE.picture(240, 240);

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    static mut ROW: [Rgb565; 240] = [Rgb565::BLACK; 240];
    loop {
        #[cfg(feature = "defmt")]
        defmt::info!("{}", scenes::VASE_SCENE);
        let picture = black_box(&PICTURE);
        for y in 0..240 {
            picture.row(y, black_box(&mut ROW[..]));
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo test --test footprint -- --ignored --nocapture");
}
