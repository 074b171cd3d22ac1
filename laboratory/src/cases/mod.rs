//! Seeded inputs for the tests: outlines and rays as plain f32 numbers, each ray reproducible alone.
//!
//! `case(&outline(name), family, seed, index)` makes the same ray every time; a [`Case`] prints all it is made of.

mod bodies;
mod family;
mod outline;
mod place;
mod stepped;

pub use bodies::{Body, Expected, bodies};
pub use family::Family;
pub use outline::{Outline, outline, outlines};
pub use stepped::stepped_outlines;

use crate::ROUNDOFF;
use crate::oracle;
use place::Place;
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;
use std::fmt;

/// t in units of the direction as given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cast {
    pub origin: [f32; 3],
    pub direction: [f32; 3],
    pub t_min: f32,
}

impl Cast {
    pub fn ray(&self) -> oracle::Ray {
        oracle::Ray {
            origin: self.origin.map(f64::from),
            direction: self.direction.map(f64::from),
            t_min: self.t_min.into(),
        }
    }

    /// `|c| / |D|`, the sine of the ray's angle to the horizontal.
    pub fn steepness(&self) -> f64 {
        let [a, b, c] = self.direction.map(f64::from);
        c.abs() / (a * a + b * b + c * c).sqrt()
    }
}

/// One ray at one outline, and how to make it again.
#[derive(Clone, Copy)]
pub struct Case<'a> {
    pub outline: &'a Outline,
    pub family: Family,
    pub seed: u64,
    pub index: u64,
    pub cast: Cast,
}

impl Case<'_> {
    pub fn ray(&self) -> oracle::Ray {
        self.cast.ray()
    }

    /// So many units of the case's ray.
    pub fn eps(&self, units: f64) -> f64 {
        units * self.outline.unit(self.cast.origin)
    }

    /// The unit of the point at t: its distance from the ray's origin counts as well.
    pub fn unit_at(&self, t: f64) -> f64 {
        let length = self.ray().direction.iter().map(|c| c * c).sum::<f64>().sqrt();
        self.eps(1.0) + ROUNDOFF * (t * length).abs()
    }
}

impl fmt::Display for Case<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "case(&outline({:?}), Family::{:?}, {}, {})",
            self.outline.name, self.family, self.seed, self.index
        )?;
        writeln!(f, "  {:?}", self.cast)?;
        write!(f, "  {:?}", self.outline)
    }
}

pub fn case(outline: &Outline, family: Family, seed: u64, index: u64) -> Case<'_> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(index);
    let cast = family.cast(&mut Place::new(outline, rng));
    Case { outline, family, seed, index, cast }
}

pub fn cases(outline: &Outline, family: Family, seed: u64, count: u64) -> impl Iterator<Item = Case<'_>> {
    (0..count).map(move |index| case(outline, family, seed, index))
}
