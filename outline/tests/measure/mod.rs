//! What the tests measure a body with: points on it and on the drawing, and nothing of the proof.

#![allow(dead_code)] // Not every test file uses all of it.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use embedded_lathe::{Background, Camera, Light, Rgb, Scene, Solid};
use embedded_lathe_outline::{Body, Outline, Point, Sheet, point};

/// Compares a picture of a solid, drawn by rows and seen from the side, with the drawn outline: a pixel shows the solid if
/// its center is within the outline, and does not if it is beside it, unless it is no farther from the
/// outline than the tolerance. Returns how many pixels show it and how many do not.
pub fn silhouette(solid: &Solid, outline: &Outline, tolerance: f64, name: &str) -> [usize; 2] {
    const SIZE: u32 = 200;
    let [low, high] = outline.bounds();
    let half = (1.1 * high.r.max(0.5 * (high.z - low.z))) as f32;
    let middle = (0.5 * (low.z + high.z)) as f32;
    let eye = [0.0, -4.0 * half, middle];
    let camera = Camera::orthographic(eye, [0.0, 0.0, middle], [0.0, 0.0, 1.0], half).expect("a camera");
    // Lit from the eye, with all light from everywhere: what shows the solid is white.
    let light = Light::new([0.0, -1.0, 0.0], 1.0).expect("a light");
    let solids = [solid.colored(Rgb::WHITE)];
    let scene =
        Scene::new(&solids, camera, light).with_background(Background::Plain(Rgb::new(0.0, 0.0, 0.0)));
    let picture = scene.picture(SIZE, SIZE);
    let line = drawn(outline, 400);
    let lines = [line.clone()];
    // 4 units of 2⁻²⁴·(the solid's size + the camera's distance) are what the crate promises of a ray beside a silhouette;
    // 4 more for the numbers of the ray itself. What chords of the line are off by is below a 10⁻⁶ of the size.
    let size = f64::from(half);
    let within = tolerance + 8.0 * 6.0 * size / 16_777_216.0 + 2e-6 * size;
    let mut row = vec![Gray8::new(0); SIZE as usize];
    let mut counts = [0; 2];
    for y in 0..SIZE {
        picture.row(y, &mut row);
        let at = |i: u32| f64::from(half) * (2.0 * (f64::from(i) + 0.5) / f64::from(SIZE) - 1.0);
        let z = f64::from(middle) - at(y);
        // From the side a solid is as wide as the widest of what it is at that height.
        let crossings = line.windows(2).filter(|p| (p[0].z - z) * (p[1].z - z) <= 0.0 && p[0].z != p[1].z);
        let radii = crossings.map(|p| p[0].r + (p[1].r - p[0].r) * (z - p[0].z) / (p[1].z - p[0].z));
        let widest = radii.fold(0.0, f64::max);
        for (x, pixel) in (0..SIZE).zip(&row) {
            let shows = pixel.luma() > 127;
            counts[usize::from(!shows)] += 1;
            let r = at(x).abs();
            if shows != (r < widest) {
                let (off, _) = farthest(&[point(r, z)], &lines);
                assert!(
                    off <= within,
                    "{name}: pixel {x}, {y}, radius {r}, height {z}: {shows}, {off} from the outline"
                );
            }
        }
    }
    counts
}

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
