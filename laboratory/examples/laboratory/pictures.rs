//! Whole pictures of the reference vase: cost against accuracy, for every way through the crate, and for other
//! renderers beside it.
//!
//! The crate's costs are the record's, docs/instructions.csv; its pictures are computed here and judged by the oracle.
//! The other renderers were measured once, and no command here repeats that: their figures stand below.

#[allow(dead_code)]
#[path = "../../../examples/scenes/mod.rs"]
mod scenes;

use crate::csv::{CYCLES, INSTRUCTIONS, recorded};
use crate::plot::{self, Axis, Panel, Point};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_lathe::math::{Libm, Micromath, Native};
use embedded_lathe::solve::{Cardano, Solver, Split};
use embedded_lathe::{Hit, Paint, Ray, Rgb};
use laboratory::oracle::{self, Shape};
use plotters::style::RGBColor;
use scenes::{CLAY, VASE, VASE_KNOTS, VASE_ORDINATES, VASE_SCENE, lambert};
use std::error::Error;
use std::fmt::Write;

/// The background of the vase's scene.
const BACKGROUND: Rgb = Rgb::new(0.10, 0.14, 0.22);

type Size = (u32, u32);
const TFT: Size = (240, 240);
const OLED: Size = (128, 64);

/// How far a picture is from the exact one.
#[derive(Clone, Copy)]
struct Accuracy {
    /// Pixels that show the solid and should not, or the other way round.
    mask: u32,
    /// The root of the mean square of what a channel is off by, in 255ths, where both pictures show the solid.
    color: f64,
}

/// A way through the crate: its name, that of its line in the record, and the picture that it makes.
#[derive(Clone, Copy)]
struct Way {
    name: &'static str,
    line: &'static str,
    picture: fn(Size) -> Vec<Option<Rgb565>>,
}

/// Rows as a machine with a floating-point unit computes them, and as one without.
const IN_FLOATS: Way = Way { name: "rows", line: "vase", picture: in_floats };
const IN_INTEGERS: Way = Way { name: "rows, in integers", line: "vase", picture: in_integers };

/// Single rays, which every machine computes in floats.
const RAYS: [Way; 7] = [
    Way {
        name: "rays",
        line: "vase by rays default",
        picture: |size| by_rays(size, |ray| VASE.nearest(ray, 0.0)),
    },
    Way { name: "rays, split, native", line: "vase by rays split native", picture: by::<Split<Native>> },
    Way { name: "rays, split, libm", line: "vase by rays split libm", picture: by::<Split<Libm>> },
    Way {
        name: "rays, split, micromath",
        line: "vase by rays split micromath",
        picture: by::<Split<Micromath>>,
    },
    Way {
        name: "rays, Cardano, native",
        line: "vase by rays cardano native",
        picture: by::<Cardano<Native>>,
    },
    Way { name: "rays, Cardano, libm", line: "vase by rays cardano libm", picture: by::<Cardano<Libm>> },
    Way {
        name: "rays, Cardano, micromath",
        line: "vase by rays cardano micromath",
        picture: by::<Cardano<Micromath>>,
    },
];

/// Another renderer at the same picture, measured once: on 240×240 pixels in Rgb565 in cycles of a Cortex-M4F, by the
/// estimate of examples/bench/m4cycles.c, or on 128×64 pixels in instructions of a Cortex-M3. The name says how many
/// facets the vase's mesh has around and along; its vertices have exact normals; the sphere tracer evaluates the same cubics. Of the color
/// the peak signal-to-noise ratio was measured, in decibels.
struct Peer {
    name: &'static str,
    cost: f64,
    mask: u32,
    decibels: f64,
}

const fn peer(name: &'static str, cost: f64, mask: u32, decibels: f64) -> Peer {
    Peer { name, cost, mask, decibels }
}

/// tgx, small3dlib and the sphere tracer by arm-none-eabi-gcc 12.2 -O3, embedded-3dgfx 0.7.2 by Rust 1.95, in November 2026.
/// All but the sphere tracer need a framebuffer and most a depth buffer: 116 to 591 KB of RAM.
const ON_M4F: [Peer; 8] = [
    peer("tgx 32×16", 32.3, 189, 33.7),
    peer("tgx 64×32", 71.5, 44, 35.3),
    peer("tgx 128×64", 211.0, 12, 35.7),
    peer("small3dlib 32×16", 57.6, 454, 36.4),
    peer("small3dlib 64×32", 112.0, 336, 38.5),
    peer("embedded-3dgfx 32×16", 136.0, 309, 28.2),
    peer("embedded-3dgfx 64×32", 294.0, 325, 30.1),
    peer("sphere tracer, ε = 5e-4", 852.0, 64, 42.0),
];

