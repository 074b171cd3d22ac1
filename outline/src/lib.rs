//! From a drawing to a solid of `embedded-lathe`: any outline as cubic segments, with a proven error.
//!
//! An outline is a line from a drawing, a table or a program: straight pieces, arcs, Bézier curves of any degree in
//! radius and height. A body of the crate is cubic in *squared* radius over height. This library turns the one into
//! the other, with the least number of segments that it finds within a tolerance, and proves for the very f32
//! numbers that it prints how far the two are apart.
//!
//! ```
//! use embedded_lathe_outline::{Fit, Outline, Piece, body, point};
//!
//! // A bowl: a foot, a belly, and back inside to the axis.
//! let outside = Piece::bezier(&[point(0.3, 0.0), point(1.1, 0.1), point(1.0, 0.6), point(0.9, 0.8)]);
//! let rim = Piece::line(point(0.9, 0.8), point(0.85, 0.8));
//! let inside = Piece::bezier(&[point(0.85, 0.8), point(0.9, 0.4), point(0.8, 0.1), point(0.0, 0.1)]);
//! let bowl = Outline::open(vec![Piece::line(point(0.0, 0.0), point(0.3, 0.0)), outside, rim, inside])?;
//!
//! let body = body(&bowl, &Fit::within(0.002))?;
//! assert!(body.error <= 0.002 && body.sheets.len() == 2 && body.segments() <= 7);
//! # Ok::<(), embedded_lathe_outline::OutlineError>(())
//! ```
//!
//! # The pipe
//!
//! ```text
//! read/ → outline (pieces) → axis → straighten, walls → section → fit → certificate → body
//! ```
//!
//! | stage | from | to |
//! |---|---|---|
//! | [`read`] | SVG, CSV, JSON | an outline, or an error with line and column |
//! | [`Outline`] | [`Piece`]s | a chain of them, checked |
//! | axis | both sides of the axis | one side, cut where it touches the axis |
//! | walls | turns in height | walls that only rise or only fall, and flats between them |
//! | section | level places and poles | stretches between them, and places for knots |
//! | fit | a tolerance | the fewest segments |
//! | certificate | segments rounded to f32 | how far they are from the section, proven |
//! | [`Body`] | | sheets with steps, outer and inner |

// Boards have no files. The member is empty there, so that a workspace can be built for one.
#![cfg(not(target_os = "none"))]
#![warn(missing_docs)]

mod axis;
mod ball;
mod bernstein;
mod body;
mod certificate;
mod crossing;
mod cusps;
mod emit;
mod error;
mod fit;
mod outline;
mod picture;
mod piece;
mod profiles;
pub mod read;
mod region;
mod section;
mod segment;
mod solid;
mod straighten;
mod tube;
mod walls;

pub use axis::Half;
pub use bernstein::HIGHEST_DEGREE;
pub use body::{Body, Shape, Sheet, Side};
pub use emit::{Origin, source};
pub use error::{OutlineError, Warning};
pub use outline::Outline;
pub use picture::{PictureError, png};
pub use piece::{Piece, Point, point};
pub use profiles::Profiles;
pub use segment::Segment;
pub use solid::{Fit, Joins, body};

/// The most pieces that an outline may have.
pub const MOST_PIECES: usize = 2000;

/// The examples in README.md are compiled.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
