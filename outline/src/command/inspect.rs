//! What outlines a directory holds.

use super::patience;
use embedded_lathe_outline::{
    Body, Fit, Joins, OutlineError, Warning, body,
    read::{Axis, Drawing, Options, ReadError, Reason, Unit, read_all},
};
use std::{fs, path::Path, process::ExitCode};

/// The tolerances of the last columns, in sizes of the outline: the larger of its height and its width.
const TOLERANCES: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// Prints a table with a line for every outline of every SVG, CSV and JSON file, those refused included. Heights
/// are above the lowest point. Walls are counted from where the outline begins, with its turns shallower than the
/// middle tolerance straightened; their number and their heights are those of the drawing, before it is fitted.
pub(crate) fn run(directory: &Path, options: &Options) -> ExitCode {
    let entries = match fs::read_dir(directory) {
        Ok(entries) => entries,
        Err(error) => {
            eprintln!("{}: {error}", directory.display());
            return ExitCode::FAILURE;
        }
    };
    let mut files: Vec<_> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    files.retain(|file| {
        let extension = file.extension().and_then(|extension| extension.to_str());
        extension.is_some_and(|extension| ["svg", "csv", "json"].contains(&extension))
    });
    files.sort();
    println!(
        "| file | bounds | walls | turns and ends at height | flats at height | segments at 10⁻²/10⁻³/10⁻⁴, proven error | the same with free joins |"
    );
    println!("|---|---|--:|---|---|---|---|");
    for file in files {
        lines(&file, options);
    }
    ExitCode::SUCCESS
}

fn lines(file: &Path, options: &Options) {
    // Figures in the drawing's own numbers where it has no unit; said in the line.
    let without = |unit: Option<Unit>| Options { unit: options.unit.or(unit), ..options.clone() };
    match read_all(file, &without(None)) {
        Err(error) => refused(file, None, &error, ""),
        Ok(drawings) => {
            for (i, drawing) in drawings.into_iter().enumerate() {
                match drawing {
                    Ok(drawing) => line(file, i, &drawing, options, ""),
                    Err(error) if error.reason == Reason::NoUnit => {
                        refused(file, None, &error, "");
                        if let Ok(mut again) = read_all(file, &without(Some(Unit::None)))
                            && let Ok(drawing) = again.swap_remove(i)
                        {
                            line(file, i, &drawing, &without(Some(Unit::None)), " `--unit 1`");
                        }
                    }
                    Err(error) => refused(file, None, &error, ""),
                }
            }
        }
    }
}

fn line(file: &Path, number: usize, drawing: &Drawing, options: &Options, how: &str) {
    let [low, high] = drawing.outline.bounds();
    let size = (high.z - low.z).max(high.r - low.r);
    let fits = [Joins::Smooth, Joins::Free].map(|joins| {
        TOLERANCES.map(|tolerance| {
            let fit = Fit { half: options.half, joins, ..Fit::within(tolerance * size) };
            patience::with(format!("fitting {}", file.display()), || body(&drawing.outline, &fit))
        })
    });
    let name = name(file, drawing.name.as_deref());
    let shape = match &fits[0][1] {
        Ok(Body { shape, .. }) => shape,
        Err(error) => {
            refused(file, drawing.name.as_deref(), &drawing.error(file, error.clone()), how);
            // An open outline with both ends on its left edge has its axis there.
            let ends = [
                drawing.outline.pieces()[0].start(),
                drawing.outline.pieces()[drawing.outline.pieces().len() - 1].end(),
            ];
            let is_edge = ends.iter().all(|end| (end.r - low.r).abs() <= 1e-6 * size);
            let crosses = matches!(error, OutlineError::CrossesAxis { .. });
            if crosses && is_edge && !drawing.outline.is_closed() && options.axis == Axis::Drawn {
                let at_edge = Options { axis: Axis::LeftEdge, ..options.clone() };
                if let Ok(mut again) = read_all(file, &at_edge)
                    && let Ok(drawing) = again.swap_remove(number)
                {
                    line(file, number, &drawing, &at_edge, &format!("{how} `--axis left`"));
                }
            }
            return;
        }
    };
    let above = |z: f64| short(z - low.z);
    let heights: Vec<String> = shape.heights.iter().map(|z| above(*z)).collect();
    let flats: Vec<String> = shape
        .flats
        .iter()
        .map(|(z, [from, to])| format!("{} (r {}–{})", above(*z), short(*from), short(*to)))
        .collect();
    let flats = if flats.is_empty() { "–".into() } else { flats.join("; ") };
    let counts = fits.each_ref().map(|fits| {
        let of = |fit: &Result<Body, OutlineError>| match fit {
            Ok(body) => format!("{} ({:.1e})", body.segments(), body.error),
            Err(error) => error.to_string(),
        };
        fits.each_ref().map(of).join(" / ")
    });
    let least = if low.r.abs() > 1e-6 * size {
        format!("r {}–{}", short(low.r), short(high.r))
    } else {
        format!("r ≤ {}", short(high.r))
    };
    println!(
        "| {name}{how} | {least}, height {}{} | {} | {} | {flats} | {} | {} |",
        short(high.z - low.z),
        drawing.unit.symbol(),
        shape.walls,
        heights.join(", "),
        counts[0],
        counts[1],
    );
    if let Ok(body) = &fits[0][1] {
        for warning in body.warnings.iter().filter(|warning| !matches!(warning, Warning::LeftOut { .. })) {
            println!("| {name} | at 10⁻³: {warning} | | | | | |");
        }
    }
}

fn refused(file: &Path, outline: Option<&str>, error: &ReadError, how: &str) {
    let at = format!("{}:{}", error.line, error.column);
    println!("| {}{how} | refused at {at}: {} | | | | | |", name(file, outline), error.reason);
}

fn name(file: &Path, outline: Option<&str>) -> String {
    let file = file.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
    match outline {
        None => file.to_string(),
        Some(outline) => format!("{file} {outline}"),
    }
}

/// Six digits of a number, without zeros at its end.
fn short(number: f64) -> String {
    let digits = (5.0 - number.abs().max(1e-9).log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{number:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}
