//! One unbroken line of a shape, and where in the file each piece of it is.

use crate::{OutlineError, Piece, Point, point};

/// Pieces end to end.
#[derive(Clone, Debug, Default)]
pub(crate) struct Part {
    pub pieces: Vec<Piece>,
    /// The byte of the file at which each of them is drawn.
    pub at: Vec<usize>,
    /// Whether it ends where it begins.
    pub closed: bool,
}

impl Part {
    /// All pieces drawn at one place.
    pub fn at(pieces: Vec<Piece>, closed: bool, at: usize) -> Self {
        let at = vec![at; pieces.len()];
        Self { pieces, at, closed }
    }

    fn ends(&self) -> Option<[Point; 2]> {
        let open = self.pieces.first().zip(self.pieces.last()).filter(|_| !self.closed);
        open.map(|(first, last)| [first.start(), last.end()])
    }

    fn reversed(self) -> Self {
        let pieces = self.pieces.into_iter().rev().map(Piece::reversed).collect();
        Self { pieces, at: self.at.into_iter().rev().collect(), closed: self.closed }
    }

    /// Goes on with another part. It is closed if that one ends where it begins.
    fn extend(&mut self, next: Self) {
        self.pieces.extend(next.pieces);
        self.at.extend(next.at);
        self.closed = self.ends().is_some_and(|[start, end]| start == end);
    }
}

/// Open parts that meet end to end made one, in whichever direction they are drawn.
pub(crate) fn joined(parts: Vec<Part>) -> Vec<Part> {
    let mut joined: Vec<Part> = Vec::new();
    for mut part in parts.into_iter().filter(|part| !part.pieces.is_empty()) {
        // Each end of the part may meet one of those before it.
        while let Some([start, end]) = part.ends() {
            let meets =
                |other: &Part| other.ends().is_some_and(|ends| ends.contains(&start) || ends.contains(&end));
            let Some(i) = joined.iter().position(meets) else { break };
            let mut before = joined.remove(i);
            if before.ends().is_some_and(|[_, last]| last != start && last != end) {
                before = before.reversed();
            }
            if before.ends().is_some_and(|[_, last]| last != start) {
                part = part.reversed();
            }
            before.extend(part);
            part = before;
        }
        joined.push(part);
    }
    joined
}

/// Boxes around what is drawn of an outline, in its own numbers, and the line and the column of each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Marks(Vec<([Point; 2], (u32, u32))>);

impl Marks {
    /// Those of pieces.
    pub fn of_pieces(pieces: &[Piece], places: impl Iterator<Item = (u32, u32)>) -> Self {
        Self(pieces.iter().map(Piece::hull).zip(places).collect())
    }

    /// Those of what is drawn from one point to the next, by the places of the points.
    pub fn of_points(points: &[Point], places: impl Iterator<Item = (u32, u32)>) -> Self {
        let around = |p: &[Point]| {
            [point(p[0].r.min(p[1].r), p[0].z.min(p[1].z)), point(p[0].r.max(p[1].r), p[0].z.max(p[1].z))]
        };
        Self(points.windows(2).map(around).zip(places).collect())
    }

    /// Moved and then stretched as the outline is.
    pub fn placed(self, by: Point, [across, along]: [f64; 2]) -> Self {
        let place = |p: Point| point(across * (p.r + by.r), along * (p.z + by.z));
        Self(self.0.into_iter().map(|(around, at)| (around.map(place), at)).collect())
    }

    /// Where what an error names is drawn, if it names a place.
    pub fn culprit(&self, error: &OutlineError) -> Option<(u32, u32)> {
        let at_height = |z: f64| self.nearest(|[low, high]| (low.z - z).max(z - high.z));
        match error {
            OutlineError::NotFinite { piece } => self.0.get(*piece).map(|(_, place)| *place),
            OutlineError::NotJoined { start, .. } => self.at(*start),
            OutlineError::CrossesAxis { heights } => self.at(point(0.0, *heights.first()?)),
            OutlineError::CrossesItself { height, radius } => self.at(point(*radius, *height)),
            OutlineError::OutOfReach { height, .. } | OutlineError::WallsMeet { height } => {
                at_height(*height)
            }
            _ => None,
        }
    }

    /// Where the box nearest to a point is drawn. Of an outline that was mirrored the boxes are not.
    fn at(&self, p: Point) -> Option<(u32, u32)> {
        self.nearest(|[low, high]| {
            let r = (low.r - p.r).max(p.r - high.r).min((low.r + p.r).max(-p.r - high.r));
            r.max(0.0).hypot((low.z - p.z).max(p.z - high.z).max(0.0))
        })
    }

    fn nearest(&self, distance: impl Fn(&[Point; 2]) -> f64) -> Option<(u32, u32)> {
        let distances = self.0.iter().map(|(around, place)| (distance(around).max(0.0), *place));
        distances.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place)| place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_in_any_order_and_direction() {
        let corners = [point(0.0, 0.0), point(1.0, 0.0), point(2.0, 1.0), point(1.0, 2.0), point(0.0, 2.0)];
        let line =
            |from: usize, to: usize| Part::at(vec![Piece::line(corners[from], corners[to])], false, from);
        for order in [[0, 1, 2, 3], [3, 0, 2, 1], [1, 3, 0, 2], [2, 0, 3, 1]] {
            for turned in 0..16 {
                let part = |i: &usize| if turned >> i & 1 == 0 { line(*i, i + 1) } else { line(i + 1, *i) };
                let all = joined(order.iter().map(part).collect());
                let [whole] = all.as_slice() else { panic!("{order:?}, {turned}: {all:?}") };
                let joins = whole.pieces.windows(2).all(|pair| pair[0].end() == pair[1].start());
                assert!(joins && whole.pieces.len() == 4 && !whole.closed, "{order:?}, {turned}: {whole:?}");
            }
        }
        let back = Part::at(vec![Piece::line(corners[2], corners[0])], false, 9);
        let loops = joined(vec![line(0, 1), back, line(1, 2), line(3, 4)]);
        assert_eq!(loops.iter().map(|part| part.closed).collect::<Vec<_>>(), [true, false]);
    }
}
