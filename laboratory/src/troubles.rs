//! Rays at which intersections fail, by trouble: which outlines, met by which kinds of rays.

use super::families::Question;
use super::forms;
use super::{ROUNDOFF, TOUCHING};
use crate::cases::{Case, Family, Outline, case, outline, outlines};
use rand::RngExt;
use rand::rngs::ChaCha8Rng;
use std::sync::OnceLock;

pub struct Trouble {
    pub name: &'static str,
    /// By how much the squared radius may be off: nothing, unless it touches zero inside a segment.
    pub doubt: f64,
    outlines: Vec<Outline>,
    families: &'static [Family],
}

impl Trouble {
    /// The same ray for the same seed and index. Outlines and kinds of rays take turns.
    pub fn case(&self, seed: u64, index: u64) -> Case<'_> {
        let turn = index as usize;
        let outline = &self.outlines[turn % self.outlines.len()];
        let family = self.families[turn / self.outlines.len() % self.families.len()];
        case(outline, family, seed, index)
    }

    pub fn all() -> &'static [Self] {
        static ALL: OnceLock<Vec<Trouble>> = OnceLock::new();
        ALL.get_or_init(all)
    }
}

fn all() -> Vec<Trouble> {
    use Family::*;
    let named = |names: &[&str]| names.iter().map(|name| outline(name)).collect::<Vec<_>>();
    let trouble = |name, outlines, families| Trouble { name, doubt: 0.0, outlines, families };
    // At its middle, u = 1/2, Σ bⱼ·Bⱼ(u) is half of the largest ordinate, 1/4.
    let waist = TOUCHING * ROUNDOFF / 8.0;
    vec![
        trouble("all around", outlines(), &[Random, Camera, Inside, Unnormalised, ThroughAxis]),
        trouble("silhouettes", outlines(), &[Grazing]),
        trouble("near-horizontal", outlines(), &[NearHorizontal]),
        trouble("horizontal and upright", outlines(), &[Horizontal, Vertical, AxisParallel]),
        trouble("far cameras", outlines(), &[Far]),
        trouble("high solids", lifted(), &[Random, Camera, Grazing]),
        trouble("tiny and huge solids", scaled(), &[Random, Camera, Grazing]),
        trouble("poles", named(&["sphere", "dome", "cone", "horn"]), &[Rims, ThroughAxis, Vertical]),
        trouble("rims", named(&["vase", "cylinder", "paraboloid", "lantern"]), &[Rims]),
        trouble("joins", named(&["vase", "pawn", "lantern", "wander"]), &[Horizontal, Rims, Camera]),
        trouble("towards a sheet", sheets(), &[Random, NearHorizontal, Grazing]),
        trouble("thin necks", vec![outline("bottle"), neck()], &[Random, Grazing, Rims]),
        Trouble {
            doubt: waist,
            ..trouble(
                "touching the axis",
                vec![touching()],
                &[Random, NearHorizontal, Horizontal, ThroughAxis],
            )
        },
        trouble("leaving the surface", outlines(), &[FromSurface]),
    ]
}

/// The vase at heights up to 10 000.
fn lifted() -> Vec<Outline> {
    [10.0, 100.0, 1e3, 1e4].map(|by| changed("vase", |knot| knot + by, |f| f)).to_vec()
}

/// The vase from a billionth to a billion of its size.
fn scaled() -> Vec<Outline> {
    let one = |by: f32| changed("vase", move |knot| knot * by, move |f| f * by * by);
    [1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9].map(one).to_vec()
}

/// The vase stretched along x, at last without end.
fn sheets() -> Vec<Outline> {
    let one = |k| Outline { k, ..outline("vase") };
    [0.1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0].map(one).to_vec()
}

/// A neck of a thousandth of the body's radius.
fn neck() -> Outline {
    let body = outline("bottle");
    Outline {
        name: "very thin neck",
        ordinates: body.ordinates.iter().map(|&f| if f < 1e-2 { 2.5e-7 } else { f }).collect(),
        ..body
    }
}

/// f = (2u − 1)²/4: two cones whose points meet in the middle of a segment.
fn touching() -> Outline {
    Outline {
        name: "hourglass",
        knots: vec![0.0, 1.0],
        ordinates: vec![0.25, -0.083_333_336, -0.083_333_336, 0.25],
        ..outline("cylinder")
    }
}

fn changed(name: &str, knot: impl Fn(f32) -> f32, square: impl Fn(f32) -> f32) -> Outline {
    let Outline { knots, ordinates, .. } = outline(name);
    Outline {
        knots: knots.into_iter().map(knot).collect(),
        ordinates: ordinates.into_iter().map(square).collect(),
        ..outline(name)
    }
}

/// The cubic of some ray along a chord of a reference outline, soundly formed.
pub fn chord(rng: &mut ChaCha8Rng, silhouette: bool) -> Question {
    static OUTLINES: OnceLock<Vec<Outline>> = OnceLock::new();
    let outlines = OUTLINES.get_or_init(outlines);
    loop {
        let outline = &outlines[rng.random_range(0..outlines.len())];
        let family =
            if silhouette { Family::Grazing } else { Family::ALL[rng.random_range(0..Family::ALL.len())] };
        let cast = case(outline, family, rng.random(), 0).cast;
        let chords = forms::chords(outline, &cast);
        if chords.is_empty() {
            continue;
        }
        let question = Question { c: chords[rng.random_range(0..chords.len())].c, lo: 0.0, hi: 1.0 };
        if !silhouette || grazes(&question) {
            return question;
        }
    }
}

/// g has a turning point on the chord, and is small there.
fn grazes(question: &Question) -> bool {
    let [c0, c1, c2, c3] = question.c.map(f64::from);
    (0..=64).any(|i| {
        let u = f64::from(i) / 64.0;
        let value = ((c3 * u + c2) * u + c1) * u + c0;
        let slope = (3.0 * c3 * u + 2.0 * c2) * u + c1;
        let bend = 3.0 * c3 * u + c2;
        let step = -slope / (2.0 * bend);
        step.abs() < 1.0 / 64.0 && (value - bend * step * step).abs() < 1e-3 * (c0.abs() + c1.abs())
    })
}
