//! A file in; a `static` and a picture out.

use super::{Reading, patience};
use clap::Args;
use embedded_lathe_outline::{Fit, Joins, Origin, body, png, read, source};
use std::{error::Error, fs, path::PathBuf, process::ExitCode};

#[derive(Args)]
pub(super) struct Arguments {
    /// The drawing: an SVG, a table (CSV) of heights and radii, or points in JSON.
    file: Option<PathBuf>,
    #[command(flatten)]
    reading: Reading,
    /// The largest distance between the drawn outline and the solid's, in the drawing's unit: millimeters, if it has
    /// one.
    #[arg(long, conflicts_with = "pixels")]
    tolerance: Option<f64>,
    /// The same as a quarter of a pixel in a picture that shows all of the solid and is this many pixels wide.
    #[arg(long, default_value_t = 240.0)]
    pixels: f64,
    /// Let segments meet at an angle where the outline is smooth: up to 1.4 times fewer segments, whose joins shading
    /// shows as edges.
    #[arg(long)]
    free_joins: bool,
    /// The name of the `static`; the file's, if it is not given.
    #[arg(long)]
    name: Option<String>,
    /// Writes the `static` to a file, too, for a `build.rs` to include.
    #[arg(long, value_name = "FILE")]
    rs: Option<PathBuf>,
    /// Where to write the picture: the solid, the drawn outline over it, and the knots. Beside the drawing's name,
    /// in this directory, if it is not given.
    #[arg(long, value_name = "FILE")]
    png: Option<PathBuf>,
    /// How many pixels the picture is wide.
    #[arg(long, default_value_t = 480)]
    size: u32,
}

impl Arguments {
    pub fn run(&self) -> ExitCode {
        match self.convert() {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::FAILURE
            }
        }
    }

    fn convert(&self) -> Result<(), Box<dyn Error>> {
        let file = self.file.as_ref().ok_or("no file is given")?;
        let options = self.reading.options();
        let drawing = read::read(file, &options)?;
        let [low, high] = drawing.outline.bounds();
        let size = (high.z - low.z).max(2.0 * high.r.abs().max(low.r.abs()));
        let tolerance = self.tolerance.unwrap_or(0.25 * size / self.pixels);
        let joins = if self.free_joins { Joins::Free } else { Joins::Smooth };
        let fit = Fit { half: options.half, joins, ..Fit::within(tolerance) };
        let fitted = patience::with(format!("fitting {}", file.display()), || body(&drawing.outline, &fit));
        let mut body = fitted.map_err(|error| drawing.error(file, error))?;
        body.warnings.splice(0..0, drawing.warnings);
        for warning in &body.warnings {
            eprintln!("warning: {}:{}: {warning}", file.display(), drawing.place.0);
        }
        let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let name = self.name.clone().or(self.reading.path.clone()).unwrap_or_else(|| stem.clone());
        let file_name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let from = drawing.name.map_or(file_name.clone(), |id| format!("{file_name}, {id:?}"));
        let text = source(&body, &Origin::named(&name, from, drawing.unit));
        print!("{text}");
        if let Some(rs) = &self.rs {
            fs::write(rs, &text)?;
        }
        let picture = self.png.clone().unwrap_or_else(|| PathBuf::from(format!("{stem}.png")));
        fs::write(&picture, png(&body, &drawing.outline, self.size)?)?;
        eprintln!("{} segments, error {:.3e}; picture in {}", body.segments(), body.error, picture.display());
        Ok(())
    }
}
