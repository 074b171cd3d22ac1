//! The stretches of a wall that are fitted as one, from one level place or pole to the next, and the places in them
//! where knots may lie.

use crate::{
    piece::{Jet, Piece, Point},
    walls::Wall,
};

/// A stretch of a wall, from its lower end to its upper one, off the axis and with no level tangent except at its
/// ends. It may have corners.
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

impl Tip {
    /// How a curve that ends there is continued, for what its sides are: a slope of radius over height. Upright,
    /// or 14° off as the tip leans where it is level, and towards the other side of the axis at a pole.
    pub fn ray(&self, upper: bool) -> f64 {
        match self {
            Self { at: Point { r: 0.0, .. }, .. } => {
                if upper {
                    -0.25
                } else {
                    0.25
                }
            }
            Self { level: true, leans, .. } => 0.25 * leans,
            _ => 0.0,
        }
    }
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
            Some(section) if joins(&section.pieces[section.pieces.len() - 1], piece) => {
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

/// Whether a piece that ends where the next one begins does so off the axis, and neither is level there. A piece
/// between corners that is so low that its ends are one height in f32 stays apart: it becomes a flat.
fn joins(piece: &Piece, next: &Piece) -> bool {
    let (end, start) = (piece.jet(1.0), next.jet(0.0));
    let is_merged = |piece: &Piece| piece.start().z as f32 == piece.end().z as f32;
    let stays_apart = (is_merged(piece) || is_merged(next)) && is_corner(piece, next);
    end.r > 0.0 && !is_flat(&end) && !is_flat(&start) && !stays_apart
}

/// Whether the tangents differ where one piece ends and the next one begins.
fn is_corner(piece: &Piece, next: &Piece) -> bool {
    let [below, above] = [normal(piece, 1.0), normal(next, 0.0)].map(|[r, z]| z.atan2(r));
    !((below - above).abs() <= SMOOTH)
}

/// The unit normal of a piece that rises, away from the axis. Where the piece stands still in its parameter, that
/// of a place close by.
pub(crate) fn normal(piece: &Piece, t: f64) -> [f64; 2] {
    let size = piece.start().distance(piece.end());
    let mut jet = piece.jet(t);
    if !(jet.dr.hypot(jet.dz) > 1e-9 * size) {
        jet = piece.jet(t + if t < 0.5 { 1e-5 } else { -1e-5 });
    }
    let length = jet.dr.hypot(jet.dz);
    if length > 0.0 { [jet.dz / length, -jet.dr / length] } else { [1.0, 0.0] }
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
    /// r².
    pub f: f64,
    /// The slope of r² over height, below and above: two numbers at a corner.
    pub slopes: [f64; 2],
    /// The unit normal that points away from the axis; at a corner the direction between both normals.
    pub normal: [f64; 2],
    /// The normals below and above: two at a corner.
    pub normals: [[f64; 2]; 2],
    /// Whether there is a corner.
    pub is_corner: bool,
}

impl Place {
    /// The direction at a part of the way from the normal below to that above.
    pub fn between(&self, part: f64) -> [f64; 2] {
        let [below, above] = self.normals.map(|[r, z]| z.atan2(r));
        let (sin, cos) = (below + part * (above - below)).sin_cos();
        [cos, sin]
    }

    /// Whether the place is a corner with a gap between the normals outside of it (+1), or inside (−1). On the other
    /// side they cross.
    pub fn is_gapped(&self, side: f64) -> bool {
        let [[r0, z0], [r1, z1]] = self.normals;
        self.is_corner && side * (r0 * z1 - z0 * r1) > 0.0
    }
}

impl Section {
    /// The place at s, the number of a piece plus its t.
    pub fn place(&self, s: f64) -> Place {
        let i = (s.max(0.0) as usize).min(self.pieces.len() - 1);
        let t = s - i as f64;
        let jet = self.pieces[i].jet(t);
        let own = normal(&self.pieces[i], t);
        let mut place = Place {
            s,
            r: jet.r,
            z: jet.z,
            f: jet.f,
            slopes: [jet.slope; 2],
            normal: own,
            normals: [own; 2],
            is_corner: false,
        };
        if t == 0.0 && i > 0 {
            let below = &self.pieces[i - 1];
            if is_corner(below, &self.pieces[i]) {
                place.normals[0] = normal(below, 1.0);
                place.normal = place.between(0.5);
                place.slopes[0] = below.jet(1.0).slope;
                place.is_corner = true;
            }
        }
        place
    }

    /// The direction in which a place is left to a side: the normal. Within some distance of a corner where normals
    /// to that side cross it turns to the corner's direction.
    pub fn direction(&self, place: &Place, side: f64, within: f64) -> [f64; 2] {
        let i = (place.s.max(0.0) as usize).min(self.pieces.len() - 1);
        let piece = &self.pieces[i];
        let within = within.min(piece.start().distance(piece.end()));
        let angle = |[r, z]: [f64; 2]| z.atan2(r);
        let mut turn = 0.0;
        for join in [i, i + 1].map(|s| self.place(s as f64)).iter().filter(|join| join.is_gapped(-side)) {
            let weight = 1.0 - (place.r - join.r).hypot(place.z - join.z) / within;
            turn += weight.max(0.0) * (angle(join.normal) - angle(place.normal));
        }
        let (sin, cos) = (angle(place.normal) + turn).sin_cos();
        if turn == 0.0 { place.normal } else { [cos, sin] }
    }

    /// Places for knots, `count` of them or a few more, evenly in each piece's parameter and ever closer
    /// together towards the section's ends; between two of them [`SAMPLES`] − 1 places more.
    pub fn places(&self, count: usize) -> Vec<Place> {
        let n = self.pieces.len();
        let each = (count / n).max(if n > MANY { 4 } else { 16 });
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

/// A section of more pieces has a few places for knots in each.
const MANY: usize = 200;

/// How many steps there are from one place for a knot to the next.
pub(crate) const SAMPLES: usize = 4;

/// How often the distance to a section's end is halved.
const GRADED: usize = 14;
