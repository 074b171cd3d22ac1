//! Charts of cost against error: a point a method, and the Pareto front, which no method beats in both. Both axes are
//! logarithmic. What has no error lies on a line of its own at the bottom.

use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, LogCoord};
use plotters::prelude::*;
use std::error::Error;
use std::ops::Range;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const FRONT: RGBColor = RGBColor(200, 60, 30);

/// Where methods without an error are drawn, as a factor on the lower end of the axis.
const NONE: f64 = 0.4;

pub struct Point {
    pub label: String,
    pub color: RGBColor,
    pub cost: f64,
    /// Zero if there is none.
    pub error: f64,
}

/// The axis of errors.
pub struct Axis {
    pub title: String,
    pub range: Range<f64>,
    /// Whether there is a line below the range for what has no error.
    pub has_none: bool,
}

pub struct Panel {
    pub title: &'static str,
    /// The title of the axis of costs.
    pub across: String,
    pub up: Axis,
    pub points: Vec<Point>,
}

/// Where the axis of costs ends, as a factor on the highest cost: the labels of the dearest methods find room.
const WIDER: f64 = 4.5;

const TICKS: [f64; 9] = [100.0, 200.0, 500.0, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4];
const WIDTH: u32 = 860;
const PANEL: u32 = 430;

/// Writes an SVG with the panels one below the other.
pub fn draw(file: &str, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(file, (WIDTH, PANEL * panels.len() as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    for (area, panel) in root.split_evenly((panels.len(), 1)).iter().zip(panels) {
        panel.draw(area)?;
    }
    root.present()?;
    Ok(())
}

impl Panel {
    fn draw(&self, area: &Area) -> Result<(), Box<dyn Error>> {
        let Self { title, across: across_title, up, points } = self;
        let (low, high) = (if up.has_none { 0.1 * up.range.start } else { up.range.start }, up.range.end);
        let height = |point: &Point| if point.error > 0.0 { point.error } else { NONE * up.range.start };
        let costs = || points.iter().map(|point| point.cost);
        let (least, most) = (costs().fold(f64::MAX, f64::min), costs().fold(0.0, f64::max));
        let ticks = TICKS.into_iter().filter(|tick| (0.75 * least..WIDER * most).contains(tick)).collect();
        let across: LogCoord<f64> = (0.75 * least..WIDER * most).log_scale().into();
        let mut chart = ChartBuilder::on(area)
            .caption(title, ("sans-serif", 19))
            .margin(12)
            .x_label_area_size(42)
            .y_label_area_size(66)
            .build_cartesian_2d(across.with_key_points(ticks), (low..high).log_scale())?;
        chart
            .configure_mesh()
            .x_desc(across_title)
            .y_desc(&up.title)
            .axis_desc_style(("sans-serif", 14))
            .label_style(("sans-serif", 13))
            .light_line_style(WHITE)
            .bold_line_style(RGBColor(225, 225, 225))
            .x_label_formatter(&|x| format!("{x:.0}"))
            .y_label_formatter(&|y| if *y < up.range.start { String::new() } else { format!("{y:.0}") })
            .draw()?;

        let front = front(points, height);
        let steps = front.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
        let first = front.first().map(|first| (first.0, high));
        let last = front.last().map(|last| (WIDER * most, last.1));
        let line: Vec<(f64, f64)> =
            first.into_iter().chain(steps).chain(front.last().copied()).chain(last).collect();
        chart.draw_series(LineSeries::new(line.clone(), FRONT.mix(0.45).stroke_width(2)))?;
        for point in points {
            let place = (point.cost, height(point));
            chart.draw_series([Circle::new(place, 5, point.color.filled())])?;
        }

        let places: Vec<(i32, i32)> =
            points.iter().map(|p| chart.backend_coord(&(p.cost, height(p)))).collect();
        // Coordinates of the whole drawing, not of this panel's part of it.
        let (left, top) = area.get_base_pixel();
        let places: Vec<(i32, i32)> = places.iter().map(|(x, y)| (x - left, y - top)).collect();
        let (right, _) = area.dim_in_pixel();
        let mut taken: Vec<Frame> =
            places.iter().map(|&(x, y)| Frame { x: x - 6, y: y - 6, w: 12, h: 12 }).collect();
        // The labels and the lines that lead to them, which no other such line may cross.
        let mut crossed: Vec<Frame> = Vec::new();
        // Labels keep off the front, too.
        let corners = line.iter().map(|corner| chart.backend_coord(corner)).map(|(x, y)| (x - left, y - top));
        let corners: Vec<(i32, i32)> = corners.collect();
        taken.extend(corners.windows(2).map(|pair| Frame {
            x: pair[0].0.min(pair[1].0),
            y: pair[0].1.min(pair[1].1),
            w: (pair[1].0 - pair[0].0).abs() + 2,
            h: (pair[1].1 - pair[0].1).abs() + 2,
        }));
        // From the dearest on: a label to the right of the line that leads to it is in the way of no cheaper point's.
        let mut sorted: Vec<(&Point, (i32, i32))> = points.iter().zip(places).collect();
        sorted.sort_by_key(|(_, (x, _))| -x);
        // Points at one place share a label.
        for same in sorted.chunk_by(|(a, p), (b, q)| a.color == b.color && p.0 - q.0 <= 1 && p.1 == q.1) {
            let (point, place) = same[0];
            // "rays, split, libm and native".
            let mut text = point.label.clone();
            for (other, _) in &same[1..] {
                let last = other.label.rsplit(", ").next().unwrap_or_default();
                text += &format!(" and {last}");
            }
            let (width, _) = area.estimate_text_size(&text, &("sans-serif", 13).into_text_style(area))?;
            // Between two labels on one line there is a gap.
            let size = (width as i32 + 6, 13);
            let (spot, foot) = spot(place, size, right as i32, &taken, &crossed);
            let (x, y) = (spot.x, spot.y);
            let line = foot.map_or(Vec::new(), |foot| along(place, foot));
            taken.extend(line.iter().copied().chain([spot]));
            crossed.extend(line.into_iter().chain([spot]));
            if let Some(foot) = foot {
                area.draw(&PathElement::new([place, foot], point.color.mix(0.5)))?;
            }
            area.draw(&Text::new(text.as_str(), (x, y), ("sans-serif", 13).into_font().color(&point.color)))?;
        }
        if up.has_none {
            let none = chart.backend_coord(&(least, NONE * up.range.start)).1 - top;
            area.draw(&Text::new("none", (45, none - 7), ("sans-serif", 13).into_font()))?;
        }
        Ok(())
    }
}

#[derive(Clone, Copy)]
struct Frame {
    x: i32,
    y: i32,
    w: i32,
    h: i32,
}

impl Frame {
    fn meets(&self, other: &Self) -> bool {
        self.x < other.x + other.w
            && other.x < self.x + self.w
            && self.y < other.y + other.h
            && other.y < self.y + self.h
    }
}

/// The squares of two pixels along a line, without those under the dot where it begins.
fn along((x, y): (i32, i32), (to_x, to_y): (i32, i32)) -> Vec<Frame> {
    let (across, up) = (to_x - x, to_y - y);
    let steps = (across.abs().max(up.abs()) / 2).max(1);
    (1..=steps)
        .map(|i| (across * i / steps, up * i / steps))
        .filter(|(dx, dy)| dx.abs().max(dy.abs()) > 7)
        .map(|(dx, dy)| Frame { x: x + dx - 1, y: y + dy - 1, w: 2, h: 2 })
        .collect()
}

/// The nearest free place for a label of size `(w, h)`, rather to the right than to the left; and if it is so far off that a line
/// must lead there, that line's end. The label keeps off `taken`, the line off `crossed`.
fn spot(
    (x, y): (i32, i32),
    (w, h): (i32, i32),
    right: i32,
    taken: &[Frame],
    crossed: &[Frame],
) -> (Frame, Option<(i32, i32)>) {
    let mut spots = Vec::new();
    let (right_of, left_of) = ([(9, -7), (-2, -22), (-2, 8)], [(-9 - w, -7), (-w + 6, -22), (-w + 6, 8)]);
    for (rise, sides) in (0..5).map(|rise| (rise, right_of)).chain((0..14).map(|rise| (rise, left_of))) {
        for (dx, dy) in sides {
            for up in [-13 * rise, 13 * rise] {
                let spot = Frame { x: x + dx, y: y + dy + up, w, h };
                let near = if spot.y < y { spot.y + h } else { spot.y };
                spots.push((spot, (rise > 0).then_some((x.clamp(spot.x, spot.x + w - 6), near))));
            }
        }
    }
    let free = |frame: &Frame, others: &[Frame]| !others.iter().any(|other| other.meets(frame));
    let inside = |spot: &Frame| {
        spot.x > 84 && spot.x + spot.w < right - 8 && spot.y > 30 && spot.y + spot.h < PANEL as i32 - 62
    };
    let is_free = |(spot, _): &&(Frame, _)| inside(spot) && free(spot, taken);
    let is_reached = |(_, foot): &&(Frame, Option<(i32, i32)>)| {
        foot.is_none_or(|foot| along((x, y), foot).iter().all(|frame| free(frame, crossed)))
    };
    let good = spots.iter().filter(is_free).find(is_reached);
    let first = good.or_else(|| spots.iter().find(is_free)).or(spots.first());
    first.copied().unwrap_or((Frame { x, y, w, h }, None))
}

/// Those that no other beats in both, from the cheapest on.
fn front(points: &[Point], height: impl Fn(&Point) -> f64) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = points.iter().map(|p| (p.cost, height(p))).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut front: Vec<(f64, f64)> = Vec::new();
    for point in sorted {
        if front.last().is_none_or(|last| point.1 < last.1) {
            front.push(point);
        }
    }
    front
}
