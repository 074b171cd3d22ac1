//! Pictures of where methods die: two things that hurt across and up, the error as color.
//!
//! Each pixel is several rays at the vase, judged by exact arithmetic, the worst shown. From blue through white to red: the displacement that explains the answer,
//! in units of 2⁻²⁴·(size + distance), by powers of ten from 0.1 to 10⁶; black is more, or no number.

use crate::progress::bar;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_7X13};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use embedded_lathe::Camera;
use laboratory::cases::{Cast, Outline, outline};
use laboratory::forms::{METHODS, Nearest};
use laboratory::hits::Truth;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use std::error::Error;

/// Cells across and up, pixels a cell, rays a cell.
const CELLS: u32 = 48;
const ZOOM: u32 = 5;
const RAYS: u64 = 3;

/// The form and the solver: the paper's, the textbook's on sound coefficients, the crate's default.
const SHOWN: [usize; 3] = [0, 2, 3];

/// A ray at an outline, from two coordinates in [0, 1].
type Scene = fn(f64, f64, &mut ChaCha8Rng) -> (Outline, Cast);

pub fn write() -> Result<(), Box<dyn Error>> {
    atlas(&LEVEL)?;
    atlas(&FAR)?;
    eye_level("docs/eye-level.png")
}

/// Across: log₁₀ |c|/|D| from −8 to 0. Up: log₁₀ of the distance from the silhouette, in sizes, from −7 to −1.
fn level(across: f64, up: f64, rng: &mut ChaCha8Rng) -> (Outline, Cast) {
    let vase = outline("vase");
    let slope = 10f64.powf(-8.0 + 8.0 * across).min(0.999_999);
    let off = 10f64.powf(-7.0 + 6.0 * up);
    // Towards the wall of the first segments, beside its edge as seen from the front: y = −2 … at x = r − off.
    let u: f64 = rng.random_range(0.2..0.8);
    let f = [0.04, 0.16, 0.2, 0.2];
    let v = 1.0 - u;
    let r = (f[0] * v * v * v + 3.0 * f[1] * v * v * u + 3.0 * f[2] * v * u * u + f[3] * u * u * u).sqrt();
    let z = 0.25 * u;
    let level = (1.0 - slope * slope).sqrt();
    let origin = [r - off, -2.0 * level, z - 2.0 * slope].map(|x| x as f32);
    let direction = [0.0, level as f32, slope as f32];
    (vase, Cast { origin, direction, t_min: 0.0 })
}

/// Across: log₁₀ of the camera's distance in sizes, from 0 to 4.5. Up: log₁₀ of the height of the solid, in sizes, from 0 to 4.5.
fn far(across: f64, up: f64, rng: &mut ChaCha8Rng) -> (Outline, Cast) {
    let vase = outline("vase");
    let height = (10f64.powf(4.5 * up) - 1.0) as f32;
    let vase = Outline { knots: vase.knots.iter().map(|knot| knot + height).collect(), ..vase };
    let distance = 10f64.powf(4.5 * across);
    let (turn, rise) = (rng.random_range(0.0..std::f64::consts::TAU), rng.random_range(-1.0..1.0f64));
    let level = (1.0 - rise * rise).sqrt();
    let direction = [level * turn.cos(), level * turn.sin(), rise];
    let middle = 0.5 * (f64::from(vase.knots[0]) + f64::from(vase.knots[4]));
    let mut at = |by: f64| rng.random_range(-by..by);
    let target = [at(0.3), at(0.3), middle + at(0.5)];
    let origin = std::array::from_fn(|i| (target[i] - distance * direction[i]) as f32);
    (vase, Cast { origin, direction: direction.map(|d| d as f32), t_min: 0.0 })
}

