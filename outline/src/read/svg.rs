//! SVG documents: which element is the outline, where the axis is, and how large it is.

use super::{
    Axis, Drawing, Options, Unit,
    part::{Marks, Part},
    place::{ReadError, Reason, Source},
    shape, unit,
};
use crate::{Outline, Warning, point};
use roxmltree::{Document, Node, ParsingOptions};
use std::str::FromStr;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, ViewBox};

/// The id of an element that is the axis.
const AXIS: &str = "axis";

pub(crate) fn one(of: &Source, options: &Options) -> Result<Drawing, ReadError> {
    let document = parse(of)?;
    let shapes = shapes(of, &document);
    let shape = match &options.name {
        Some(wanted) => shapes.iter().find(|shape| shape.name(of) == *wanted).ok_or_else(|| {
            let names = shapes.iter().map(|shape| shape.name(of)).collect();
            of.error(Reason::NotFound { name: wanted.clone(), names }, 0)
        })?,
        None => match shapes.as_slice() {
            [] => return Err(of.error(Reason::NoShape, document.root_element().range().start)),
            [shape] => shape,
            [_, second, ..] => {
                let names = shapes.iter().map(|shape| shape.name(of)).collect();
                return Err(of.error(Reason::Ambiguous(names), second.start()));
            }
        },
    };
    let mut drawing = drawing(of, &document, shape, options)?;
    let others = shapes.iter().map(|other| other.name(of)).filter(|other| *other != shape.name(of));
    drawing.warnings.extend(others.map(|what| Warning::LeftOut { what }));
    Ok(drawing)
}

pub(crate) fn all(of: &Source, options: &Options) -> Result<Vec<Result<Drawing, ReadError>>, ReadError> {
    let document = parse(of)?;
    let shapes = shapes(of, &document);
    if shapes.is_empty() {
        return Err(of.error(Reason::NoShape, document.root_element().range().start));
    }
    Ok(shapes.iter().map(|shape| drawing(of, &document, shape, options)).collect())
}

/// One unbroken line of an element, or an element that is none.
struct Shape<'a> {
    element: Node<'a, 'a>,
    line: Result<Part, ReadError>,
    /// Of several lines of the element, which one this is, from 1.
    number: Option<usize>,
}

impl Shape<'_> {
    /// Its element's id, or what the element is and in which line; with its number, if the element has several lines.
    fn name(&self, of: &Source) -> String {
        let element = self.element.attribute("id").map_or_else(
            || {
                format!(
                    "{} in line {}",
                    self.element.tag_name().name(),
                    of.place(self.element.range().start).0
                )
            },
            str::to_string,
        );
        self.number.map_or(element.clone(), |number| format!("{element}#{number}"))
    }

    /// The byte of the file at which it begins.
    fn start(&self) -> usize {
        let of_line = self.line.as_ref().ok().filter(|_| self.number.is_some_and(|number| number > 1));
        of_line.and_then(|line| line.at.first().copied()).unwrap_or(self.element.range().start)
    }
}

fn parse<'a>(of: &Source<'a>) -> Result<Document<'a>, ReadError> {
    // Inkscape's files may name a document type. The limit of nodes bounds what its entities expand to.
    let options = ParsingOptions { allow_dtd: true, nodes_limit: 1_000_000, ..ParsingOptions::default() };
    Document::parse_with_options(of.text, options).map_err(|error| {
        let at = error.pos();
        of.error_in(Reason::Syntax(error.to_string()), at.row, at.col)
    })
}

/// All that is drawn, except the axis.
fn shapes<'a>(of: &Source, document: &'a Document<'a>) -> Vec<Shape<'a>> {
    let elements = shape::all(document.root()).into_iter();
    let lines = |element: Node<'a, 'a>| {
        let lines: Vec<Result<Part, ReadError>> = match shape::parts(of, element) {
            Ok(parts) if parts.is_empty() => vec![Ok(Part::default())],
            Ok(parts) => parts.into_iter().map(Ok).collect(),
            Err(error) => vec![Err(error)],
        };
        let several = lines.len() > 1;
        lines.into_iter().zip(1..).map(move |(line, i)| Shape { element, line, number: several.then_some(i) })
    };
    elements.filter(|element| element.attribute("id") != Some(AXIS)).flat_map(lines).collect()
}

