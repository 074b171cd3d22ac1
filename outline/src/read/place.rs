//! Errors that name the file, the line and the column.

use crate::OutlineError;
use std::path::{Path, PathBuf};

/// Why a file holds no outline, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}:{line}:{column}: {reason}", file.display())]
pub struct ReadError {
    /// The file.
    pub file: PathBuf,
    /// The line, from 1.
    pub line: u32,
    /// The character in it, from 1.
    pub column: u32,
    /// What is wrong there.
    pub reason: Reason,
}

/// What is wrong in a file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Reason {
    /// The file could not be read.
    #[error("{0}")]
    File(String),
    /// None of the kinds that are read.
    #[error("not a file whose name ends in .svg, .csv or .json")]
    UnknownKind,
    /// Its syntax is wrong.
    #[error("{0}")]
    Syntax(String),
    /// There is no outline in it.
    #[error("no path or basic shape in the file")]
    NoShape,
    /// There are several, and none was asked for by name.
    #[error("several outlines, ask for one by `--path`: {}", .0.join(", "))]
    Ambiguous(Vec<String>),
    /// There is none with the name asked for.
    #[error("no outline has the name {name:?}: there are {}", names.join(", "))]
    NotFound {
        /// The name asked for.
        name: String,
        /// Those that there are.
        names: Vec<String>,
    },
    /// The drawing's lengths have no unit.
    #[error(
        "the drawing has no unit of length: `--unit mm` (or cm, in, pt, px, or `--unit 1` for none) says what one user unit is"
    )]
    NoUnit,
    /// The element that gives the axis is no upright line.
    #[error("the element with the id \"axis\" is not an upright line")]
    Axis,
    /// Something that is not read.
    #[error("{0} is not read")]
    Unsupported(String),
    /// The lines make no outline.
    #[error(transparent)]
    Outline(#[from] OutlineError),
}

/// The text that places lie in.
pub(crate) struct Source<'a> {
    pub file: &'a Path,
    pub text: &'a str,
}

impl Source<'_> {
    /// An error at a byte of the text.
    pub fn error(&self, reason: Reason, at: usize) -> ReadError {
        let (line, column) = self.place(at);
        self.error_in(reason, line, column)
    }

    pub fn error_in(&self, reason: Reason, line: u32, column: u32) -> ReadError {
        ReadError { file: self.file.to_path_buf(), line, column, reason }
    }

    /// The line and the column of a byte.
    pub fn place(&self, at: usize) -> (u32, u32) {
        let mut at = at.min(self.text.len());
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &self.text[..at];
        let line = before.matches('\n').count();
        let column = before.rsplit('\n').next().map_or(0, |line| line.chars().count());
        (line as u32 + 1, column as u32 + 1)
    }
}
