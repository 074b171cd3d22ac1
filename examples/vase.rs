//! Renders the reference vase in the simulator's display, writes it as a PNG and shows it in the terminal.
//!
//! ```text
//! cargo run --release --example vase
//! ```

#[cfg(not(target_os = "none"))]
#[allow(dead_code)]
mod scenes;

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
    use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

    let path = std::env::current_dir()?.join("vase.png");
    println!("Ray-traces the reference vase, 240×240 pixels, into {}, and shows it here:\n", path.display());

    let scene = &scenes::VASE_SCENE;
    let mut display = SimulatorDisplay::<Rgb888>::new(Size::new(240, 240));
    scene.draw(&mut display)?;
    display.to_rgb_output_image(&OutputSettings::default()).save_png(&path)?;

    preview(scene);
    Ok(())
}

/// The scene in characters, from a blank for dark to @ for light: two rows of pixels a line, since characters
/// are tall.
#[cfg(not(target_os = "none"))]
fn preview(scene: &embedded_lathe::Scene) {
    use embedded_graphics::{pixelcolor::Gray8, prelude::*};

    let picture = scene.picture(60, 60);
    let mut row = [Gray8::BLACK; 60];
    for y in (0..60).step_by(2) {
        picture.row(y, &mut row);
        let shade = |pixel: &Gray8| b" .:-=+*#%@"[usize::from(pixel.luma()) * 10 / 256] as char;
        println!("{}", row.iter().map(shade).collect::<String>());
    }
}

/// A program for hosts: there is nothing for firmware to do here.
#[cfg(target_os = "none")]
fn main() {}
