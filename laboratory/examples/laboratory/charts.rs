//! Cost against error: a point a contender, and the Pareto front, which no contender beats in both.
//!
//! Across, instructions a solve, the mean over the workload's families; up, wrong answers in 10 000, over all families. What has none lies on a line
//! of its own at the bottom.

use crate::csv::{Method, costs, rows};
use laboratory::WRONG;
use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, LogCoord};
use plotters::prelude::*;
use std::collections::BTreeMap;
use std::error::Error;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const SHIPPED: RGBColor = RGBColor(200, 60, 30);
const CARDANO: RGBColor = RGBColor(215, 140, 20);
const RIVAL: RGBColor = RGBColor(50, 90, 150);
const PEER: RGBColor = RGBColor(90, 140, 60);

/// Where answers without a wrong one are drawn, and the axis's ends.
const NONE: f64 = 0.4;
const LOW: f64 = 0.2;
const HIGH: f64 = 20_000.0;

struct Point {
    method: String,
    backend: String,
    cost: f64,
    wrong: f64,
}

pub fn write() -> Result<(), Box<dyn Error>> {
    let wrong = wrong()?;
    let panel = |file: &str| points(file, &wrong);
    draw(
        "docs/cost-and-error.svg",
        &[
            ("On a Cortex-M4F", panel("docs/cost-m4f.csv")?),
            ("On the host, x86-64", panel("docs/cost-host.csv")?),
        ],
    )?;
    draw(
        "docs/cost-and-error-soft-float.svg",
        &[("On a Cortex-M3, in software floating point", panel("docs/cost-m3.csv")?)],
    )
}

/// Wrong answers in 10 000.
fn wrong() -> Result<BTreeMap<Method, f64>, Box<dyn Error>> {
    let mut shares = BTreeMap::new();
    for row in rows("docs/solvers.csv")?.into_iter().filter(|row| row[2] == "all") {
        let share = 1e4 * row[4].parse::<f64>()? / row[3].parse::<f64>()?;
        shares.insert((row[0].clone(), row[1].clone()), share);
    }
    Ok(shares)
}

fn points(file: &str, wrong: &BTreeMap<Method, f64>) -> Result<Vec<Point>, Box<dyn Error>> {
    let point = |((method, backend), (cost, _)): (Method, (f64, f64))| {
        let wrong = *wrong.get(&(method.clone(), backend.clone()))?;
        Some(Point { method, backend, cost, wrong })
    };
    Ok(costs(file)?.into_iter().filter_map(point).collect())
}

impl Point {
    fn height(&self) -> f64 {
        if self.wrong > 0.0 { self.wrong } else { NONE }
    }

    fn color(&self) -> RGBColor {
        match (self.method.as_str(), self.backend.as_str()) {
            ("split", _) => SHIPPED,
            ("Cardano", _) => CARDANO,
            (_, "f64") => PEER,
            _ => RIVAL,
        }
    }

    fn is_shipped(&self) -> bool {
        ["split", "Cardano"].contains(&self.method.as_str())
    }

    /// The crate's methods by name where they are cheapest, elsewhere by their backend alone: they have their own colors.
    fn label(&self, points: &[Self]) -> String {
        let others = points.iter().filter(|other| other.method == self.method);
        let cheapest = others.fold(f64::INFINITY, |cheapest, other| cheapest.min(other.cost));
        let backend = self.backend.as_str();
        match (self.is_shipped(), backend) {
            (true, _) if self.cost > 1.02 * cheapest => backend.to_owned(),
            (true, _) => format!("crate: {}, {backend}", self.method),
            (_, "") => self.method.clone(),
            _ => format!("{}, {backend}", self.method),
        }
    }
}

const TICKS: [f64; 9] = [100.0, 200.0, 500.0, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4];
const WIDTH: u32 = 860;
const PANEL: u32 = 430;

fn draw(file: &str, panels: &[(&str, Vec<Point>)]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(file, (WIDTH, PANEL * panels.len() as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    for (area, (title, points)) in root.split_evenly((panels.len(), 1)).iter().zip(panels) {
        panel(area, title, points)?;
    }
    root.present()?;
    Ok(())
}

fn panel(area: &Area, title: &str, points: &[Point]) -> Result<(), Box<dyn Error>> {
    let costs = || points.iter().map(|point| point.cost);
    let (least, most) = (costs().fold(f64::MAX, f64::min), costs().fold(0.0, f64::max));
    let ticks = TICKS.into_iter().filter(|tick| (0.75 * least..1.9 * most).contains(tick)).collect();
    let across: LogCoord<f64> = (0.75 * least..1.9 * most).log_scale().into();
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 19))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(66)
        .build_cartesian_2d(across.with_key_points(ticks), (LOW..HIGH).log_scale())?;
    chart
        .configure_mesh()
        .x_desc("instructions a solve")
        .y_desc(format!("answers off by more than {WRONG} units, in 10 000"))
        .axis_desc_style(("sans-serif", 14))
        .label_style(("sans-serif", 13))
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225))
        .x_label_formatter(&|x| format!("{x:.0}"))
        .y_label_formatter(&|y| if *y < 1.0 { String::new() } else { format!("{y:.0}") })
        .draw()?;

    let front = front(points);
    let steps = front.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
    let first = front.first().map(|first| (first.0, HIGH));
    let last = front.last().map(|last| (1.9 * most, last.1));
    let line: Vec<(f64, f64)> =
        first.into_iter().chain(steps).chain(front.last().copied()).chain(last).collect();
    chart.draw_series(LineSeries::new(line.clone(), SHIPPED.mix(0.45).stroke_width(2)))?;
    for point in points {
        let place = (point.cost, point.height());
        chart.draw_series([Circle::new(place, 5, point.color().filled())])?;
    }

    let places: Vec<(i32, i32)> = points.iter().map(|p| chart.backend_coord(&(p.cost, p.height()))).collect();
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
        let text = point.label(points);
        let (width, _) = area.estimate_text_size(&text, &("sans-serif", 13).into_text_style(area))?;
        let size = (width as i32, 13);
        let (spot, aside) = spot(place, size, right as i32, &taken);
        taken.push(spot);
        let (x, y) = (spot.x, spot.y);
        if aside {
            let near = if y < place.1 { y + 13 } else { y };
            let foot = place.0.clamp(x, x + size.0);
            area.draw(&PathElement::new([place, (foot, near)], point.color().mix(0.5)))?;
        }
        area.draw(&Text::new(text, (x, y), ("sans-serif", 13).into_font().color(&point.color())))?;
    }
    let none = chart.backend_coord(&(least, NONE)).1 - top;
    area.draw(&Text::new("none", (45, none - 7), ("sans-serif", 13).into_font()))?;
    Ok(())
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
fn front(points: &[Point]) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = points.iter().map(|p| (p.cost, p.height())).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut front: Vec<(f64, f64)> = Vec::new();
    for point in sorted {
        if front.last().is_none_or(|last| point.1 < last.1) {
            front.push(point);
        }
    }
    front
}
