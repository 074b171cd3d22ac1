//! The ray, seen from its own point nearest to the solid.

use super::shape::Shape;

/// `origin + t·direction`, `t > t_min`; t in units of the direction as given.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: [f64; 3],
    pub direction: [f64; 3],
    pub t_min: f64,
}

/// The ray's line with its origin moved to `t = t0`, about where `k·x² + y² + (z − middle)²` is least. The move loses
/// nothing: t0 is just some f64, and `origin + t0·direction` is summed exactly before it is rounded once.
pub struct Line {
    pub near: [f64; 3],
    pub direction: [f64; 3],
    pub t0: f64,
    k: f64,
}

impl Line {
    pub fn new(shape: &Shape, ray: &Ray) -> Self {
        let [a, b, c] = ray.direction;
        let [x, y, z] = ray.origin;
        let squared = shape.k * a * a + b * b + c * c;
        let along = shape.k * a * x + b * y + c * (z - shape.middle());
        let t0 = if squared > 0.0 { -along / squared } else { 0.0 };
        let near = std::array::from_fn(|i| sum_of_product(ray.origin[i], t0, ray.direction[i]));
        Line { near, direction: ray.direction, t0, k: shape.k }
    }

    pub fn point(&self, s: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.near[i] + s * self.direction[i])
    }

    /// `k·x² + y²` at s.
    pub fn squared_distance(&self, s: f64) -> f64 {
        let [x, y, _] = self.point(s);
        self.k * x * x + y * y
    }

    /// The parameter at a height; the line must not be horizontal.
    pub fn at_height(&self, z: f64) -> f64 {
        (z - self.near[2]) / self.direction[2]
    }

    pub fn horizontal(&self) -> bool {
        self.direction[2] == 0.0
    }

    /// Where the line is within `k·x² + y² ≤ radius²`: all of it (infinite ends), some, or none.
    pub fn within(&self, radius: f64) -> Option<[f64; 2]> {
        let ([x, y, _], [a, b, _]) = (self.near, self.direction);
        let q = self.k * a * a + b * b;
        let p = self.k * a * x + b * y;
        let e = self.k * x * x + y * y - radius * radius;
        if q == 0.0 {
            return (e <= 0.0).then_some([f64::NEG_INFINITY, f64::INFINITY]);
        }
        let under = p * p - q * e;
        if under < 0.0 {
            return None;
        }
        let root = under.sqrt();
        let far = if p > 0.0 { -p - root } else { -p + root };
        let (s, other) = (far / q, if far == 0.0 { 0.0 } else { e / far });
        Some([s.min(other), s.max(other)])
    }
}

/// `a + b·c`, rounded once but for a last bit of the smallest part.
fn sum_of_product(a: f64, b: f64, c: f64) -> f64 {
    let product = b * c;
    let lost = b.mul_add(c, -product);
    let sum = a + product;
    let part = sum - a;
    let rest = (a - (sum - part)) + (product - part);
    sum + (rest + lost)
}