fn drawing(of: &Source, document: &Document, shape: &Shape, options: &Options) -> Result<Drawing, ReadError> {
    let is_nested = |node: &Node| node.tag_name().name() == "svg" && *node != document.root_element();
    if let Some(nested) = shape.element.ancestors().skip(1).find(is_nested) {
        let what = Reason::Unsupported("an svg element inside another".into());
        return Err(of.error(what, nested.range().start));
    }
    let Part { pieces, at, closed } = shape.line.clone()?;
    let marks = Marks::of_pieces(&pieces, at.iter().map(|at| of.place(*at)));
    let outline = if closed { Outline::closed(pieces) } else { Outline::open(pieces) };
    let outline = outline.map_err(|error| {
        let (line, column) = marks.culprit(&error).unwrap_or(of.place(shape.start()));
        of.error_in(error.into(), line, column)
    })?;
    let axis = match options.axis {
        Axis::At(x) => x,
        Axis::LeftEdge => outline.bounds()[0].r,
        Axis::Drawn => drawn_axis(of, document)?.unwrap_or(0.0),
    };
    let ([across, along], unit) = scale(of, document.root_element(), options.unit)?;
    let by = point(-axis, -outline.bounds()[0].z);
    let outline = outline.moved(by).stretched(across, along);
    let marks = marks.placed(by, [across, along]);
    let name = shape.element.attribute("id").map(|_| shape.name(of));
    Ok(Drawing { name, outline, unit, warnings: Vec::new(), place: of.place(shape.start()), marks })
}

/// The x of the element that is the axis, if there is one.
fn drawn_axis(of: &Source, document: &Document) -> Result<Option<f64>, ReadError> {
    let Some(element) = document.descendants().find(|node| node.attribute("id") == Some(AXIS)) else {
        return Ok(None);
    };
    let refused = || of.error(Reason::Axis, element.range().start);
    let [line] = shape::parts(of, element)?.try_into().map_err(|_| refused())?;
    let outline = Outline::open(line.pieces).map_err(|_| refused())?;
    let [low, high] = outline.bounds();
    let upright = high.r - low.r <= 1e-6 * (high.z - low.z);
    if upright { Ok(Some(0.5 * (low.r + high.r))) } else { Err(refused()) }
}

/// What one user unit is, across and along the axis.
fn scale(of: &Source, svg: Node, asked: Option<Unit>) -> Result<([f64; 2], Unit), ReadError> {
    if let Some(unit) = asked {
        return Ok(([unit.factor(); 2], unit.reduced()));
    }
    let length = |name: &str| -> Option<Length> { Length::from_str(svg.attribute(name)?).ok() };
    let physical = |name: &str| {
        let length = length(name)?;
        // Pixels are what an editor writes that was told of no unit.
        if length.unit == LengthUnit::Px { None } else { unit::millimeters(length) }
    };
    let no_unit = || of.error(Reason::NoUnit, svg.range().start);
    let view_box =
        match svg.attribute_node("viewBox") {
            None => None,
            Some(attribute) => Some(ViewBox::from_str(attribute.value()).map_err(|error| {
                of.error(Reason::Syntax(error.to_string()), attribute.range_value().start)
            })?),
        };
    let millimeters = match (view_box, physical("width"), physical("height")) {
        (Some(view_box), Some(w), Some(h)) => {
            let (across, along) = (w / view_box.w, h / view_box.h);
            let ratio =
                svg.attribute("preserveAspectRatio").and_then(|text| AspectRatio::from_str(text).ok());
            match ratio {
                Some(AspectRatio { align: Align::None, .. }) => [across, along],
                Some(AspectRatio { slice: true, .. }) => [across.max(along); 2],
                _ => [across.min(along); 2],
            }
        }
        (Some(view_box), Some(w), None) => [w / view_box.w; 2],
        (Some(view_box), None, Some(h)) => [h / view_box.h; 2],
        // A user unit is a pixel then, and a length in millimeters says how large that is.
        (None, Some(_), _) | (None, _, Some(_)) => [25.4 / 96.0; 2],
        (_, None, None) => return Err(no_unit()),
    };
    if millimeters.iter().all(|scale| *scale > 0.0 && scale.is_finite()) {
        Ok((millimeters, Unit::Millimeter))
    } else {
        Err(no_unit())
    }
}
