//! Turns in height that are shallower than the tolerance become flats.

use crate::{
    error::Warning,
    piece::{Piece, Point},
    walls::{Atom, Flat},
};

/// A stretch of atoms in one direction, flats within it included.
struct Swing {
    first: usize,
    /// One past the last.
    end: usize,
    height: f64,
}

/// Replaces swings in height of less than the tolerance, the least first, each by a flat: inside the outline
/// at the middle of the swing, at an open end at the height of the turn. A swing whose flat would be farther
/// than the tolerance from what is drawn, such as a fin's, is kept.
pub(crate) fn turns(atoms: &mut Vec<Atom>, tolerance: f64, closed: bool, warnings: &mut Vec<Warning>) {
    let mut kept: Vec<f64> = Vec::new();
    loop {
        let swings = swings(atoms);
        // In the two outermost swings of a closed outline its lowest place is no end.
        let candidates =
            (0..swings.len()).filter(|i| swings.len() > 1 && !(closed && (*i == 0 || i + 1 == swings.len())));
        let shallow = candidates
            .filter(|i| swings[*i].height <= tolerance && !kept.contains(&swings[*i].height))
            .min_by(|i, j| swings[*i].height.total_cmp(&swings[*j].height));
        let Some(i) = shallow else { return };
        let replaced = match i {
            0 => at_start(atoms, &swings[0]),
            _ if i + 1 == swings.len() => at_end(atoms, &swings[i]),
            _ => inside(atoms, &swings[i - 1..=i + 1]),
        };
        match replaced {
            Some((flat, changed)) if flat.error <= tolerance => {
                warnings.push(Warning::Straightened {
                    height: flat.z,
                    radii: [flat.from.min(flat.to), flat.from.max(flat.to)],
                    error: flat.error,
                });
                *atoms = changed;
            }
            _ => kept.push(swings[i].height),
        }
    }
}

fn swings(atoms: &[Atom]) -> Vec<Swing> {
    let mut swings: Vec<(Swing, i8)> = Vec::new();
    for (i, atom) in atoms.iter().enumerate() {
        let direction = atom.direction();
        match swings.last_mut() {
            Some((swing, _)) if direction == 0 => swing.end = i + 1,
            Some((swing, of)) if *of == direction || *of == 0 => {
                swing.end = i + 1;
                *of = direction;
            }
            _ => swings.push((Swing { first: i, end: i + 1, height: 0.0 }, direction)),
        }
    }
    for (swing, _) in &mut swings {
        swing.height = (atoms[swing.end - 1].end().z - atoms[swing.first].start().z).abs();
    }
    swings.into_iter().map(|(swing, _)| swing).collect()
}

/// A flat at one height in place of some atoms, and how far they are from it.
fn flat(z: f64, replaced: &[Atom]) -> Flat {
    let (from, to) = (replaced[0].start().r, replaced[replaced.len() - 1].end().r);
    let mut error: f64 = 0.0;
    for atom in replaced {
        let hull = match atom {
            Atom::Steep(piece) => extremes(piece),
            Atom::Flat(flat) => vec![atom.start(), atom.end(), Point { r: flat.to, z: flat.z + flat.error }],
        };
        for p in hull {
            let beyond = (from.min(to) - p.r).max(p.r - from.max(to)).max(0.0);
            error = error.max(beyond.hypot((p.z - z).abs()));
        }
    }
    Flat { z, from, to, error, drawn: false }
}

/// A box around a piece that rises or falls: its radii are least and largest at its ends or at turns.
fn extremes(piece: &Piece) -> Vec<Point> {
    let turns = piece.radius_turns().into_iter().chain([0.0, 1.0]).map(|t| piece.at(t).r);
    let radii: Vec<f64> = turns.collect();
    let (low, high) = (piece.start().z, piece.end().z);
    radii.into_iter().flat_map(|r| [Point { r, z: low }, Point { r, z: high }]).collect()
}

/// The swing between two others: the flat lies at its middle, from where the outline first passes that height
/// to where it last does.
fn inside(atoms: &[Atom], swings: &[Swing]) -> Option<(Flat, Vec<Atom>)> {
    let [before, swing, after] = swings else { return None };
    let z = 0.5 * (atoms[swing.first].start().z + atoms[swing.end - 1].end().z);
    let (i, [kept_before, first]) = split(atoms, before, z)?;
    let (j, [last, kept_after]) = split(atoms, after, z)?;
    let mut replaced = vec![first];
    replaced.extend_from_slice(&atoms[i + 1..j]);
    replaced.push(last);
    let flat = flat(z, &replaced);
    let changed = atoms[..i].iter().cloned().chain([kept_before, Atom::Flat(flat.clone()), kept_after]);
    Some((flat, changed.chain(atoms[j + 1..].iter().cloned()).collect()))
}

/// The first swing of an open outline: the flat lies at the turn.
fn at_start(atoms: &[Atom], swing: &Swing) -> Option<(Flat, Vec<Atom>)> {
    let replaced = &atoms[swing.first..swing.end];
    let flat = flat(replaced[replaced.len() - 1].end().z, replaced);
    Some((
        flat.clone(),
        core::iter::once(Atom::Flat(flat)).chain(atoms[swing.end..].iter().cloned()).collect(),
    ))
}

/// The last one.
fn at_end(atoms: &[Atom], swing: &Swing) -> Option<(Flat, Vec<Atom>)> {
    let replaced = &atoms[swing.first..];
    let flat = flat(replaced[0].start().z, replaced);
    Some((flat.clone(), atoms[..swing.first].iter().cloned().chain([Atom::Flat(flat)]).collect()))
}

/// The atom of a swing in which it passes a height, and that atom's two parts. `None` where it passes it on a
/// flat or on an atom's end.
fn split(atoms: &[Atom], swing: &Swing, z: f64) -> Option<(usize, [Atom; 2])> {
    (swing.first..swing.end).find_map(|i| match &atoms[i] {
        Atom::Steep(piece) if (piece.start().z - z) * (piece.end().z - z) < 0.0 => {
            let t = piece.at_height(z);
            let [mut a, mut b] = [piece.part(0.0, t), piece.part(t, 1.0)];
            let at = Point { z, ..a.end() };
            a.weld(piece.start(), at);
            b.weld(at, piece.end());
            (a.start().z != z && b.end().z != z).then_some((i, [Atom::Steep(a), Atom::Steep(b)]))
        }
        _ => None,
    })
}
