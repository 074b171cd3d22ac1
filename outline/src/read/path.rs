//! Path data: every command, arcs kept as arcs, into pieces in the whole drawing's user units.

use super::{place::Reason, shape::Placed};
use crate::{Piece, Point, point};
use svgtypes::{PathParser, PathSegment};

/// What is wrong in path data, and at which character.
pub(crate) struct PathError {
    pub reason: Reason,
    pub at: usize,
}

/// A path's pieces and whether it is closed.
pub(crate) fn pieces(data: &str, placed: Placed) -> Result<(Vec<Piece>, bool), PathError> {
    let mut pen = Pen {
        at: [0.0; 2],
        start: [0.0; 2],
        control: None,
        placed,
        pieces: Vec::new(),
        closed: false,
        torn: false,
    };
    for segment in PathParser::from(data) {
        match segment {
            Ok(segment) => pen.draw(segment).map_err(|reason| PathError { reason, at: second_move(data) })?,
            Err(error) => {
                let at = position(&error).unwrap_or(data.len());
                return Err(PathError { reason: Reason::Syntax(error.to_string()), at });
            }
        }
    }
    Ok((pen.pieces, pen.closed))
}

/// Where the second part of the path begins: its second command to move.
fn second_move(data: &str) -> usize {
    let mut moves = data.char_indices().filter(|(_, c)| matches!(c, 'M' | 'm'));
    moves.nth(1).map_or(0, |(at, _)| at)
}

/// Where a parser's error is, in bytes, if it tells.
pub(crate) fn position(error: &svgtypes::Error) -> Option<usize> {
    use svgtypes::Error;
    match error {
        Error::UnexpectedData(at)
        | Error::InvalidChar(_, at)
        | Error::InvalidString(_, at)
        | Error::InvalidNumber(at) => Some(at.saturating_sub(1)),
        Error::UnexpectedEndOfStream | Error::InvalidValue | Error::InvalidIdent => None,
    }
}

/// The control point before the last end, and of which kind of curve.
#[derive(Clone, Copy)]
enum Control {
    Cubic([f64; 2]),
    Quadratic([f64; 2]),
}

struct Pen {
    at: [f64; 2],
    start: [f64; 2],
    control: Option<Control>,
    placed: Placed,
    pieces: Vec<Piece>,
    closed: bool,
    /// Whether it was lifted and put down elsewhere.
    torn: bool,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) -> Result<(), Reason> {
        let [x0, y0] = self.at;
        let origin = |abs: bool| if abs { [0.0; 2] } else { [x0, y0] };
        let from = |abs: bool, x: f64, y: f64| [origin(abs)[0] + x, origin(abs)[1] + y];
        let draws = !matches!(segment, PathSegment::ClosePath { .. } | PathSegment::MoveTo { .. });
        if draws && (self.closed || self.torn) {
            return Err(Reason::SecondPart);
        }
        let mut control = None;
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                let to = from(abs, x, y);
                if self.pieces.is_empty() {
                    (self.at, self.start) = (to, to);
                } else {
                    self.torn |= to != self.at;
                }
            }
            PathSegment::LineTo { abs, x, y } => self.line(from(abs, x, y)),
            PathSegment::HorizontalLineTo { abs, x } => self.line([origin(abs)[0] + x, y0]),
            PathSegment::VerticalLineTo { abs, y } => self.line([x0, origin(abs)[1] + y]),
            PathSegment::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                let second = from(abs, x2, y2);
                self.curve(&[from(abs, x1, y1), second, from(abs, x, y)]);
                control = Some(Control::Cubic(second));
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                let first = match self.control {
                    Some(Control::Cubic([x, y])) => [2.0 * x0 - x, 2.0 * y0 - y],
                    _ => self.at,
                };
                let second = from(abs, x2, y2);
                self.curve(&[first, second, from(abs, x, y)]);
                control = Some(Control::Cubic(second));
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                let first = from(abs, x1, y1);
                self.curve(&[first, from(abs, x, y)]);
                control = Some(Control::Quadratic(first));
            }
            PathSegment::SmoothQuadratic { abs, x, y } => {
                let first = match self.control {
                    Some(Control::Quadratic([x, y])) => [2.0 * x0 - x, 2.0 * y0 - y],
                    _ => self.at,
                };
                self.curve(&[first, from(abs, x, y)]);
                control = Some(Control::Quadratic(first));
            }
            PathSegment::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
                self.arc([rx, ry], x_axis_rotation, large_arc, sweep, from(abs, x, y));
            }
            PathSegment::ClosePath { .. } => {
                if !self.closed && self.at != self.start {
                    self.line(self.start);
                }
                self.closed = !self.pieces.is_empty();
                self.at = self.start;
            }
        }
        self.control = control;
        Ok(())
    }

    fn line(&mut self, to: [f64; 2]) {
        self.curve(&[to]);
    }

    fn curve(&mut self, controls: &[[f64; 2]]) {
        let points = core::iter::once(&self.at).chain(controls);
        let points: Vec<Point> = points.map(|p| self.placed.point(*p)).collect();
        self.at = controls[controls.len() - 1];
        self.pieces.push(Piece::bezier(&points));
    }

    fn arc(&mut self, radii: [f64; 2], rotation: f64, large_arc: bool, sweep: bool, to: [f64; 2]) {
        // In units of the radius, so that no size of a drawing is taken for none.
        let size = radii[0].abs().max(radii[1].abs());
        if to == self.at || !(radii[0].abs().min(radii[1].abs()) > 1e-5 * size) || !size.is_finite() {
            if to != self.at {
                self.line(to);
            }
            return;
        }
        let scaled = |[x, y]: [f64; 2]| kurbo::Point::new((x - self.at[0]) / size, (y - self.at[1]) / size);
        let arc = kurbo::Arc::from_svg_arc(&kurbo::SvgArc {
            from: scaled(self.at),
            to: scaled(to),
            radii: kurbo::Vec2::new(radii[0] / size, radii[1] / size),
            x_rotation: rotation.to_radians(),
            large_arc,
            sweep,
        });
        let Some(arc) = arc else { return self.line(to) };
        let center = [self.at[0] + size * arc.center.x, self.at[1] + size * arc.center.y];
        let (sin, cos) = arc.x_rotation.sin_cos();
        let a = self.placed.vector([size * arc.radii.x * cos, size * arc.radii.x * sin]);
        let b = self.placed.vector([-size * arc.radii.y * sin, size * arc.radii.y * cos]);
        let mut pieces = Piece::arc(self.placed.point(center), a, b, arc.start_angle, arc.sweep_angle);
        // The ends are those that are drawn.
        let (from, end) = (self.placed.point(self.at), self.placed.point(to));
        let last = pieces.len() - 1;
        let first_end = pieces[0].end();
        pieces[0].weld(from, if last == 0 { end } else { first_end });
        if last > 0 {
            let start = pieces[last].start();
            pieces[last].weld(start, end);
        }
        self.pieces.append(&mut pieces);
        self.at = to;
    }
}

impl Placed {
    fn point(&self, [x, y]: [f64; 2]) -> Point {
        let [x, y] = self.apply([x, y]);
        point(x, -y)
    }

    fn vector(&self, [x, y]: [f64; 2]) -> Point {
        let [x0, y0] = self.apply([0.0; 2]);
        let [x, y] = self.apply([x, y]);
        point(x - x0, y0 - y)
    }
}
