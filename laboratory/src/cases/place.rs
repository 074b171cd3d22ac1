//! Random places and directions about one outline, in f64; rounding to f32 comes last.

use super::Outline;
use crate::oracle::{Ray, Shape, crossings, value};
use rand::RngExt;
use rand::rngs::ChaCha8Rng;
use std::f64::consts::TAU;

pub type Vector = [f64; 3];

pub fn along(p: Vector, t: f64, d: Vector) -> Vector {
    std::array::from_fn(|i| p[i] + t * d[i])
}

pub fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub fn unit(v: Vector) -> Vector {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

pub struct Place {
    pub shape: Shape,
    pub size: f64,
    rng: ChaCha8Rng,
}

impl Place {
    pub fn new(outline: &Outline, rng: ChaCha8Rng) -> Self {
        let shape = outline.shape();
        Place { size: shape.size(), shape, rng }
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.rng.random_range(low..=high)
    }

    /// Every power of ten as likely as the next.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    pub fn sign(&mut self) -> f64 {
        if self.rng.random() { 1.0 } else { -1.0 }
    }

    pub fn pick(&mut self, count: usize) -> usize {
        self.rng.random_range(0..count)
    }

    pub fn knot(&mut self) -> usize {
        self.pick(self.shape.knots.len())
    }

    pub fn direction(&mut self) -> Vector {
        let (z, turn) = (self.between(-1.0, 1.0), self.between(0.0, TAU));
        let r = (1.0 - z * z).sqrt();
        [r * turn.cos(), r * turn.sin(), z]
    }

    pub fn level_direction(&mut self) -> Vector {
        let turn = self.between(0.0, TAU);
        [turn.cos(), turn.sin(), 0.0]
    }

    /// In the box about the solid and a little beyond, or, where x is squashed far, in a part of it.
    pub fn target(&mut self) -> Vector {
        let (wide, reach) = (1.2 * self.shape.widest(), 1.2 * self.reach());
        let x = self.between(-reach, reach);
        let y = self.between(-wide, wide);
        [x, y, self.height()]
    }

    pub fn height(&mut self) -> f64 {
        let margin = 0.1 * (self.shape.top() - self.shape.base());
        self.between(self.shape.base() - margin, self.shape.top() + margin)
    }

    /// How far the solid goes along x, or a few sizes if it goes farther.
    pub fn reach(&self) -> f64 {
        (self.shape.widest() / self.shape.k.sqrt()).min(2.0 * self.size)
    }

    /// On the wall, or, scaled by less than 1, inside.
    pub fn on_ring(&mut self, z: f64, scale: f64) -> Vector {
        let (segment, u) = self.shape.locate(z);
        let f = self.shape.squared_radius(segment);
        self.on_circle(z, scale * value(f, u).max(0.0).sqrt())
    }

    /// On the circle, or ellipse, where the wall ends or changes at a knot; at a step on one of two.
    pub fn on_rim(&mut self, knot: usize) -> Vector {
        let z = self.shape.knots[knot];
        match self.shape.radii(knot) {
            [below, above] if below > 0.0 && above > 0.0 && below != above => {
                let square = if self.pick(2) == 0 { below } else { above };
                self.on_circle(z, square.sqrt())
            }
            _ => self.on_ring(z, 1.0),
        }
    }

    fn on_circle(&mut self, z: f64, r: f64) -> Vector {
        let reach = self.reach();
        let turn = self.between(0.0, TAU);
        let x = (r * turn.cos() / self.shape.k.sqrt()).abs().min(self.between(0.0, reach));
        let y = (r * r - self.shape.k * x * x).max(0.0).sqrt();
        [self.sign() * x, self.sign() * y, z]
    }

    /// A point of the wall, and the normal there.
    pub fn on_wall(&mut self) -> (Vector, Vector) {
        let z = self.between(self.shape.base(), self.shape.top());
        let point = self.on_ring(z, 1.0);
        let (segment, u) = self.shape.locate(z);
        (point, self.shape.wall_normal(segment, u, point))
    }

    /// Where some ray crosses the surface.
    pub fn on_surface(&mut self) -> Vector {
        for _ in 0..1000 {
            let direction = self.direction();
            let origin = along(self.target(), -3.0 * self.size, direction);
            let list = crossings(&self.shape, &Ray { origin, direction, t_min: 0.0 });
            if !list.is_empty() {
                return list[self.pick(list.len())].point;
            }
        }
        panic!("no ray crosses {:?}", self.shape)
    }
}
