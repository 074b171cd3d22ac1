//! Files: SVG drawings, tables, and points by name in JSON.

mod form;
mod part;
mod path;
mod place;
mod shape;
mod svg;
mod table;
mod unit;

pub use place::{ReadError, Reason};
pub use unit::Unit;

use crate::{Half, Outline, OutlineError, Warning};
use std::path::Path;

/// What a file leaves open.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Which of several outlines: an element's id, or a name.
    pub name: Option<String>,
    /// What one user unit of an SVG is, where the file does not say.
    pub unit: Option<Unit>,
    /// Where in an SVG the axis is.
    pub axis: Axis,
    /// Which half to take of an outline that has both.
    pub half: Option<Half>,
    /// Whether points of a table are joined by straight lines, rather than by a smooth curve.
    pub straight: bool,
}

/// Where the axis of an SVG is: an upright line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Axis {
    /// At the element whose id is `axis`, or else at x = 0, after all transforms.
    #[default]
    Drawn,
    /// At another x, in the user units of the whole drawing.
    At(f64),
    /// At the outline's left edge.
    LeftEdge,
}

/// One outline of a file.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Its element's id or its name, if it has one.
    pub name: Option<String>,
    /// Heights and radii in `unit`. Of an SVG the lowest point is at height 0, above which its errors give heights.
    pub outline: Outline,
    /// What the numbers are.
    pub unit: Unit,
    /// What was left out.
    pub warnings: Vec<Warning>,
    /// Where in the file it stands: line and column.
    pub place: (u32, u32),
    /// Where in the file what it is drawn of stands.
    marks: part::Marks,
}

impl Drawing {
    /// An error of the outline with the file, and with the line and the column of what it names there: a command of a
    /// path, a row of a table, a point in JSON. Of the outline itself, if it names no place.
    pub fn error(&self, file: &Path, error: OutlineError) -> ReadError {
        let (line, column) = self.marks.culprit(&error).unwrap_or(self.place);
        ReadError { file: file.to_path_buf(), line, column, reason: error.into() }
    }
}

/// The outline that a file holds, the only one or the one with the name asked for.
///
/// # Errors
///
/// [`ReadError`], with the file, the line and the column.
pub fn read(file: &Path, options: &Options) -> Result<Drawing, ReadError> {
    let text = text(file)?;
    let of = place::Source { file, text: &text };
    match kind(file) {
        Kind::Svg => svg::one(&of, options),
        Kind::Table => table::one(&of, options),
        Kind::Form => form::one(&of, options),
        Kind::Other => Err(of.error(Reason::UnknownKind, 0)),
    }
}

/// Every outline that a file holds, each as it would be read if it were asked for by its name.
///
/// # Errors
///
/// [`ReadError`] if the file as a whole cannot be read.
pub fn read_all(file: &Path, options: &Options) -> Result<Vec<Result<Drawing, ReadError>>, ReadError> {
    let text = text(file)?;
    let of = place::Source { file, text: &text };
    match kind(file) {
        Kind::Svg => svg::all(&of, options),
        Kind::Table => Ok(vec![table::one(&of, options)]),
        Kind::Form => form::all(&of),
        Kind::Other => Err(of.error(Reason::UnknownKind, 0)),
    }
}

/// The same from text that is SVG.
///
/// # Errors
///
/// As [`read`].
pub fn svg(text: &str, options: &Options) -> Result<Drawing, ReadError> {
    svg::one(&place::Source { file: Path::new("svg"), text }, options)
}

/// The same from text that is a table.
///
/// # Errors
///
/// As [`read`].
pub fn table(text: &str, options: &Options) -> Result<Drawing, ReadError> {
    table::one(&place::Source { file: Path::new("table"), text }, options)
}

/// The same from text that is JSON.
///
/// # Errors
///
/// As [`read`].
pub fn json(text: &str, options: &Options) -> Result<Drawing, ReadError> {
    form::one(&place::Source { file: Path::new("json"), text }, options)
}

enum Kind {
    Svg,
    Table,
    Form,
    Other,
}

fn kind(file: &Path) -> Kind {
    match file.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("svg") => Kind::Svg,
        Some("csv") => Kind::Table,
        Some("json") => Kind::Form,
        _ => Kind::Other,
    }
}

fn text(file: &Path) -> Result<String, ReadError> {
    std::fs::read_to_string(file)
        .map_err(|error| place::Source { file, text: "" }.error(Reason::File(error.to_string()), 0))
}