const ON_M3: [Peer; 4] = [
    peer("small3dlib 32×16", 111.7, 117, 35.7),
    peer("small3dlib 64×32", 316.3, 84, 37.8),
    peer("tgx 32×16", 663.3, 35, 30.3),
    peer("tgx 64×32", 2283.6, 13, 31.9),
];

const CRATE: RGBColor = RGBColor(200, 60, 30);
const OTHER: RGBColor = RGBColor(50, 90, 150);

pub fn write() -> Result<(), Box<dyn Error>> {
    let mut table = "machine,renderer,cost,mask,color\n".to_owned();
    let mut judged = |machine: &str,
                      rows: Way,
                      column: usize,
                      size: Size,
                      peers: &[Peer]|
     -> Result<Vec<Judged>, Box<dyn Error>> {
        let exact = exact(size);
        let mut all = Vec::new();
        for way in [rows].iter().chain(&RAYS) {
            let accuracy = accuracy(&(way.picture)(size), &exact);
            all.push(Judged {
                name: way.name.to_owned(),
                is_ours: true,
                cost: recorded(machine, way.line, column)?,
                accuracy,
            });
        }
        all.extend(peers.iter().map(|&Peer { name, cost, mask, decibels }| {
            let color = 255.0 / 10f64.powf(decibels / 20.0);
            Judged { name: name.to_owned(), is_ours: false, cost, accuracy: Accuracy { mask, color } }
        }));
        for Judged { name, cost, accuracy: Accuracy { mask, color }, .. } in &all {
            writeln!(table, "{machine},\"{name}\",{cost:.1},{mask},{color:.2}")?;
        }
        Ok(all)
    };
    let (m4f, m3) = (
        judged("m4f", IN_FLOATS, CYCLES, TFT, &ON_M4F)?,
        judged("m3", IN_INTEGERS, INSTRUCTIONS, OLED, &ON_M3)?,
    );
    std::fs::write("docs/pictures.csv", table)?;
    let mask = |all: &[Judged]| all.iter().map(|judged| judged.point(judged.accuracy.mask.into())).collect();
    let wrong = |pixels: u32| Axis {
        title: format!("wrong pixels of the mask, of {pixels}"),
        range: 1.0..1000.0,
        has_none: true,
    };
    plot::draw(
        "docs/pictures.svg",
        &[
            Panel {
                title: "The vase on a Cortex-M4F, 240×240: the mask",
                across: "cycles a pixel".to_owned(),
                up: wrong(57_600),
                points: mask(&m4f),
            },
            Panel {
                title: "The same picture: the color",
                across: "cycles a pixel".to_owned(),
                up: Axis {
                    title: "error of a channel in 255ths, root mean square".to_owned(),
                    range: 1.0..20.0,
                    has_none: false,
                },
                points: m4f.iter().map(|judged| judged.point(judged.accuracy.color)).collect(),
            },
            Panel {
                title: "The vase on a Cortex-M3, without floating-point hardware, 128×64: the mask",
                across: "instructions a pixel".to_owned(),
                up: wrong(8192),
                points: mask(&m3),
            },
        ],
    )
}

struct Judged {
    name: String,
    is_ours: bool,
    cost: f64,
    accuracy: Accuracy,
}

impl Judged {
    fn point(&self, error: f64) -> Point {
        let color = if self.is_ours { CRATE } else { OTHER };
        Point { label: self.name.clone(), color, cost: self.cost, error }
    }
}

/// The rays of a picture's pixels, row by row.
fn pixels((width, height): Size) -> impl Iterator<Item = (u32, u32, Ray)> {
    (0..height)
        .flat_map(move |y| (0..width).map(move |x| (x, y)))
        .map(move |(x, y)| (x, y, VASE_SCENE.camera.ray(x, y, width, height)))
}