/// What an atlas shows, and what its axes mean: the ticks are powers of ten.
struct Atlas {
    file: &'static str,
    scene: Scene,
    across: (&'static str, [f64; 2]),
    up: (&'static str, [f64; 2]),
}

const LEVEL: Atlas = Atlas {
    file: "docs/atlas-level.png",
    scene: level,
    across: ("log10 of |c|/|D|: left is level", [-8.0, 0.0]),
    up: ("log10 of the distance from the silhouette, in sizes", [-7.0, -1.0]),
};

const FAR: Atlas = Atlas {
    file: "docs/atlas-far.png",
    scene: far,
    across: ("log10 of the camera's distance, in sizes", [0.0, 4.5]),
    up: ("log10 of the solid's height above the origin, in sizes", [0.0, 4.5]),
};

type Canvas = SimulatorDisplay<Rgb888>;

fn write_png(canvas: &Canvas, file: &str) -> Result<(), Box<dyn Error>> {
    canvas.to_rgb_output_image(&OutputSettings::default()).save_png(file)?;
    Ok(())
}

fn text(canvas: &mut Canvas, text: &str, x: i32, y: i32, alignment: Alignment) {
    let style = MonoTextStyle::new(&FONT_7X13, Rgb888::new(40, 40, 40));
    let Ok(_) = Text::with_alignment(text, Point::new(x, y), style, alignment).draw(canvas);
}

fn block(canvas: &mut Canvas, x: i32, y: i32, w: u32, h: u32, color: Rgb888) {
    let Ok(()) = canvas.fill_solid(&Rectangle::new(Point::new(x, y), Size::new(w, h)), color);
}

fn atlas(atlas: &Atlas) -> Result<(), Box<dyn Error>> {
    const LEFT: i32 = 44;
    const TOP: i32 = 42;
    const GAP: i32 = 18;
    const BELOW: i32 = 84;
    const SIDE: i32 = (CELLS * ZOOM) as i32;
    let methods = SHOWN.map(|i| METHODS[i].2);
    let (width, height) = (LEFT + 3 * SIDE + 3 * GAP, TOP + SIDE + BELOW);
    let mut canvas = Canvas::with_default_color(Size::new(width as u32, height as u32), Rgb888::WHITE);
    let bar = bar(u64::from(CELLS), atlas.file);
    for row in 0..CELLS {
        for column in 0..CELLS {
            let worst = cell(atlas.scene, &methods, column, row);
            for (i, units) in (0..).zip(worst) {
                let (x, y) = (LEFT + i * (SIDE + GAP), TOP + SIDE);
                let (x, y) = (x + (column * ZOOM) as i32, y - ((row + 1) * ZOOM) as i32);
                block(&mut canvas, x, y, ZOOM, ZOOM, color(units));
            }
        }
        bar.inc(1);
    }
    bar.finish();
    text(&mut canvas, &format!("up: {}", atlas.up.0), 4, 13, Alignment::Left);
    let ticks = |[from, to]: [f64; 2]| {
        let ticks = (from.ceil() as i32..=to.floor() as i32).filter(move |tick| tick % 2 == from as i32 % 2);
        ticks.map(move |tick| (tick, ((f64::from(tick) - from) / (to - from) * f64::from(SIDE)) as i32))
    };
    for (i, name) in (0..).zip(TITLES) {
        let x = LEFT + i * (SIDE + GAP);
        text(&mut canvas, name, x + SIDE / 2, TOP - 8, Alignment::Center);
        for (tick, along) in ticks(atlas.across.1) {
            text(&mut canvas, &tick.to_string(), x + along, TOP + SIDE + 15, Alignment::Center);
        }
    }
    for (tick, along) in ticks(atlas.up.1) {
        text(&mut canvas, &tick.to_string(), LEFT - 6, TOP + SIDE - along + 4, Alignment::Right);
    }
    text(&mut canvas, &format!("across: {}", atlas.across.0), 4, TOP + SIDE + 34, Alignment::Left);
    legend(&mut canvas, LEFT, TOP + SIDE + 46, 3 * SIDE + 2 * GAP);
    write_png(&canvas, atlas.file)
}

const TITLES: [&str; 3] = ["the paper's form", "sound form, textbook Cardano", "embedded-lathe"];

/// The colors, from 0.1 units to 10^6.5.
fn legend(canvas: &mut Canvas, left: i32, top: i32, width: i32) {
    let power = |x: i32| -1.0 + 7.5 * f64::from(x) / f64::from(width);
    for x in 0..width {
        block(canvas, left + x, top, 1, 12, color(10f64.powf(power(x))));
    }
    for tick in [0.1, 1.0, 16.0, 1e3, 1e4, 1e5, 1e6f64] {
        let x = ((tick.log10() + 1.0) / 7.5 * f64::from(width)) as i32;
        let name = if tick == 16.0 { "16 units".to_owned() } else { format!("{tick}") };
        text(canvas, &name, left + x, top + 27, Alignment::Center);
    }
}

fn cell(scene: Scene, methods: &[Nearest; 3], column: u32, row: u32) -> [f64; 3] {
    let mut worst = [0f64; 3];
    for ray in 0..RAYS {
        let mut rng = ChaCha8Rng::seed_from_u64(1995);
        rng.set_stream((u64::from(row) * u64::from(CELLS) + u64::from(column)) * RAYS + ray);
        let [across, up] =
            [column, row].map(|i| (f64::from(i) + rng.random_range(0.0..1.0)) / f64::from(CELLS));
        let (outline, cast) = scene(across, up, &mut rng);
        let truth = Truth::of(&outline, cast, outline.unit(cast.origin));
        for (worst, nearest) in worst.iter_mut().zip(methods) {
            *worst = worst.max(truth.judge(nearest(&outline, &cast)));
        }
    }
    worst
}

/// Blue at 0.1 units, white at 16, where an answer is called wrong, orange above, red at 10⁶, black beyond.
fn color(units: f64) -> Rgb888 {
    if !(units <= 1e6) {
        return Rgb888::new(20, 10, 10);
    }
    let limit = laboratory::DISPLACEMENT.log10();
    let power = units.max(0.1).log10();
    let mix = |from: [f64; 3], to: [f64; 3], share: f64| {
        let [r, g, b] = std::array::from_fn(|i| (from[i] + (to[i] - from[i]) * share) as u8);
        Rgb888::new(r, g, b)
    };
    let (blue, white, red) = ([40.0, 80.0, 160.0], [245.0, 245.0, 240.0], [190.0, 30.0, 20.0]);
    if power < limit {
        mix(blue, white, (power + 1.0) / (limit + 1.0))
    } else {
        let share = (power - limit) / (6.0 - limit);
        mix([250.0, 205.0, 120.0], red, share)
    }
}

/// The vase from its own height, by the paper's form and by the crate, lit alike.
fn eye_level(file: &str) -> Result<(), Box<dyn Error>> {
    const SIDE: u32 = 360;
    const GAP: u32 = 12;
    let vase = outline("vase");
    let camera = Camera::perspective([0.0, -2.2, 0.5], [0.0, 0.0, 0.5], [0.0, 0.0, 1.0], 0.28)?;
    let size = Size::new(2 * SIDE + GAP, SIDE);
    let mut canvas = Canvas::with_default_color(size, Rgb888::WHITE);
    for (i, (_, _, nearest)) in [METHODS[0], METHODS[3]].into_iter().enumerate() {
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            let ray = camera.ray(x, y, SIDE, SIDE);
            let origin = ray.origin();
            let end = ray.at(1.0);
            let direction = std::array::from_fn(|i| end[i] - origin[i]);
            let cast = Cast { origin, direction, t_min: 0.0 };
            let shade = nearest(&vase, &cast).and_then(|t| shade(&vase, &cast, t));
            let x = (i as u32 * (SIDE + GAP) + x) as i32;
            block(&mut canvas, x, y as i32, 1, 1, shade.unwrap_or(Rgb888::new(26, 36, 56)));
        }
    }
    write_png(&canvas, file)
}

/// Lambert's law at the point that a method names, wherever that may be.
fn shade(vase: &Outline, cast: &Cast, t: f32) -> Option<Rgb888> {
    let point: [f64; 3] =
        std::array::from_fn(|i| f64::from(cast.origin[i]) + f64::from(t) * f64::from(cast.direction[i]));
    let shape = vase.shape();
    let (segment, u) = shape.locate(point[2]);
    let normal = shape.wall_normal(segment, u, point);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let facing = if dot(normal, cast.direction.map(f64::from)) > 0.0 { -1.0 } else { 1.0 };
    let light = (facing * dot(normal, [-0.5, -0.7, 0.5]) / 0.99f64.sqrt()).max(0.0);
    let shade = 0.15 + 0.85 * light;
    let [r, g, b] = [217.0, 115.0, 77.0].map(|c| (c * shade) as u8);
    normal.iter().all(|n| n.is_finite()).then(|| Rgb888::new(r, g, b))
}
