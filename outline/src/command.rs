//! What the command line asks for.

mod convert;
mod inspect;
mod patience;

use clap::{Args, Parser, Subcommand};
use embedded_lathe_outline::{
    Half,
    read::{Axis, Options, Unit},
};
use std::{path::PathBuf, process::ExitCode};

/// From a drawing to a solid for embedded-lathe: prints the `static`, its error proven.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true, arg_required_else_help = true)]
struct Command {
    #[command(subcommand)]
    other: Option<Other>,
    #[command(flatten)]
    convert: convert::Arguments,
}

#[derive(Subcommand)]
enum Other {
    /// Prints a line for every outline of every file in a directory: what it is, and how many segments it takes.
    Inspect {
        /// Where the files are.
        directory: PathBuf,
        #[command(flatten)]
        reading: Reading,
    },
}

/// What a file leaves open.
#[derive(Args)]
struct Reading {
    /// Which of several outlines: the id of its element, or its name.
    #[arg(long, value_name = "ID")]
    path: Option<String>,
    /// What one user unit of an SVG is, where the file does not say: mm, cm, in, pt, px, 0.1mm, or 1 for no unit.
    #[arg(long, value_parser = unit)]
    unit: Option<Unit>,
    /// Where in an SVG the axis is: its x, or `left` for the outline's left edge. Otherwise it is the element with
    /// the id "axis", or x = 0.
    #[arg(long, value_parser = axis, allow_hyphen_values = true)]
    axis: Option<Axis>,
    /// Which half to take of an outline that has both.
    #[arg(long, value_parser = half)]
    half: Option<Half>,
    /// Join the points of a table by straight lines, rather than by a smooth curve.
    #[arg(long)]
    straight: bool,
}

impl Reading {
    fn options(&self) -> Options {
        let axis = self.axis.unwrap_or_default();
        Options { name: self.path.clone(), unit: self.unit, axis, half: self.half, straight: self.straight }
    }
}

fn unit(text: &str) -> Result<Unit, String> {
    Unit::from_name(text)
        .ok_or_else(|| format!("{text:?} is not a unit of length, such as mm or 0.1mm, nor 1"))
}

fn axis(text: &str) -> Result<Axis, String> {
    match (text, text.parse()) {
        ("left", _) => Ok(Axis::LeftEdge),
        (_, Ok(x)) => Ok(Axis::At(x)),
        _ => Err(format!("{text:?} is neither a number nor `left`")),
    }
}

fn half(text: &str) -> Result<Half, String> {
    match text {
        "right" => Ok(Half::Right),
        "left" => Ok(Half::Left),
        _ => Err(format!("{text:?} is neither `right` nor `left`")),
    }
}

pub(crate) fn run() -> ExitCode {
    let command = Command::parse();
    match command.other {
        Some(Other::Inspect { directory, reading }) => inspect::run(&directory, &reading.options()),
        None => command.convert.run(),
    }
}