/// The exact color of every pixel, in units of the brightest, or `None` where the vase is not seen.
fn exact(size: Size) -> Vec<Option<[f64; 3]>> {
    let mut shape = Shape::new(&VASE_KNOTS.map(f64::from), &VASE_ORDINATES.map(f64::from), 1.0).opened();
    shape.below = 0.0;
    let (towards, ambient) =
        (VASE_SCENE.light.towards().map(f64::from), f64::from(VASE_SCENE.light.ambient()));
    let clay = [CLAY.r, CLAY.g, CLAY.b].map(f64::from);
    let color = |(_, _, ray): (u32, u32, Ray)| {
        let [origin, direction] = [ray.origin(), ray.direction()].map(|v| v.map(f64::from));
        let crossings = oracle::crossings(&shape, &oracle::Ray { origin, direction, t_min: 0.0 });
        let first = crossings.first()?;
        let side = if first.enters { 1.0 } else { -1.0 };
        let cosine: f64 = (0..3).map(|i| side * first.normal[i] * towards[i]).sum();
        Some(clay.map(|channel| channel * (ambient + (1.0 - ambient) * cosine.max(0.0))))
    };
    pixels(size).map(color).collect()
}

fn accuracy(picture: &[Option<Rgb565>], exact: &[Option<[f64; 3]>]) -> Accuracy {
    let (mut mask, mut sum, mut count) = (0, 0.0, 0.0);
    for (color, exact) in picture.iter().zip(exact) {
        match (color, exact) {
            (Some(color), Some(exact)) => {
                let shown = [(color.r(), 31.0), (color.g(), 63.0), (color.b(), 31.0)];
                for ((shade, most), exact) in shown.into_iter().zip(exact) {
                    sum += (255.0 * (f64::from(shade) / most - exact)).powi(2);
                    count += 1.0;
                }
            }
            (None, None) => {}
            _ => mask += 1,
        }
    }
    Accuracy { mask, color: (sum / count).sqrt() }
}

/// The picture by rows, given what writes a row. A pixel that has the background's color does not show the vase: no point of
/// the vase has it.
fn by_rows((width, height): Size, row: impl Fn(u32, &mut [Rgb565])) -> Vec<Option<Rgb565>> {
    let mut colors = vec![Rgb565::BLACK; (width * height) as usize];
    colors.chunks_mut(width as usize).zip(0..).for_each(|(pixels, y)| row(y, pixels));
    let background: Rgb565 = Paint::paint(BACKGROUND, 0, 0);
    colors.into_iter().map(|color| (color != background).then_some(color)).collect()
}

fn in_floats(size: Size) -> Vec<Option<Rgb565>> {
    let picture = VASE_SCENE.picture(size.0, size.1);
    by_rows(size, |y, row| picture.row(y, row))
}

/// The same scene in the crate as it is built for machines without a floating-point unit.
fn in_integers(size: Size) -> Vec<Option<Rgb565>> {
    use embedded_lathe_integers::{
        Background, Camera, End, Lathe, Light, Profile, Rgb, Scene, Segment, Solid, valid,
    };

    static VASE: Lathe<[Segment; 4]> =
        Lathe::turn(valid!(Profile::from_squared_radii(&VASE_KNOTS, &VASE_ORDINATES)).base(End::Capped));
    static SCENE: Scene = Scene::new(
        &[Solid::new(&VASE, Rgb::new(CLAY.r, CLAY.g, CLAY.b))],
        valid!(Camera::perspective([0.0, -2.2, 0.9], [0.0, 0.0, 0.5], [0.0, 0.0, 1.0], 0.3)),
        valid!(Light::new([-0.5, -0.7, 0.5], 0.15)),
    )
    .with_background(Background::Plain(Rgb::new(BACKGROUND.r, BACKGROUND.g, BACKGROUND.b)));

    let picture = SCENE.picture(size.0, size.1);
    by_rows(size, |y, row| picture.row(y, row))
}

fn by<S: Solver>(size: Size) -> Vec<Option<Rgb565>> {
    by_rays(size, |ray| VASE.nearest_by::<S>(ray, 0.0))
}

/// The picture by single rays, each lit by Lambert's law.
fn by_rays(size: Size, nearest: impl Fn(&Ray) -> Option<Hit>) -> Vec<Option<Rgb565>> {
    let color = |(x, y, ray): (u32, u32, Ray)| Some(Paint::paint(lambert::seen(&ray, &nearest)?, x, y));
    pixels(size).map(color).collect()
}
