//! Which side of the axis an outline lies on; what of it lies on the axis itself is no wall.

use crate::{
    error::{OutlineError, Warning},
    outline::Outline,
    piece::{Piece, Point},
};

/// One half of an outline that has both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// The half with positive radii.
    Right,
    /// The other one, mirrored.
    Left,
}

/// Pieces end to end with radii ≥ 0, none of them on the axis.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    pub pieces: Vec<Piece>,
    /// Whether it ends where it begins.
    pub closed: bool,
}

#[derive(Clone, Copy, PartialEq)]
enum Side {
    Right,
    Left,
    Axis,
}

/// Of the outline's size: a radius as small is zero, drawn by hand or rounded by a transform.
pub(crate) const ON_AXIS: f64 = 1e-7;

/// The outline without what lies on the axis, on its right.
pub(crate) fn one_side(
    outline: &Outline,
    half: Option<Half>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Chain>, OutlineError> {
    let near = ON_AXIS * outline.size();
    let mut parts: Vec<(Side, Piece)> = Vec::new();
    for piece in outline.pieces() {
        if piece.is_on_axis(near) {
            parts.push((Side::Axis, piece.clone()));
            continue;
        }
        let parts_before = parts.len();
        for part in piece.cut(&piece.meets_axis()) {
            let farthest = [0.25, 0.5, 0.75].map(|t| part.at(t).r);
            let r = farthest.into_iter().fold(0.0, |far: f64, r| if r.abs() > far.abs() { r } else { far });
            let side = match r {
                r if r > near => Side::Right,
                r if r < -near => Side::Left,
                // Cut off between two places that are both the axis.
                _ => Side::Axis,
            };
            parts.push((side, part));
        }
        // Of a piece that is not on the axis all of it is kept, unless two cuts lie side by side.
        let all = &parts[parts_before..];
        if all.iter().all(|(side, _)| *side == Side::Axis) {
            let side = if piece.at(0.5).r < 0.0 { Side::Left } else { Side::Right };
            parts[parts_before..].iter_mut().for_each(|part| part.0 = side);
        }
    }
    let has = |side| parts.iter().any(|part| part.0 == side);
    let side = match (has(Side::Right), has(Side::Left), half) {
        (true, true, None) => {
            return Err(OutlineError::CrossesAxis { heights: crossings(&parts, outline.is_closed()) });
        }
        (true, true, Some(half)) => {
            warnings.push(Warning::HalvesDiffer { by: difference(&parts) });
            if half == Half::Right { Side::Right } else { Side::Left }
        }
        (true, false, _) => Side::Right,
        (false, true, _) => {
            warnings.push(Warning::Mirrored);
            Side::Left
        }
        (false, false, _) => return Err(OutlineError::NoWall),
    };
    Ok(chains(parts, side, outline.is_closed(), near))
}

/// The heights at which one part lies right of the axis and the next one left of it.
fn crossings(parts: &[(Side, Piece)], closed: bool) -> Vec<f64> {
    let walls: Vec<_> = parts.iter().filter(|part| part.0 != Side::Axis).collect();
    let after_last = closed.then(|| walls[0]);
    let pairs = walls.iter().zip(walls.iter().skip(1).copied().chain(after_last));
    let mut heights: Vec<f64> = pairs.filter(|(a, b)| a.0 != b.0).map(|(a, _)| a.1.end().z).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    heights
}

/// The parts on one side, mirrored if it is the left one, in unbroken chains.
fn chains(mut parts: Vec<(Side, Piece)>, side: Side, closed: bool, near: f64) -> Vec<Chain> {
    let other = parts.iter().position(|part| part.0 != side);
    if let (true, Some(first)) = (closed, other) {
        parts.rotate_left(first);
    }
    let closed = closed && other.is_none();
    let mut chains: Vec<Chain> = Vec::new();
    let mut torn = true;
    for (of, piece) in parts {
        if of != side {
            torn = true;
            continue;
        }
        let mut piece = if side == Side::Left { piece.mirrored() } else { piece };
        let snap = |p: Point| if p.r.abs() <= near { Point { r: 0.0, ..p } } else { p };
        piece.weld(snap(piece.start()), snap(piece.end()));
        match chains.last_mut() {
            Some(chain) if !torn => chain.pieces.push(piece),
            _ => chains.push(Chain { pieces: vec![piece], closed }),
        }
        torn = false;
    }
    chains
}

/// How far the two halves are apart, each mirrored onto the other, by points on both.
fn difference(parts: &[(Side, Piece)]) -> f64 {
    let points = |side: Side| -> Vec<Point> {
        let of = parts.iter().filter(|part| part.0 == side);
        of.flat_map(|(_, piece)| (0..=32).map(|i| piece.at(f64::from(i) / 32.0)))
            .map(|p| Point { r: p.r.abs(), ..p })
            .collect()
    };
    let (right, left) = (points(Side::Right), points(Side::Left));
    let from = |points: &[Point], line: &[Point]| {
        let nearest =
            |p: &Point| line.windows(2).map(|ab| to_line(*p, ab[0], ab[1])).fold(f64::INFINITY, f64::min);
        points.iter().map(nearest).fold(0.0, f64::max)
    };
    from(&right, &left).max(from(&left, &right))
}

/// The distance of a point from a straight line between two others.
fn to_line(p: Point, a: Point, b: Point) -> f64 {
    let (dr, dz) = (b.r - a.r, b.z - a.z);
    let along = ((p.r - a.r) * dr + (p.z - a.z) * dz) / (dr * dr + dz * dz).max(f64::MIN_POSITIVE);
    let t = along.clamp(0.0, 1.0);
    p.distance(Point { r: a.r + t * dr, z: a.z + t * dz })
}
