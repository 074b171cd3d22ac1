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
        let (low, high) = (if up.has_none { 0.2 * up.range.start } else { up.range.start }, up.range.end);
        let height = |point: &Point| if point.error > 0.0 { point.error } else { NONE * up.range.start };
        let costs = || points.iter().map(|point| point.cost);
        let (least, most) = (costs().fold(f64::MAX, f64::min), costs().fold(0.0, f64::max));
        let ticks = TICKS.into_iter().filter(|tick| (0.75 * least..1.9 * most).contains(tick)).collect();
        let across: LogCoord<f64> = (0.75 * least..1.9 * most).log_scale().into();
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
        let last = front.last().map(|last| (1.9 * most, last.1));
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
        // Labels keep off the front, too.
        let corners = line.iter().map(|corner| chart.backend_coord(corner)).map(|(x, y)| (x - left, y - top));
        let corners: Vec<(i32, i32)> = corners.collect();
        taken.extend(corners.windows(2).map(|pair| Frame {
            x: pair[0].0.min(pair[1].0),
            y: pair[0].1.min(pair[1].1),
            w: (pair[1].0 - pair[0].0).abs() + 2,
            h: (pair[1].1 - pair[0].1).abs() + 2,
        }));
        for (point, &place) in points.iter().zip(&places) {
            let text = &point.label;
            let (width, _) = area.estimate_text_size(text, &("sans-serif", 13).into_text_style(area))?;
            // Between two labels on one line there is a gap.
            let size = (width as i32 + 6, 13);
            let (spot, aside) = spot(place, size, right as i32, &taken);
            taken.push(spot);
            let (x, y) = (spot.x, spot.y);
            if aside {
                let near = if y < place.1 { y + 13 } else { y };
                let foot = place.0.clamp(x, x + size.0);
                area.draw(&PathElement::new([place, (foot, near)], point.color.mix(0.5)))?;
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

/// The nearest free place for a label: to the right, to the left, above, below, then farther off; and whether it is so far off that a line must lead there.
fn spot((x, y): (i32, i32), (w, h): (i32, i32), right: i32, taken: &[Frame]) -> (Frame, bool) {
    let mut spots = Vec::new();
    for rise in 0..12 {
        let dy = 13 * rise;
        for (sx, sy) in [(9, -7), (-9 - w, -7), (-w / 2, -22), (-w / 2, 8)] {
            spots.push((Frame { x: x + sx, y: y + sy - dy, w, h }, rise > 0));
            spots.push((Frame { x: x + sx, y: y + sy + dy, w, h }, rise > 0));
        }
    }
    let inside = |spot: &Frame| {
        spot.x > 84 && spot.x + spot.w < right - 8 && spot.y > 30 && spot.y + spot.h < PANEL as i32 - 62
    };
    let free = |spot: &Frame| inside(spot) && !taken.iter().any(|other| other.meets(spot));
    let first = spots.iter().find(|(spot, _)| free(spot)).or(spots.first());
    first.copied().unwrap_or((Frame { x, y, w, h }, false))
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
