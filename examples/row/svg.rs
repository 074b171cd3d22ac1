//! As much of SVG as the picture takes. Points are [`Point`]s of the plane: the eye on the left, seen from above.

use crate::plane::Point;
use std::fmt::Write;

pub const WIDTH: f32 = 860.0;
pub const HEIGHT: f32 = 400.0;

/// The page's pixels to the world's unit, and the eye's place.
const SCALE: f32 = 296.0;
const LEFT: f32 = 46.0;

pub struct Svg(String);

impl Svg {
    pub fn new() -> Self {
        Self(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        ))
    }

    /// A closed shape.
    pub fn shape(&mut self, points: &[Point], style: &str) {
        self.points("polygon", points, style);
    }

    pub fn line(&mut self, points: &[Point], style: &str) {
        self.points("polyline", points, style);
    }

    pub fn dot(&mut self, point: Point, radius: f32, style: &str) {
        let [x, y] = page(point);
        self.add(&format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" {style}/>"));
    }

    /// Words turned by so many degrees; `style` says how they are anchored.
    pub fn words(&mut self, point: Point, turn: f32, style: &str, words: &str) {
        let [x, y] = page(point);
        self.add(&format!(
            "<text transform=\"translate({x:.1} {y:.1}) rotate({turn})\" {style}>{words}</text>"
        ));
    }

    pub fn finish(self) -> String {
        self.0 + "</svg>\n"
    }

    fn points(&mut self, what: &str, points: &[Point], style: &str) {
        let mut list = String::new();
        for [x, y] in points.iter().copied().map(page) {
            let _ = write!(list, "{x:.1},{y:.1} ");
        }
        self.add(&format!("<{what} points=\"{}\" {style}/>", list.trim_end()));
    }

    fn add(&mut self, element: &str) {
        self.0 += element;
        self.0.push('\n');
    }
}

fn page([away, across]: Point) -> Point {
    [LEFT + SCALE * away, 0.5 * HEIGHT + SCALE * across]
}
