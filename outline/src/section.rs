//! The smooth stretches of a wall, from corner to corner, and the places in them where knots may lie.

use crate::{
    piece::{Jet, Piece, Point},
    walls::Wall,
};

/// A stretch of a wall, from its lower end to its upper one, without a corner and with no level tangent except
/// at its ends.
#[derive(Clone, Debug)]
pub(crate) struct Section {
    pub pieces: Vec<Piece>,
    pub low: Tip,
    pub high: Tip,
}

/// An end of a section.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tip {
    pub at: Point,
    /// The tangent there is so near level that no cubic may follow it.
    pub level: bool,
    /// If so, the segment beside it may end at another radius, and a step takes the rest.
    pub step: bool,
    /// The sign with which the radius changes upwards.
    pub leans: f64,
}

/// Tangents that differ by no more (in radians) join smoothly.
const SMOOTH: f64 = 1e-3;

/// Of a tangent's radius: a height as small makes it near level.
const NEAR_LEVEL: f64 = 0.1;

/// Of a tangent's radius: a height as small is a level tangent, drawn or rounded.
const LEVEL: f64 = 1e-6;

/// A wall's sections.
pub(crate) fn sections(wall: &Wall) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for piece in &wall.pieces {
        let (start, end) = (piece.jet(0.0), piece.jet(1.0));
        let high = Tip { at: piece.end(), level: is_level(&end), step: true, leans: end.dr.signum() };
        match sections.last_mut() {
            Some(section) if joins(&section.pieces[section.pieces.len() - 1], &start) => {
                section.pieces.push(piece.clone());
                section.high = high;
            }
            _ => {
                let low =
                    Tip { at: piece.start(), level: is_level(&start), step: true, leans: start.dr.signum() };
                sections.push(Section { pieces: vec![piece.clone()], low, high });
            }
        }
    }
    sections
}

fn is_level(jet: &Jet) -> bool {
    match jet.r {
        // A pole with a level tangent is round, and no trouble.
        0.0 => !(jet.slope.abs() < 1e6 * jet.dr.hypot(jet.dz)),
        _ => jet.dz.abs() < NEAR_LEVEL * jet.dr.abs(),
    }
}

/// Whether a piece that ends where the next one begins does so smoothly, off the axis, and not level.
fn joins(piece: &Piece, next: &Jet) -> bool {
    let end = piece.jet(1.0);
    let (cross, dot) = (end.dr * next.dz - end.dz * next.dr, end.dr * next.dr + end.dz * next.dz);
    end.r > 0.0 && cross.atan2(dot).abs() <= SMOOTH && !is_flat(&end) && !is_flat(next)
}

/// Whether the tangent is level.
pub(crate) fn is_flat(jet: &Jet) -> bool {
    jet.dz.abs() <= LEVEL * jet.dr.abs()
}

/// Where inside a wall its height stands still: one piece ends level, and the next one begins so.
pub(crate) fn still(wall: &Wall) -> impl Iterator<Item = Point> {
    let joins =
        wall.pieces.windows(2).filter(|pair| is_flat(&pair[0].jet(1.0)) && is_flat(&pair[1].jet(0.0)));
    joins.map(|pair| pair[0].end())
}

/// A place on a section: what a knot there would have, and the normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// The piece's number plus t.
    pub s: f64,
    pub r: f64,
    pub z: f64,
    /// r² and its slope over height.
    pub f: f64,
    pub slope: f64,
    /// The unit normal that points away from the axis.
    pub normal: Point,
}

impl Section {
    /// The place at s, the number of a piece plus its t.
    pub fn place(&self, s: f64) -> Place {
        let i = (s.max(0.0) as usize).min(self.pieces.len() - 1);
        let jet = self.pieces[i].jet(s - i as f64);
        let length = jet.dr.hypot(jet.dz).max(f64::MIN_POSITIVE);
        let normal = Point { r: jet.dz / length, z: -jet.dr / length };
        Place { s, r: jet.r, z: jet.z, f: jet.f, slope: jet.slope, normal }
    }

    /// Places for knots, `count` of them or a few more, evenly in each piece's parameter and ever closer
    /// together towards the section's ends; between two of them [`SAMPLES`] − 1 places more.
    pub fn places(&self, count: usize) -> Vec<Place> {
        let n = self.pieces.len();
        let each = (count / n).max(4);
        let mut at: Vec<f64> =
            (0..n * each).map(|i| (i / each) as f64 + (i % each) as f64 / each as f64).collect();
        at.push(n as f64);
        let closer = (1..GRADED).map(|k| (-(k as f64)).exp2() / each as f64);
        at.extend(closer.clone());
        at.extend(closer.map(|s| n as f64 - s));
        at.sort_by(f64::total_cmp);
        at.dedup();
        let between = |pair: &[f64]| {
            let (a, b) = (pair[0], pair[1]);
            (0..SAMPLES).map(move |i| a + (b - a) * i as f64 / SAMPLES as f64)
        };
        let mut places: Vec<Place> = at.windows(2).flat_map(between).map(|s| self.place(s)).collect();
        places.push(self.place(n as f64));
        places
    }
}

/// How many steps there are from one place for a knot to the next.
pub(crate) const SAMPLES: usize = 4;

/// How often the distance to a section's end is halved.
const GRADED: usize = 14;
