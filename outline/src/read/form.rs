//! Points by name, in JSON.
//!
//! A form is an object with `kind` and `points`; a file holds one form, or an object of forms by name.
//!
//! | `kind` | |
//! |---|---|
//! | `"catmull-rom"` | `points`, the first and the last for tangents only |
//! | `"bezier"` | `pieces`, each a list of control points |
//! | `"polygon"` | `points`, joined by straight lines and closed, unless `"open": true` |
//! | `"smooth"` | `points`, joined by a smooth curve; one that stands twice is a corner |
//! | `"sor"` | `points`, through which the *squared* radius is a cubic spline over height: the slope at each is that of the radii beside it; the first and the last are for slopes only |
//!
//! A point is a list of two numbers, `[radius, height]`, or the other way around with
//! `"order": "height,radius"`. `"unit"` may be a unit's name.

use super::{
    Drawing, Options, Unit,
    part::Marks,
    place::{ReadError, Reason, Source},
};
use crate::{Outline, OutlineError, Piece, Point, point};
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    CatmullRom,
    Bezier,
    Polygon,
    Smooth,
    Sor,
}

#[derive(Deserialize)]
struct Form {
    kind: Kind,
    #[serde(default)]
    order: Order,
    #[serde(default)]
    points: Vec<[f64; 2]>,
    #[serde(default)]
    pieces: Vec<Vec<[f64; 2]>>,
    #[serde(default)]
    open: bool,
    unit: Option<String>,
}

#[derive(Deserialize, Default)]
enum Order {
    #[default]
    #[serde(rename = "radius,height")]
    RadiusHeight,
    #[serde(rename = "height,radius")]
    HeightRadius,
}

pub(crate) fn one(of: &Source, options: &Options) -> Result<Drawing, ReadError> {
    let mut forms = forms(of)?;
    let names = || forms.iter().filter_map(|(name, _)| name.clone()).collect::<Vec<_>>();
    let at = match &options.name {
        Some(wanted) => forms
            .iter()
            .position(|(name, _)| name.as_ref() == Some(wanted))
            .ok_or_else(|| of.error(Reason::NotFound { name: wanted.clone(), names: names() }, 0))?,
        None if forms.len() == 1 => 0,
        None if forms.is_empty() => return Err(of.error(Reason::NoShape, 0)),
        None => return Err(of.error(Reason::Ambiguous(names()), 0)),
    };
    let (name, form) = forms.swap_remove(at);
    drawing(of, name, &form)
}

pub(crate) fn all(of: &Source) -> Result<Vec<Result<Drawing, ReadError>>, ReadError> {
    Ok(forms(of)?.into_iter().map(|(name, form)| drawing(of, name, &form)).collect())
}

fn forms(of: &Source) -> Result<Vec<(Option<String>, Form)>, ReadError> {
    let syntax = |error: serde_json::Error| {
        of.error_in(Reason::Syntax(error.to_string()), error.line() as u32, error.column() as u32)
    };
    let value: serde_json::Value = serde_json::from_str(of.text).map_err(syntax)?;
    if value.get("kind").is_some() {
        return Ok(vec![(None, serde_json::from_str(of.text).map_err(syntax)?)]);
    }
    let named: BTreeMap<String, Form> = serde_json::from_str(of.text).map_err(syntax)?;
    Ok(named.into_iter().map(|(name, form)| (Some(name), form)).collect())
}

fn drawing(of: &Source, name: Option<String>, form: &Form) -> Result<Drawing, ReadError> {
    let at = name.as_ref().and_then(|name| of.text.find(&format!("\"{name}\""))).unwrap_or(0);
    let unit = match &form.unit {
        None => Unit::None,
        Some(name) => Unit::from_name(name)
            .ok_or_else(|| of.error(Reason::Syntax(format!("{name:?} is not a unit of length")), at))?,
    };
    let all: Vec<Point> =
        form.points.iter().chain(form.pieces.iter().flatten()).map(|p| form.point(p)).collect();
    let places = points(&of.text[at..]).map(|in_form| of.place(at + in_form));
    let marks = Marks::of_points(&all, places);
    let outline = outline(form).map_err(|error| {
        let (line, column) = marks.culprit(&error).unwrap_or(of.place(at));
        of.error_in(error.into(), line, column)
    })?;
    let factor = unit.factor();
    let (outline, marks) = (outline.scaled(factor), marks.placed(point(0.0, 0.0), [factor; 2]));
    Ok(Drawing { name, outline, unit: unit.reduced(), warnings: Vec::new(), place: of.place(at), marks })
}

/// The bytes at which points begin, lists whose first element is a number.
fn points(text: &str) -> impl Iterator<Item = usize> {
    let is_point =
        |at: &usize| text[at + 1..].trim_start().starts_with(|c: char| c == '-' || c.is_ascii_digit());
    text.match_indices('[').map(|(at, _)| at).filter(is_point)
}

impl Form {
    fn point(&self, [a, b]: &[f64; 2]) -> Point {
        match self.order {
            Order::RadiusHeight => point(*a, *b),
            Order::HeightRadius => point(*b, *a),
        }
    }
}

fn outline(form: &Form) -> Result<Outline, OutlineError> {
    let read = |p: &[f64; 2]| form.point(p);
    let points: Vec<Point> = form.points.iter().map(read).collect();
    match form.kind {
        Kind::CatmullRom => Outline::catmull_rom(&points),
        Kind::Polygon => Outline::polygon(&points, !form.open),
        Kind::Smooth => Outline::smooth(&points),
        Kind::Sor => squares(&points),
        Kind::Bezier => {
            let pieces: Vec<Vec<Point>> =
                form.pieces.iter().map(|piece| piece.iter().map(read).collect()).collect();
            if let Some(piece) = pieces.iter().find(|p| p.is_empty() || p.len() > crate::HIGHEST_DEGREE + 1) {
                return Err(OutlineError::Degree { points: piece.len() });
            }
            Outline::open(pieces.iter().map(|piece| Piece::bezier(piece)).collect())
        }
    }
}

/// Squared radius as a cubic spline over height. Its slope at a point is 2·r times that of the line between the
/// points beside it.
fn squares(points: &[Point]) -> Result<Outline, OutlineError> {
    let slope = |i: usize| {
        let (before, after) = (points[i - 1], points[i + 1]);
        2.0 * points[i].r * (after.r - before.r) / (after.z - before.z)
    };
    let piece = |i: usize| {
        let (p, q) = (points[i], points[i + 1]);
        let third = (q.z - p.z) / 3.0;
        let ordinates =
            [p.r * p.r, p.r * p.r + third * slope(i), q.r * q.r - third * slope(i + 1), q.r * q.r];
        Piece::squares([p.z, q.z], ordinates)
    };
    Outline::open((1..points.len().saturating_sub(2)).map(piece).collect())
}
