//! Source text to paste, or to include from a `build.rs`.

use crate::{Body, Profiles, read::Unit};
use std::fmt::Write;

/// What the comment says of where the numbers are from.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The name of the `static`, in capitals.
    pub name: String,
    /// The file, or whatever else it is from.
    pub source: String,
    /// What the numbers are.
    pub unit: Unit,
}

impl Origin {
    /// The name of a `static` from that of a file: in capitals, with underscores for what Rust does not allow.
    pub fn named(file: &str, source: String, unit: Unit) -> Self {
        let mut name: String = file
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' })
            .collect();
        if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            name.insert_str(0, "OUTLINE_");
        }
        Self { name, source, unit }
    }
}

/// A body as a `static`, one solid, its numbers inside `valid!`, with a comment of its name, its source, its
/// tolerance and its proven error. It compiles after `use embedded_lathe::*;`.
pub fn source(body: &Body, origin: &Origin) -> String {
    let mut text = String::new();
    let unit = origin.unit.symbol();
    let segments = body.segments();
    let sheets = match body.sheets.len() {
        1 => String::new(),
        count => format!(" in {count} sheets"),
    };
    let _ = writeln!(text, "// {}, from {}: {segments} segments{sheets}.", origin.name, origin.source);
    // As it was asked for, unless it was computed.
    let tolerance = Some(format!("{:?}", body.tolerance)).filter(|text| text.len() <= 8);
    let tolerance = tolerance.unwrap_or_else(|| format!("{:.3e}", body.tolerance));
    let error = body.error;
    let _ = writeln!(
        text,
        "// Within {tolerance}{unit} of the drawing; proven for these numbers: {error:.3e}{unit}."
    );
    for warning in &body.warnings {
        let _ = writeln!(text, "// Mind: {warning}.");
    }
    text.push_str(&Profiles::of(body).source(&origin.name));
    text
}
