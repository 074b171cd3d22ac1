//! The drawn line: pieces end to end, open or closed, checked at the door.

use crate::{
    error::OutlineError,
    piece::{Piece, Point, point},
};

/// A chain of [`Piece`]s, each beginning where the one before it ends. Radius and height are those of the
/// drawing; r may still be negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    pieces: Vec<Piece>,
    closed: bool,
}

/// Of the outline's size: ends no farther apart are one point.
const JOINED: f64 = 1e-9;

impl Outline {
    /// An outline that ends elsewhere than it begins.
    ///
    /// # Errors
    ///
    /// [`OutlineError`] if there is no piece, a number is not finite, or a piece does not begin where the one
    /// before it ends.
    pub fn open(pieces: Vec<Piece>) -> Result<Self, OutlineError> {
        Self::new(pieces, false)
    }

    /// An outline that ends where it begins. A straight line is added if it does not.
    ///
    /// # Errors
    ///
    /// As [`Outline::open`].
    pub fn closed(mut pieces: Vec<Piece>) -> Result<Self, OutlineError> {
        if let (Some(first), Some(last)) = (pieces.first(), pieces.last())
            && first.start() != last.end()
        {
            pieces.push(Piece::line(last.end(), first.start()));
        }
        Self::new(pieces, true)
    }

    /// Straight lines between points.
    ///
    /// # Errors
    ///
    /// As [`Outline::open`].
    pub fn polygon(points: &[Point], closed: bool) -> Result<Self, OutlineError> {
        let lines = points.windows(2).map(|p| Piece::line(p[0], p[1])).collect();
        if closed { Self::closed(lines) } else { Self::open(lines) }
    }

    /// A uniform Catmull-Rom curve: through all points but the first and the last, which give tangents only.
    /// It is closed if it ends where it begins, with the same tangent points beyond.
    ///
    /// # Errors
    ///
    /// As [`Outline::open`]; no piece is what fewer than four points give.
    pub fn catmull_rom(points: &[Point]) -> Result<Self, OutlineError> {
        let third = |from: Point, to: Point, at: Point, sign: f64| {
            point(at.r + sign * (to.r - from.r) / 6.0, at.z + sign * (to.z - from.z) / 6.0)
        };
        let piece = |p: &[Point]| {
            Piece::bezier(&[p[1], third(p[0], p[2], p[1], 1.0), third(p[1], p[3], p[2], -1.0), p[2]])
        };
        let pieces: Vec<_> = points.windows(4).map(piece).collect();
        let closed = pieces.len() > 1 && points[1] == points[points.len() - 2];
        Self::new(pieces, closed)
    }

    /// A smooth curve through all points; one that stands twice is a corner. The tangent at each is that of the
    /// parabola through it and its neighbors, with the distances between points as parameter, and at the ends and
    /// at corners that of the last parabola. Uneven distances do not disturb it, as they do a uniform Catmull-Rom
    /// curve.
    ///
    /// # Errors
    ///
    /// As [`Outline::open`]; no piece is what a single point gives.
    pub fn smooth(points: &[Point]) -> Result<Self, OutlineError> {
        let runs = points.chunk_by(|p, q| p != q);
        // A point that stands more often makes runs of a single one.
        let runs = runs.filter(|run| run.len() > 1 || points.len() == 1);
        Self::open(runs.flat_map(Self::smooth_run).collect())
    }

    fn smooth_run(points: &[Point]) -> Vec<Piece> {
        let n = points.len();
        if n < 3 {
            return points.windows(2).map(|p| Piece::line(p[0], p[1])).collect();
        }
        let length = |i: usize| points[i].distance(points[i + 1]);
        let slope = |i: usize| {
            let (p, q, h) = (points[i], points[i + 1], length(i));
            point((q.r - p.r) / h, (q.z - p.z) / h)
        };
        let blend = |a: Point, wa: f64, b: Point, wb: f64| point(wa * a.r + wb * b.r, wa * a.z + wb * b.z);
        let tangent = |i: usize| match i {
            0 => {
                let k = length(0) / (length(0) + length(1));
                blend(slope(0), 1.0 + k, slope(1), -k)
            }
            i if i == n - 1 => {
                let k = length(n - 2) / (length(n - 2) + length(n - 3));
                blend(slope(n - 2), 1.0 + k, slope(n - 3), -k)
            }
            i => {
                let whole = length(i - 1) + length(i);
                blend(slope(i - 1), length(i) / whole, slope(i), length(i - 1) / whole)
            }
        };
        let control = |p: Point, t: Point, h: f64| point(p.r + h * t.r, p.z + h * t.z);
        let piece = |i: usize| {
            let (p, q, h) = (points[i], points[i + 1], length(i) / 3.0);
            Piece::bezier(&[p, control(p, tangent(i), h), control(q, tangent(i + 1), -h), q])
        };
        (0..n - 1).map(piece).collect()
    }

