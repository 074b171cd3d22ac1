//! The truth the kernel is held to: f64, `std`, written from the surface's definition alone.
//!
//! The solid is `k·x² + y² < f(z)`, f a cubic in height on every segment. Along a line the function
//! `g = f − (k·x² + y²)` is then a cubic between two joins, and a cubic is its four values: it is sampled by its
//! definition, interpolated in Bernstein form, halved until Descartes' rule leaves one root or none, and bisected.
//!
//! - [`crossings`]: every crossing beyond `t_min`, in order.
//! - [`bands`]: where on the ray a crossing must be found by anyone whose surface is off by less than `eps`.
//! - [`robust`], [`certain`]: whether the whole list is beyond dispute at `eps`, or at the oracle's own rounding.

mod band;
mod bernstein;
mod crossing;
mod line;
mod shape;

pub use band::{Band, Bands, bands, certain, robust};
pub use bernstein::value;
pub use crossing::{Crossing, Part, crossings};
pub use line::Ray;
pub use shape::Shape;
