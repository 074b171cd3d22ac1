//! From a chain of pieces to walls, each of which only rises or only falls, and the flats between them.

use crate::{
    axis::Chain,
    error::{OutlineError, Warning},
    piece::{Piece, Point},
    straighten,
};

/// What an outline is made of, in the order in which it is drawn.
#[derive(Clone, Debug)]
pub(crate) enum Run {
    Wall(Wall),
    Flat(Flat),
}

/// A part of the outline along which height only rises, or only falls.
#[derive(Clone, Debug)]
pub(crate) struct Wall {
    /// From its lower end to its upper one, whichever way it is drawn.
    pub pieces: Vec<Piece>,
    /// Whether it is drawn from its lower end.
    pub rises: bool,
}

/// A disc or a ring at one height.
#[derive(Clone, Debug)]
pub(crate) struct Flat {
    pub z: f64,
    /// The radii where it begins and ends.
    pub from: f64,
    pub to: f64,
    /// How far the drawing is from it.
    pub error: f64,
    /// Whether it is in the drawing, rather than a turn straightened.
    pub drawn: bool,
}

/// The runs of one chain.
#[derive(Clone, Debug)]
pub(crate) struct Runs {
    pub runs: Vec<Run>,
    /// Whether the last run is followed by the first.
    pub closed: bool,
    /// The height where the drawing begins, if it is a closed one that begins inside a wall.
    pub begins_inside: Option<f64>,
}

/// A piece that only rises, one that only falls, or several that count as one flat.
#[derive(Clone, Debug)]
pub(crate) enum Atom {
    Steep(Piece),
    Flat(Flat),
}

impl Atom {
    /// +1 for what rises, −1 for what falls, 0 for a flat.
    pub fn direction(&self) -> i8 {
        match self {
            Self::Flat(_) => 0,
            Self::Steep(piece) if piece.end().z > piece.start().z => 1,
            Self::Steep(_) => -1,
        }
    }

    pub fn start(&self) -> Point {
        match self {
            Self::Steep(piece) => piece.start(),
            Self::Flat(flat) => Point { r: flat.from, z: flat.z },
        }
    }

    pub fn end(&self) -> Point {
        match self {
            Self::Steep(piece) => piece.end(),
            Self::Flat(flat) => Point { r: flat.to, z: flat.z },
        }
    }
}

/// Of the largest coordinate: heights no farther apart are one.
const FLAT: f64 = 1e-12;

/// Cuts a chain at its height's turns; turns shallower than `tolerance` are straightened.
pub(crate) fn runs(chain: &Chain, tolerance: f64, warnings: &mut Vec<Warning>) -> Result<Runs, OutlineError> {
    let largest =
        chain.pieces.iter().flat_map(Piece::hull).fold(0.0, |l: f64, p| l.max(p.r.abs()).max(p.z.abs()));
    let mut atoms = Vec::new();
    for piece in &chain.pieces {
        cut(piece, FLAT * largest, &mut atoms);
    }
    if atoms.iter().all(|atom| atom.direction() == 0) {
        return Err(OutlineError::NoWall);
    }
    let mut begins_inside = None;
    if chain.closed {
        let direction = |i: usize| atoms[i].direction();
        if direction(0) != 0 && direction(0) == direction(atoms.len() - 1) {
            begins_inside = Some(atoms[0].start().z);
        }
        // To begin at the lowest place: there is a turn, and no other is less shallow than it.
        let lowest = (0..atoms.len()).min_by(|i, j| atoms[*i].start().z.total_cmp(&atoms[*j].start().z));
        let lowest = lowest.unwrap_or(0);
        atoms.rotate_left(lowest);
    }
    straighten::turns(&mut atoms, tolerance, chain.closed, warnings);
    let mut runs = join(atoms);
    level(&mut runs, chain.closed);
    Ok(Runs { runs, closed: chain.closed, begins_inside })
}

/// A piece as atoms: cut where its height turns or stands still.
fn cut(piece: &Piece, flat: f64, atoms: &mut Vec<Atom>) {
    let [low, high] = piece.hull();
    let as_flat = |piece: &Piece| {
        let (from, to) = (piece.start(), piece.end());
        Atom::Flat(Flat { z: from.z, from: from.r, to: to.r, error: (from.z - to.z).abs(), drawn: true })
    };
    if high.z - low.z <= flat {
        atoms.push(as_flat(piece));
        return;
    }
    let turns = piece.turns();
    let mut from = piece.start();
    let parts = piece.cut(&turns);
    let last = parts.len() - 1;
    for (i, mut part) in parts.into_iter().enumerate() {
        // The ends of parts are one point, and those of the piece are the neighbors'.
        let to = if i == last { piece.end() } else { part.end() };
        part.weld(from, to);
        let [low, high] = part.hull();
        if high.z - low.z > flat && from.z != to.z {
            atoms.push(Atom::Steep(part));
        } else if from != to {
            atoms.push(as_flat(&part));
        }
        from = to;
    }
}

/// Neighbors in one direction are one wall, neighboring flats one flat.
fn join(atoms: Vec<Atom>) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for atom in atoms {
        let direction = atom.direction();
        match (runs.last_mut(), atom) {
            (Some(Run::Wall(wall)), Atom::Steep(piece)) if direction == if wall.rises { 1 } else { -1 } => {
                wall.pieces.push(piece);
            }
            (Some(Run::Flat(flat)), Atom::Flat(next)) => {
                flat.to = next.to;
                flat.error = flat.error.max(next.error + (flat.z - next.z).abs());
                flat.drawn |= next.drawn;
            }
            (_, Atom::Steep(piece)) => {
                runs.push(Run::Wall(Wall { pieces: vec![piece], rises: direction > 0 }));
            }
            (_, Atom::Flat(flat)) => runs.push(Run::Flat(flat)),
        }
    }
    for run in &mut runs {
        if let Run::Wall(wall) = run
            && !wall.rises
        {
            wall.pieces.reverse();
            wall.pieces = core::mem::take(&mut wall.pieces).into_iter().map(Piece::reversed).collect();
        }
    }
    runs
}

/// Walls end at the very height of the flat beside them, which rounding may have put a little lower or higher.
fn level(runs: &mut [Run], closed: bool) {
    let n = runs.len();
    for i in 0..n {
        let Run::Flat(Flat { z, .. }) = runs[i] else { continue };
        let before = if i > 0 { Some(i - 1) } else { closed.then_some(n - 1) };
        let after = if i + 1 < n { Some(i + 1) } else { closed.then_some(0) };
        for (neighbor, is_before) in [(before, true), (after, false)] {
            let Some(Run::Wall(wall)) = neighbor.map(|neighbor| &mut runs[neighbor]) else { continue };
            // A wall before the flat ends at it.
            let upper = wall.rises == is_before;
            let at = if upper { wall.pieces.len() - 1 } else { 0 };
            let piece = &mut wall.pieces[at];
            let (start, end) = (piece.start(), piece.end());
            if upper {
                piece.weld(start, Point { z, ..end });
            } else {
                piece.weld(Point { z, ..start }, end);
            }
        }
    }
}