    /// A profile as it is: cubics in squared radius, by knots and ordinates, the joins' shared.
    ///
    /// # Errors
    ///
    /// As [`Outline::open`]; no piece is what too few ordinates for the knots give.
    pub fn squares(knots: &[f64], ordinates: &[f64]) -> Result<Self, OutlineError> {
        let ordinates = ordinates.windows(4).step_by(3);
        let pieces = knots.windows(2).zip(ordinates);
        Self::open(pieces.map(|(z, b)| Piece::squares([z[0], z[1]], [b[0], b[1], b[2], b[3]])).collect())
    }

    fn new(mut pieces: Vec<Piece>, closed: bool) -> Result<Self, OutlineError> {
        if let Some(piece) = pieces.iter().position(|piece| !piece.is_finite()) {
            return Err(OutlineError::NotFinite { piece });
        }
        let size = size(&pieces);
        pieces.retain(|piece| {
            let [low, high] = piece.hull();
            low.distance(high) > 1e-12 * size
        });
        if pieces.is_empty() {
            return Err(OutlineError::Empty);
        }
        let n = pieces.len();
        let starts: Vec<Point> = pieces.iter().map(Piece::start).collect();
        for i in 0..n {
            let next = if i + 1 < n {
                starts[i + 1]
            } else if closed {
                starts[0]
            } else {
                pieces[i].end()
            };
            if !(pieces[i].end().distance(next) <= JOINED * size) {
                return Err(OutlineError::NotJoined { end: pieces[i].end(), start: next });
            }
            pieces[i].weld(starts[i], next);
        }
        Ok(Self { pieces, closed })
    }

    /// The pieces in the order in which they are drawn.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Whether it ends where it begins.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The larger of its height and its width, from the control points: what rounding is measured by.
    pub fn size(&self) -> f64 {
        size(&self.pieces)
    }

    /// The least radius with the lowest height, and the largest with the highest.
    pub fn bounds(&self) -> [Point; 2] {
        let places = self.pieces.iter().flat_map(|piece| {
            let turns = piece.turns().into_iter().chain(piece.radius_turns());
            turns.chain([0.0, 1.0]).map(|t| piece.at(t)).collect::<Vec<_>>()
        });
        around(places.map(|p| [p, p]))
    }

    /// The outline with all its coordinates multiplied by a factor.
    pub fn scaled(self, by: f64) -> Self {
        self.stretched(by, by)
    }

    /// The outline with its radii multiplied by one factor and its heights by another.
    pub fn stretched(self, across: f64, along: f64) -> Self {
        let pieces = self.pieces.into_iter().map(|piece| piece.stretched(across, along)).collect();
        Self { pieces, closed: self.closed }
    }

    /// The outline moved in radius and in height.
    pub fn moved(self, by: Point) -> Self {
        Self { pieces: self.pieces.into_iter().map(|piece| piece.moved(by)).collect(), closed: self.closed }
    }
}

fn size(pieces: &[Piece]) -> f64 {
    let [low, high] = around(pieces.iter().map(Piece::hull));
    (high.r - low.r).max(high.z - low.z)
}

/// The box around boxes.
fn around(boxes: impl Iterator<Item = [Point; 2]>) -> [Point; 2] {
    let none = [point(f64::INFINITY, f64::INFINITY), point(f64::NEG_INFINITY, f64::NEG_INFINITY)];
    boxes.fold(none, |[low, high], [a, b]| {
        [point(low.r.min(a.r), low.z.min(a.z)), point(high.r.max(b.r), high.z.max(b.z))]
    })
}
