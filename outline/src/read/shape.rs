//! Paths and basic shapes of an SVG document, and where its transforms put them.

use super::{
    part::{Part, joined},
    path,
    place::{ReadError, Reason, Source},
    unit,
};
use crate::{Piece, Point, point};
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::{Length, PointsParser, Transform};

/// An element's own coordinates in the user units of the whole drawing.
#[derive(Clone, Copy)]
pub(crate) struct Placed(Transform);

impl Placed {
    /// By the transforms of an element and of all it lies in.
    pub fn new(of: &Source, element: Node) -> Result<Self, ReadError> {
        let mut whole = Transform::default();
        // The outermost is applied last.
        for node in element.ancestors() {
            let Some(attribute) = node.attribute_node("transform") else { continue };
            let own = Transform::from_str(attribute.value()).map_err(|error| {
                let at = attribute.range_value().start + path::position(&error).unwrap_or(0);
                of.error(Reason::Syntax(error.to_string()), at)
            })?;
            whole = after(whole, own);
        }
        Ok(Self(whole))
    }

    pub fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Transform { a, b, c, d, e, f } = self.0;
        [a * x + c * y + e, b * x + d * y + f]
    }
}

/// First the one, then the other.
fn after(first: Transform, then: Transform) -> Transform {
    let linear = |x: f64, y: f64| [then.a * x + then.c * y, then.b * x + then.d * y];
    let [[a, b], [c, d], [e, f]] =
        [linear(first.a, first.b), linear(first.c, first.d), linear(first.e, first.f)];
    Transform::new(a, b, c, d, e + then.e, f + then.f)
}

/// The elements that are drawn as lines.
const SHAPES: [&str; 7] = ["path", "rect", "circle", "ellipse", "line", "polyline", "polygon"];

/// What is in such an element is not drawn where it stands.
const APART: [&str; 6] = ["defs", "clipPath", "mask", "symbol", "pattern", "marker"];

/// Every path and basic shape that is drawn, in the document's order.
pub(crate) fn all<'a>(root: Node<'a, 'a>) -> Vec<Node<'a, 'a>> {
    let is_shape = |node: &Node| SHAPES.contains(&node.tag_name().name());
    let is_apart = |node: &Node| node.ancestors().any(|node| APART.contains(&node.tag_name().name()));
    root.descendants().filter(|node| node.is_element() && is_shape(node) && !is_apart(node)).collect()
}

