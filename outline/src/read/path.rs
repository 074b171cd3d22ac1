//! Path data: every command, arcs kept as arcs, into pieces in the whole drawing's user units.

use super::{part::Part, place::Reason, shape::Placed};
use crate::{Piece, Point, point};
use svgtypes::{PathParser, PathSegment};

/// What is wrong in path data, and at which character.
pub(crate) struct PathError {
    pub reason: Reason,
    pub at: usize,
}

/// The parts of a path, each from where the pen is put down to where it is lifted. `start` is the byte of the file at
/// which the data begins.
pub(crate) fn parts(data: &str, placed: Placed, start: usize) -> Result<Vec<Part>, PathError> {
    let mut pen = Pen {
        at: [0.0; 2],
        start: [0.0; 2],
        control: None,
        placed,
        parts: Vec::new(),
        byte: 0,
        lifted: true,
    };
    for (at, command) in commands(data) {
        pen.byte = start + at;
        // The parser wants data that begin with a move.
        let is_move = command.starts_with(['M', 'm']);
        let (text, before) = if is_move || at == 0 {
            (command.into(), 0)
        } else {
            (format!("{BEFORE}{command}"), BEFORE.len())
        };
        for segment in PathParser::from(text.as_str()).skip(usize::from(before > 0)) {
            let error = |error: svgtypes::Error| {
                let at = at + position(&error).unwrap_or(text.len()).saturating_sub(before);
                PathError { reason: Reason::Syntax(error.to_string()), at }
            };
            pen.draw(segment.map_err(error)?);
        }
    }
    Ok(pen.parts)
}

const BEFORE: &str = "M0 0 ";

/// Path data in pieces that begin with a command's letter, each with where it begins.
fn commands(data: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_command = |c: char| "MmLlHhVvCcSsQqTtAaZz".contains(c);
    let letters: Vec<usize> = data.match_indices(is_command).map(|(at, _)| at).collect();
    let first = letters.first().copied().unwrap_or(data.len());
    // What stands before the first letter is for the parser to refuse.
    let before = (!data[..first].trim().is_empty()).then_some(0);
    let starts: Vec<usize> = before.into_iter().chain(letters).collect();
    let ends: Vec<usize> = starts.iter().skip(1).copied().chain([data.len()]).collect();
    starts.into_iter().zip(ends).map(|(start, end)| (start, &data[start..end]))
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
    parts: Vec<Part>,
    /// The byte of the file at which the command stands.
    byte: usize,
    /// Whether what is drawn next begins a part.
    lifted: bool,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let [x0, y0] = self.at;
        let origin = |abs: bool| if abs { [0.0; 2] } else { [x0, y0] };
        let from = |abs: bool, x: f64, y: f64| [origin(abs)[0] + x, origin(abs)[1] + y];
        let mut control = None;
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                self.at = from(abs, x, y);
                (self.start, self.lifted) = (self.at, true);
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
                if !self.lifted {
                    if self.at != self.start {
                        self.line(self.start);
                    }
                    if let Some(part) = self.parts.last_mut() {
                        part.closed = true;
                    }
                }
                (self.at, self.lifted) = (self.start, true);
            }
        }
        self.control = control;
    }

    fn push(&mut self, pieces: Vec<Piece>) {
        if core::mem::take(&mut self.lifted) {
            self.parts.push(Part::default());
        }
        if let Some(part) = self.parts.last_mut() {
            part.at.resize(part.at.len() + pieces.len(), self.byte);
            part.pieces.extend(pieces);
        }
    }

    fn line(&mut self, to: [f64; 2]) {
        self.curve(&[to]);
    }

    fn curve(&mut self, controls: &[[f64; 2]]) {
        let points = core::iter::once(&self.at).chain(controls);
        let points: Vec<Point> = points.map(|p| self.placed.point(*p)).collect();
        self.at = controls[controls.len() - 1];
        self.push(vec![Piece::bezier(&points)]);
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
        self.push(pieces);
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
