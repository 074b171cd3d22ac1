//! Every crossing of a ray, in order.

use super::bernstein::{self, lerp};
use super::line::{Line, Ray};
use super::shape::Shape;

/// The piece of surface crossed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Wall,
    Base,
    Top,
    Ring,
}

#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// In units of the given direction.
    pub t: f64,
    /// Into the solid, or, through the wall of an open shell, to its inner side.
    pub enters: bool,
    pub part: Part,
    pub segment: usize,
    pub u: f64,
    pub point: [f64; 3],
    /// Outward, of length 1.
    pub normal: [f64; 3],
    /// `|normal·direction| / |direction|`.
    pub cos: f64,
    /// No more than the distance to the nearest crease, rim or conical pole.
    pub to_crease: f64,
}

/// Between two joins, or where the line enters or leaves the cylinder about the solid.
struct Piece {
    segment: usize,
    s: [f64; 2],
    u: [f64; 2],
}

impl Piece {
    /// Parameters of line and profile; at w = 0 and 1 the very floats a neighbour has.
    fn at(&self, w: f64) -> (f64, f64) {
        (lerp(self.s[0], self.s[1], w), lerp(self.u[0], self.u[1], w))
    }
}

/// All crossings with `t > t_min`. Positions are good to some 1e-15 of the size over [`Crossing::cos`], however far the
/// origin; two roots nearer than rounding can tell may be none, which [`super::certain`] reports.
pub fn crossings(shape: &Shape, ray: &Ray) -> Vec<Crossing> {
    let line = Line::new(shape, ray);
    let mut found = Vec::new();
    // A little wider than the solid, so that g is surely below zero where the line is cut off.
    let span = line.within(shape.widest() * 1.001);
    let pieces = span.map_or(Vec::new(), |span| pieces(shape, &line, span));
    for (number, piece) in pieces.iter().enumerate() {
        let values = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|w| {
            let (s, u) = piece.at(w);
            value(shape, &line, piece.segment, s, u)
        });
        let changes = bernstein::sign_changes(bernstein::through(values));
        found.extend(ring(shape, &line, piece, 0));
        found.extend(changes.into_iter().map(|(w, enters)| wall(shape, &line, piece, w, enters)));
        if number + 1 == pieces.len() {
            found.extend(ring(shape, &line, piece, 1));
        }
    }
    found.retain(|crossing| crossing.t > ray.t_min);
    found
}

/// g by its definition.
fn value(shape: &Shape, line: &Line, segment: usize, s: f64, u: f64) -> f64 {
    bernstein::value(shape.squared_radius(segment), u) - line.squared_distance(s)
}

fn pieces(shape: &Shape, line: &Line, span: [f64; 2]) -> Vec<Piece> {
    if line.horizontal() {
        let z = line.near[2];
        let (segment, u) = shape.locate(z);
        // With no way to go in y or z, g is constant and nothing is crossed.
        let runs = (shape.base()..=shape.top()).contains(&z) && span[0].is_finite();
        return Vec::from_iter(runs.then_some(Piece { segment, s: span, u: [u, u] }));
    }
    let up = line.direction[2] > 0.0;
    let cut = |segment: usize| {
        let (z, h) = (shape.knots[segment], shape.knots[segment + 1] - shape.knots[segment]);
        let u = if up { [0.0, 1.0] } else { [1.0, 0.0] };
        let s = u.map(|u| line.at_height(shape.knots[segment + u as usize]));
        let clip = |s: f64, u: f64| {
            let held = s.clamp(span[0], span[1]);
            let u = if held == s {
                u
            } else {
                (((line.near[2] - z) + held * line.direction[2]) / h).clamp(0.0, 1.0)
            };
            (held, u)
        };
        let ((s0, u0), (s1, u1)) = (clip(s[0], u[0]), clip(s[1], u[1]));
        (s0 < s1).then_some(Piece { segment, s: [s0, s1], u: [u0, u1] })
    };
    if up {
        (0..shape.segments()).filter_map(cut).collect()
    } else {
        (0..shape.segments()).rev().filter_map(cut).collect()
    }
}

fn wall(shape: &Shape, line: &Line, piece: &Piece, w: f64, enters: bool) -> Crossing {
    let (s, u) = piece.at(w);
    let point = line.point(s);
    let normal = shape.wall_normal(piece.segment, u, point);
    Crossing {
        t: line.t0 + s,
        enters,
        part: Part::Wall,
        segment: piece.segment,
        u,
        point,
        normal,
        cos: cosine(normal, line.direction),
        to_crease: shape.to_crease(point),
    }
}

/// The ring at one end of a piece, if that lies on a knot's plane, and the line changes sides there. It does so by the very
/// numbers that g has there.
fn ring(shape: &Shape, line: &Line, piece: &Piece, end: usize) -> Option<Crossing> {
    let (s, u) = (piece.s[end], piece.u[end]);
    if line.horizontal()
        || (u != 0.0 && u != 1.0)
        || line.at_height(shape.knots[piece.segment + u as usize]) != s
    {
        return None;
    }
    let knot = piece.segment + u as usize;
    let [below, above] = shape.radii(knot);
    let up = line.direction[2] > 0.0;
    let (before, behind) = if up { (below, above) } else { (above, below) };
    let square = line.squared_distance(s);
    let enters = behind > square;
    if (before > square) == enters || before == behind {
        return None;
    }
    let normal = [0.0, 0.0, if below > above { 1.0 } else { -1.0 }];
    let part = if knot == 0 {
        Part::Base
    } else if knot == shape.segments() {
        Part::Top
    } else {
        Part::Ring
    };
    let is_of_lower = part == Part::Top || part == Part::Ring && below > above;
    Some(Crossing {
        t: line.t0 + s,
        enters,
        part,
        segment: if is_of_lower { knot - 1 } else { knot },
        u: if is_of_lower { 1.0 } else { 0.0 },
        point: line.point(s),
        normal,
        cos: cosine(normal, line.direction),
        to_crease: shape.to_rim(knot, square.sqrt()),
    })
}

fn cosine(n: [f64; 3], d: [f64; 3]) -> f64 {
    let dot: f64 = (0..3).map(|i| n[i] * d[i]).sum();
    dot.abs() / d.iter().map(|c| c * c).sum::<f64>().sqrt()
}