/// The unbroken lines of a shape: one of most. A path's that meet end to end are one; a shape without a size has
/// none.
pub(crate) fn parts(of: &Source, shape: Node) -> Result<Vec<Part>, ReadError> {
    let at = shape.range().start;
    let one = |pieces: Vec<Piece>, closed: bool| joined(vec![Part::at(pieces, closed, at)]);
    let placed = Placed::new(of, shape)?;
    let length = |name: &str| length(of, shape, name);
    let or_zero = |name: &str| Ok(length(name)?.unwrap_or(0.0));
    let polygon = |points: &[[f64; 2]], closed: bool| {
        let points: Vec<Point> = points.iter().map(|p| to_point(&placed, *p)).collect();
        let back = (closed && points.len() > 1).then(|| Piece::line(points[points.len() - 1], points[0]));
        points.windows(2).map(|p| Piece::line(p[0], p[1])).chain(back).collect::<Vec<_>>()
    };
    Ok(match shape.tag_name().name() {
        "path" => {
            let Some(data) = shape.attribute_node("d") else { return Ok(Vec::new()) };
            let start = data.range_value().start;
            let parts = path::parts(data.value(), placed, start);
            joined(parts.map_err(|error| of.error(error.reason, start + error.at))?)
        }
        "line" => {
            let [from, to] = [[or_zero("x1")?, or_zero("y1")?], [or_zero("x2")?, or_zero("y2")?]];
            one(polygon(&[from, to], false), false)
        }
        name @ ("polyline" | "polygon") => {
            let data = shape.attribute("points").unwrap_or("");
            let points: Vec<[f64; 2]> = PointsParser::from(data).map(|(x, y)| [x, y]).collect();
            let numbers = data.split([',', ' ', '\t', '\n', '\r']).filter(|text| !text.is_empty()).count();
            if name == "polyline" && numbers < 2 || 2 * points.len() != numbers && !data.contains('-') {
                let at =
                    shape.attribute_node("points").map_or(shape.range().start, |a| a.range_value().start);
                return Err(of.error(Reason::Syntax("not a list of points".into()), at));
            }
            one(polygon(&points, name == "polygon"), name == "polygon")
        }
        "rect" => {
            let [x, y, w, h] = [or_zero("x")?, or_zero("y")?, or_zero("width")?, or_zero("height")?];
            let (rx, ry) = (length("rx")?, length("ry")?);
            let rx_or = rx.or(ry).unwrap_or(0.0).min(0.5 * w);
            let ry_or = ry.or(rx).unwrap_or(0.0).min(0.5 * h);
            if rx_or > 0.0 && ry_or > 0.0 {
                let data = format!(
                    "M{} {y}h{}a{rx_or} {ry_or} 0 0 1 {rx_or} {ry_or}v{}a{rx_or} {ry_or} 0 0 1 {} {ry_or}h{}a{rx_or} {ry_or} 0 0 1 {} {}v{}a{rx_or} {ry_or} 0 0 1 {rx_or} {}z",
                    x + rx_or,
                    w - 2.0 * rx_or,
                    h - 2.0 * ry_or,
                    -rx_or,
                    2.0 * rx_or - w,
                    -rx_or,
                    -ry_or,
                    2.0 * ry_or - h,
                    -ry_or,
                );
                let parts = path::parts(&data, placed, 0).map_err(|error| of.error(error.reason, at))?;
                parts.into_iter().flat_map(|part| one(part.pieces, part.closed)).collect()
            } else {
                one(polygon(&[[x, y], [x + w, y], [x + w, y + h], [x, y + h]], true), true)
            }
        }
        name @ ("circle" | "ellipse") => {
            let [cx, cy] = [or_zero("cx")?, or_zero("cy")?];
            let [rx, ry] =
                if name == "circle" { [or_zero("r")?; 2] } else { [or_zero("rx")?, or_zero("ry")?] };
            let center = to_point(&placed, [cx, cy]);
            let radius = |end: [f64; 2]| {
                let end = to_point(&placed, end);
                point(end.r - center.r, end.z - center.z)
            };
            if !(rx > 0.0 && ry > 0.0) {
                return Ok(Vec::new());
            }
            let (a, b) = (radius([cx + rx, cy]), radius([cx, cy + ry]));
            one(Piece::arc(center, a, b, 0.0, core::f64::consts::TAU), true)
        }
        _ => Vec::new(),
    })
}

fn to_point(placed: &Placed, p: [f64; 2]) -> Point {
    let [x, y] = placed.apply(p);
    point(x, -y)
}

/// A length attribute in user units.
pub(crate) fn length(of: &Source, element: Node, name: &str) -> Result<Option<f64>, ReadError> {
    let Some(attribute) = element.attribute_node(name) else { return Ok(None) };
    let at = attribute.range_value().start;
    let length = Length::from_str(attribute.value()).map_err(|error| {
        of.error(Reason::Syntax(error.to_string()), at + path::position(&error).unwrap_or(0))
    })?;
    let per_unit = 96.0 / 25.4;
    match length.unit {
        svgtypes::LengthUnit::None => Ok(Some(length.number)),
        _ => unit::millimeters(length)
            .map(|millimeters| Some(millimeters * per_unit))
            .ok_or_else(|| of.error(Reason::Unsupported(format!("the length {}", attribute.value())), at)),
    }
}
