//! What the tests measure a body with: points on it and on the drawing, and nothing of the proof.

use embedded_lathe_outline::{Body, Outline, Point, Sheet, point};

/// The drawing in many points.
pub fn drawn(outline: &Outline, each: usize) -> Vec<Point> {
    let on = |i: usize| i as f64 / each as f64;
    outline.pieces().iter().flat_map(|piece| (0..=each).map(move |i| piece.at(on(i)))).collect()
}

/// The body's outline in lines: each sheet with the flats at its ends and its steps.
pub fn lines(body: &Body, each: usize) -> Vec<Vec<Point>> {
    body.sheets.iter().map(|sheet| line(sheet, each)).collect()
}

fn line(sheet: &Sheet, each: usize) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    for segment in sheet.segments() {
        points.extend((0..=each).map(|i| {
            // Closer together towards the ends, where a pole may be.
            let u = 0.5 - 0.5 * (std::f64::consts::PI * i as f64 / each as f64).cos();
            let [b0, b1, b2, b3] = segment.b;
            let v = 1.0 - u;
            let f = b0 * v * v * v + 3.0 * b1 * v * v * u + 3.0 * b2 * v * u * u + b3 * u * u * u;
            point(f.max(0.0).sqrt(), segment.z[0] + u * (segment.z[1] - segment.z[0]))
        }));
    }
    let (low, high) = (points[0].z, points[points.len() - 1].z);
    if let Some(base) = sheet.base {
        points.insert(0, point(f64::from(base).sqrt(), low));
    }
    if let Some(top) = sheet.top {
        points.push(point(f64::from(top).sqrt(), high));
    }
    points
}

/// The largest distance of some points from the nearest of some lines, and where it is.
pub fn farthest(points: &[Point], lines: &[Vec<Point>]) -> (f64, Point) {
    let chords: Vec<[Point; 2]> =
        lines.iter().flat_map(|line| line.windows(2).map(|p| [p[0], p[1]])).collect();
    let nearest = |p: &Point| {
        chords.iter().fold(f64::INFINITY, |best, [a, b]| {
            if p.z < a.z.min(b.z) - best || p.z > a.z.max(b.z) + best {
                best
            } else {
                best.min(to_chord(*p, *a, *b))
            }
        })
    };
    let start = (0.0, point(f64::NAN, f64::NAN));
    points.iter().map(|p| (nearest(p), *p)).fold(start, |a, b| if b.0 > a.0 { b } else { a })
}

fn to_chord(p: Point, a: Point, b: Point) -> f64 {
    let (dr, dz) = (b.r - a.r, b.z - a.z);
    let t = ((p.r - a.r) * dr + (p.z - a.z) * dz) / (dr * dr + dz * dz).max(1e-300);
    let t = t.clamp(0.0, 1.0);
    (p.r - a.r - t * dr).hypot(p.z - a.z - t * dz)
}

/// The points of lines, and of their level parts, which are flats, points between as well.
pub fn on(lines: &[Vec<Point>]) -> Vec<Point> {
    let between = |p: &[Point]| {
        let (a, b) = (p[0], p[1]);
        let count = if a.z == b.z { 16 } else { 1 };
        (0..count).map(move |i| {
            point(
                a.r + (b.r - a.r) * f64::from(i) / f64::from(count),
                a.z + (b.z - a.z) * f64::from(i) / f64::from(count),
            )
        })
    };
    lines.iter().flat_map(|line| line.windows(2).flat_map(between).chain(line.last().copied())).collect()
}
