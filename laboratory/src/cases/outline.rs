//! The solids under test.

use super::stepped_outlines;
use crate::oracle::Shape;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

/// A profile as it is handed to the kernel.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    pub name: &'static str,
    pub knots: Vec<f32>,
    /// Bernstein ordinates of the squared radius, shared at joins: 3n + 1, and one more for each knot that stands twice.
    pub ordinates: Vec<f32>,
    pub k: f32,
    /// Whether a cap closes an end. If not, the end is as knots and ordinates have it.
    pub base_closed: bool,
    pub top_closed: bool,
}

impl Outline {
    fn closed(name: &'static str, knots: &[f32], ordinates: &[f32]) -> Self {
        let (knots, ordinates) = (knots.to_vec(), ordinates.to_vec());
        Outline { name, knots, ordinates, k: 1.0, base_closed: true, top_closed: true }
    }

    fn open_top(self) -> Self {
        Outline { top_closed: false, ..self }
    }

    fn open_base(self) -> Self {
        Outline { base_closed: false, ..self }
    }

    fn squashed(self, name: &'static str, k: f32) -> Self {
        Outline { name, k, ..self }
    }

    fn lifted(mut self, name: &'static str, by: f32) -> Self {
        self.knots.iter_mut().for_each(|z| *z += by);
        Outline { name, ..self }
    }

    pub fn shape(&self) -> Shape {
        let wide = |values: &[f32]| values.iter().copied().map(f64::from).collect::<Vec<_>>();
        let shape = Shape::new(&wide(&self.knots), &wide(&self.ordinates), self.k.into());
        Shape {
            below: if self.base_closed { 0.0 } else { shape.below },
            above: if self.top_closed { 0.0 } else { shape.above },
            ..shape
        }
    }

    pub fn middle(&self) -> f64 {
        (f64::from(self.knots[0]) + f64::from(self.knots[self.knots.len() - 1])) / 2.0
    }

    pub fn size(&self) -> f64 {
        self.shape().size()
    }

    /// The unit in which a ray from this origin may be off.
    pub fn unit(&self, origin: [f32; 3]) -> f64 {
        self.shape().unit(origin.map(f64::from))
    }
}

pub fn outlines() -> Vec<Outline> {
    vec![
        vase(),
        vase().squashed("elliptic vase", 0.3),
        vase().squashed("nearly a sheet", 1e-3),
        vase().squashed("sheet", 0.0),
        vase().lifted("lifted vase", 1000.0),
        cylinder(),
        cylinder().open_top().open_base().squashed("pipe", 1.0),
        cone(),
        sphere(),
        sphere().squashed("ellipsoid", 0.5),
        paraboloid(),
        hyperboloid(),
        pawn(),
        bottle(),
        dome(),
        horn(),
        lantern(),
        wander(),
    ]
}

pub fn outline(name: &str) -> Outline {
    let found = outlines().into_iter().chain(stepped_outlines()).find(|outline| outline.name == name);
    found.expect(name)
}

/// Open at the top.
fn vase() -> Outline {
    let ordinates = [0.04, 0.16, 0.2, 0.2, 0.2, 0.12, 0.05, 0.0, 0.01, 0.03, 0.042, 0.06, 0.07];
    Outline::closed("vase", &[0.0, 0.25, 0.6, 0.85, 1.0], &ordinates).open_top()
}

/// Radius 1.
fn cylinder() -> Outline {
    Outline::closed("cylinder", &[0.0, 2.0], &[1.0; 4])
}

/// r = 1.5·(1 − u), its point up: f touches zero.
fn cone() -> Outline {
    Outline::closed("cone", &[0.0, 2.0], &[2.25, 0.75, 0.0, 0.0])
}

/// Radius 1.5 about the origin, exactly.
fn sphere() -> Outline {
    Outline::closed("sphere", &[-1.5, 1.5], &[0.0, 3.0, 3.0, 0.0])
}

/// f = 1.5·u, open at the top.
fn paraboloid() -> Outline {
    Outline::closed("paraboloid", &[0.0, 1.0], &[0.0, 0.5, 1.0, 1.5]).open_top()
}

/// f = 0.75 + z².
fn hyperboloid() -> Outline {
    Outline::closed("hyperboloid", &[-1.5, 1.5], &[3.0, 0.0, 0.0, 3.0])
}

/// A cylinder, a cone and most of a ball, each with no cubic term, to the last bit.
fn pawn() -> Outline {
    let [foot, neck] = [9.0 / 16.0, 9.0 / 256.0];
    let ordinates =
        [foot, foot, foot, foot, 18.0 / 64.0, 27.0 / 256.0, neck, 33.0 / 256.0, 30.0 / 256.0, 0.0];
    Outline::closed("pawn", &[0.0, 0.25, 1.25, 1.8125], &ordinates)
}

/// A neck of a twentieth of the body's radius.
fn bottle() -> Outline {
    let ordinates =
        [0.16, 0.25, 0.3, 0.25, 0.1875, 6.25e-4, 6.25e-4, 6.25e-4, 6.25e-4, 6.25e-4, 6.25e-4, 2e-3, 1e-2];
    Outline::closed("bottle", &[0.0, 0.4, 0.9, 1.3, 1.5], &ordinates).open_top()
}

/// A rounded pole: f leaves zero in proportion.
fn dome() -> Outline {
    Outline::closed("dome", &[0.0, 0.5, 1.25], &[0.3, 0.35, 0.45, 0.5, 0.575, 0.4, 0.0])
}

/// A conical pole: f leaves zero as a square, its radius in proportion. A true cubic, and the base is open.
fn horn() -> Outline {
    Outline::closed("horn", &[-0.5, 1.0], &[0.3, 0.5, 0.0, 0.0]).open_base()
}

/// Every join a crease.
fn lantern() -> Outline {
    let ordinates = [0.1, 0.2, 0.3, 0.4, 0.2, 0.1, 0.05, 0.2, 0.3, 0.4, 0.5, 0.2, 0.15];
    Outline::closed("lantern", &[0.0, 0.5, 0.75, 1.5, 1.75], &ordinates)
}

/// Sixteen random segments, the highest some thirty times the lowest, every other join smooth.
fn wander() -> Outline {
    let mut rng = ChaCha8Rng::seed_from_u64(16);
    let heights: [f32; 16] = std::array::from_fn(|_| 0.01 * rng.random_range(0.0_f32..3.4).exp());
    let mut knots = vec![0.0_f32];
    let mut ordinates = vec![rng.random_range(0.01_f32..0.4)];
    for (i, h) in heights.into_iter().enumerate() {
        knots.push(knots[i] + h);
        let at = ordinates[3 * i];
        ordinates.extend([0; 3].map(|_| rng.random_range(0.01_f32..0.4)));
        if i > 0 && i % 2 == 0 {
            // The same slope in height on both sides, if that leaves a radius.
            ordinates[3 * i + 1] = (at + (at - ordinates[3 * i - 1]) * h / heights[i - 1]).max(0.0);
        }
    }
    Outline::closed("wander", &knots, &ordinates)
}
