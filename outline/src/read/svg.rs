//! SVG documents: which element is the outline, where the axis is, and how large it is.

use super::{
    Axis, Drawing, Options, Unit,
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
    let shapes = shapes(&document);
    let name = |shape: &Node| shape.attribute("id").map_or_else(|| unnamed(of, shape), str::to_string);
    let shape = match &options.name {
        Some(wanted) => shapes.iter().find(|shape| name(shape) == *wanted).ok_or_else(|| {
            of.error(Reason::NotFound { name: wanted.clone(), names: shapes.iter().map(name).collect() }, 0)
        })?,
        None => match shapes.as_slice() {
            [] => return Err(of.error(Reason::NoShape, document.root_element().range().start)),
            [shape] => shape,
            [_, second, ..] => {
                let names = shapes.iter().map(name).collect();
                return Err(of.error(Reason::Ambiguous(names), second.range().start));
            }
        },
    };
    let mut drawing = drawing(of, &document, *shape, options)?;
    let others = shapes.iter().filter(|other| *other != shape);
    drawing.warnings.extend(others.map(|other| Warning::LeftOut { what: name(other) }));
    Ok(drawing)
}

pub(crate) fn all(of: &Source, options: &Options) -> Result<Vec<Result<Drawing, ReadError>>, ReadError> {
    let document = parse(of)?;
    let shapes = shapes(&document);
    if shapes.is_empty() {
        return Err(of.error(Reason::NoShape, document.root_element().range().start));
    }
    Ok(shapes.into_iter().map(|shape| drawing(of, &document, shape, options)).collect())
}

fn parse<'a>(of: &Source<'a>) -> Result<Document<'a>, ReadError> {
    // Inkscape's files may name a document type; entities are expanded at most so often as to stay small.
    let options = ParsingOptions { allow_dtd: true, nodes_limit: 1_000_000, ..ParsingOptions::default() };
    Document::parse_with_options(of.text, options).map_err(|error| {
        let at = error.pos();
        of.error_in(Reason::Syntax(error.to_string()), at.row, at.col)
    })
}

/// All that is drawn, except the axis.
fn shapes<'a>(document: &'a Document<'a>) -> Vec<Node<'a, 'a>> {
    let mut shapes = shape::all(document.root());
    shapes.retain(|shape| shape.attribute("id") != Some(AXIS));
    shapes
}

/// What an element without an id is called: by its line.
fn unnamed(of: &Source, shape: &Node) -> String {
    format!("{} in line {}", shape.tag_name().name(), of.place(shape.range().start).0)
}

fn drawing(of: &Source, document: &Document, shape: Node, options: &Options) -> Result<Drawing, ReadError> {
    let at = shape.range().start;
    if let Some(nested) = shape
        .ancestors()
        .skip(1)
        .find(|node| node.tag_name().name() == "svg" && *node != document.root_element())
    {
        return Err(
            of.error(Reason::Unsupported("an svg element inside another".into()), nested.range().start)
        );
    }
    let (pieces, closed) = shape::pieces(of, shape)?;
    let error = |error: crate::OutlineError| of.error(error.into(), at);
    let outline = if closed { Outline::closed(pieces) } else { Outline::open(pieces) }.map_err(error)?;
    let axis = match options.axis {
        Axis::At(x) => x,
        Axis::LeftEdge => outline.bounds()[0].r,
        Axis::Drawn => drawn_axis(of, document)?.unwrap_or(0.0),
    };
    let ([across, along], unit) = scale(of, document.root_element(), options.unit)?;
    let lowest = outline.bounds()[0].z;
    let outline = outline.moved(point(-axis, -lowest)).stretched(across, along);
    let name = shape.attribute("id").map(str::to_string);
    Ok(Drawing { name, outline, unit, warnings: Vec::new(), place: of.place(at) })
}

/// The x of the element that is the axis, if there is one.
fn drawn_axis(of: &Source, document: &Document) -> Result<Option<f64>, ReadError> {
    let Some(element) = document.descendants().find(|node| node.attribute("id") == Some(AXIS)) else {
        return Ok(None);
    };
    let refused = || of.error(Reason::Axis, element.range().start);
    let (pieces, _) = shape::pieces(of, element)?;
    let outline = Outline::open(pieces).map_err(|_| refused())?;
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
