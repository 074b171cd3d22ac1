//! Tables of height and radius.

use super::{
    Drawing, Options, Unit,
    part::Marks,
    place::{ReadError, Reason, Source},
};
use crate::{Outline, Point, point};

/// Rows of two numbers, height and radius; of radius and height if the first row says so by names that begin with
/// r and with h or z. A row that stands twice is a corner.
pub(crate) fn one(of: &Source, options: &Options) -> Result<Drawing, ReadError> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(of.text.as_bytes());
    let mut points: Vec<Point> = Vec::new();
    let mut places = Vec::new();
    let mut radius_first = false;
    for (row, record) in reader.records().enumerate() {
        let record = record.map_err(|error| {
            let at = error.position().map_or(0, |position| position.byte() as usize);
            of.error(Reason::Syntax(error.to_string()), at)
        })?;
        let at = record.position().map_or(0, |position| position.byte() as usize);
        let field = |column: usize| {
            // Where the field begins in its row.
            let line = of.text.get(at..).unwrap_or("").lines().next().unwrap_or("");
            let before: usize = line.split(',').take(column).map(|field| field.len() + 1).sum();
            at + before.min(line.len())
        };
        let names: Vec<String> = record.iter().map(str::to_ascii_lowercase).collect();
        if row == 0 && names.iter().any(|name| name.starts_with(['h', 'r', 'z'])) {
            radius_first = names.first().is_some_and(|name| name.starts_with('r'));
            continue;
        }
        if record.len() != 2 {
            let text = format!("a row has {} fields, not a height and a radius", record.len());
            return Err(of.error(Reason::Syntax(text), at));
        }
        let number = |column: usize| -> Result<f64, ReadError> {
            let text = &record[column];
            let number: Option<f64> = text.parse().ok().filter(|number: &f64| number.is_finite());
            number.ok_or_else(|| {
                of.error(Reason::Syntax(format!("{text:?} is not a finite number")), field(column))
            })
        };
        let (first, second) = (number(0)?, number(1)?);
        places.push(of.place(at));
        points.push(if radius_first { point(first, second) } else { point(second, first) });
    }
    let outline = if options.straight { Outline::polygon(&points, false) } else { Outline::smooth(&points) };
    let outline = outline.map_err(|error| of.error(error.into(), 0))?;
    let unit = options.unit.unwrap_or(Unit::None);
    let factor = unit.factor();
    let marks = Marks::of_points(&points, places.into_iter()).placed(point(0.0, 0.0), [factor; 2]);
    let outline = outline.scaled(factor);
    Ok(Drawing { name: None, outline, unit: unit.reduced(), warnings: Vec::new(), place: (1, 1), marks })
}
