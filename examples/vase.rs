//! Renders the reference vase in the simulator's display, writes it as a PNG and shows it in the terminal.
//!
//! ```text
//! cargo run --release --example vase
//! ```

#[allow(dead_code)]
mod scenes;

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
    use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

    let scene = &scenes::VASE_SCENE;
    let mut display = SimulatorDisplay::<Rgb888>::new(Size::new(240, 240));
    scene.draw(&mut display)?;

    let path = std::env::current_dir()?.join("vase.png");
    display.to_rgb_output_image(&OutputSettings::default()).save_png(&path)?;
    preview(&display);
    println!("wrote {}", path.display());
    Ok(())
}
