//! Draws the reference scenes into `docs`.
//!
//! ```text
//! cargo run --release --example pictures
//! ```

#[cfg(not(target_os = "none"))]
#[allow(dead_code)]
mod scenes;

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
    use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

    for (name, scene) in scenes::NAMED {
        let mut display = SimulatorDisplay::<Rgb888>::new(Size::new(240, 240));
        scene.draw(&mut display)?;
        let path = format!("{}/docs/{name}.png", env!("CARGO_MANIFEST_DIR"));
        display.to_rgb_output_image(&OutputSettings::default()).save_png(&path)?;
        println!("{path}");
    }
    Ok(())
}

/// A program for hosts: there is nothing for firmware to do here.
#[cfg(target_os = "none")]
fn main() {}
