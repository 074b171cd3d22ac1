//! What keeps an outline from being a solid, and where.

use crate::piece::Point;

/// Why an outline is no solid. Heights are the drawing's.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// No piece, or none longer than rounding.
    #[error("the outline is empty")]
    Empty,
    /// A coordinate is infinite or not a number.
    #[error("piece {piece} of the outline has a coordinate that is not finite")]
    NotFinite {
        /// Which piece, from 0.
        piece: usize,
    },
    /// A Bézier piece without control points, or of too high a degree.
    #[error("a Bézier piece with {points} control points: from 1 to {} are read", crate::HIGHEST_DEGREE + 1)]
    Degree {
        /// How many control points it has.
        points: usize,
    },
    /// A piece begins elsewhere than where the one before it ends.
    #[error("the outline is torn: a piece ends at ({}, {}), the next one begins at ({}, {})", end.r, end.z, start.r, start.z)]
    NotJoined {
        /// Where the one ends.
        end: Point,
        /// Where the other begins.
        start: Point,
    },
    /// The outline passes from one side of the axis to the other.
    #[error(
        "the outline crosses the axis at {}; `--half right` or `--half left` takes one of its halves",
        listed(heights)
    )]
    CrossesAxis {
        /// At which heights.
        heights: Vec<f64>,
    },
    /// Two parts of the outline cross.
    #[error("the outline crosses itself at height {height}, radius {radius}")]
    CrossesItself {
        /// At which height.
        height: f64,
        /// At which distance from the axis.
        radius: f64,
    },
    /// All of it lies on the axis, or at one height.
    #[error("the outline has no wall: all of it lies on the axis, or at one height")]
    NoWall,
    /// A tolerance that is no positive number.
    #[error("the tolerance {0} is not a positive number")]
    Tolerance(f64),
    /// The tolerance is finer than what f32 can say about numbers of this size, or the outline has a place
    /// that no cubic follows.
    #[error("no segments are proven to be within {tolerance} of the outline about height {height}")]
    OutOfReach {
        /// What was asked for.
        tolerance: f64,
        /// At about which height.
        height: f64,
    },
    /// The fits of two walls cross, though the walls do not: they come nearer to each other than the tolerance.
    #[error(
        "two walls come so near to each other at height {height} that their fits cross: ask for a smaller tolerance"
    )]
    WallsMeet {
        /// At which height.
        height: f64,
    },
    /// More pieces than can be worked through in decent time.
    #[error("the outline has {0} pieces; {most} is the most", most = crate::MOST_PIECES)]
    TooManyPieces(usize),
}

fn listed(heights: &[f64]) -> String {
    let texts: Vec<String> = heights.iter().map(f64::to_string).collect();
    let word = if texts.len() == 1 { "height" } else { "the heights" };
    format!("{word} {}", texts.join(", "))
}

/// What was done to an outline that whoever drew it should know of.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// All of it lay left of the axis: its mirror image was taken.
    Mirrored,
    /// A turn in height, shallower than the tolerance, was replaced by a flat.
    Straightened {
        /// The height of the flat.
        height: f64,
        /// The radii between which it lies.
        radii: [f64; 2],
        /// How far the drawing is from it.
        error: f64,
    },
    /// A wall so low that its ends are one f32 became a flat.
    Merged {
        /// The heights that are one number.
        heights: [f64; 2],
    },
    /// The half that was left out differs from the one taken.
    HalvesDiffer {
        /// The largest distance between them.
        by: f64,
    },
    /// Something else in the file was left out.
    LeftOut {
        /// What.
        what: String,
    },
}

impl core::fmt::Display for Warning {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Mirrored => write!(f, "all of the outline lies left of the axis: mirrored"),
            Self::Straightened { height, radii: [a, b], error } => {
                write!(
                    f,
                    "a turn at height {height}, between the radii {a:.5} and {b:.5}, straightened (off by {error:.3e})"
                )
            }
            Self::Merged { heights: [a, b] } => {
                write!(f, "the heights {a} and {b} are one in f32: made a flat")
            }
            Self::HalvesDiffer { by } => write!(f, "the outline's halves differ by {by:.3e}"),
            Self::LeftOut { what } => write!(f, "{what} was left out"),
        }
    }
}
