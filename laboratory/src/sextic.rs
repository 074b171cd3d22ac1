//! What the paper improves on: a profile whose radius and height are general cubics, `(r(u), z(u))`, meets a ray where a sextic vanishes.
//!
//! `c²·r(u)² − k·(c·x + a·ζ)² − (c·y + b·ζ)² = 0`, ζ = z(u) − z₀ the height over the ray's origin: the ray's parameter eliminated, multiplied by c².

use super::families::Question;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

/// The same ray, and much the same profile, as a cubic in squared radius and as a sextic.
pub struct Pair {
    pub cubic: Question,
    pub sextic: [f32; 7],
}

/// A segment from z = 0 to 1, with radii r at equal heights: the sextic's profile has those for ordinates; the cubic's passes through the same radii at 0, 1/3, 2/3 and 1.
pub fn pair(seed: u64, index: u64) -> Pair {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(index);
    let r: [f64; 4] = std::array::from_fn(|_| rng.random_range(0.2..0.8));
    let steep = [rng.random_range(0.2..0.45), rng.random_range(0.55..0.8)];
    let heights = powers([0.0, steep[0], steep[1], 1.0]);
    let radius = powers(r);
    let (x, y, z) = (rng.random_range(-0.5..0.5), -2.0, rng.random_range(-0.3..1.3));
    let (a, b) = (rng.random_range(-0.2..0.2), 1.0);
    let aim = rng.random_range(0.0..1.0);
    let c = (aim - z) / 2.0;
    let height = add([&heights, &[-z]]);
    let across = |c: f64, at: f64, d: f64| add([&height.map(|h| h * d), &[c * at]]);
    let squares = [
        square(&radius.map(|r| c * r)),
        square(&across(c, x, a)).map(|s| -s),
        square(&across(c, y, b)).map(|s| -s),
    ];
    let sextic = std::array::from_fn(|j| squares.iter().map(|s| s[j]).sum::<f64>() as f32);
    let f = powers(through([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(|u| at(&radius, u).powi(2))));
    let linear = [-z, 1.0, 0.0, 0.0];
    let along = |c: f64, at: f64, d: f64| [c * at + d * linear[0], d * linear[1]];
    let minus = [along(c, x, a), along(c, y, b)].map(|[p, q]| [p * p, 2.0 * p * q, q * q]);
    let cubic = std::array::from_fn(|j| {
        let lost: f64 = minus.iter().filter_map(|m| m.get(j)).sum();
        (c * c * f[j] - lost) as f32
    });
    let cubic = Question { c: cubic, lo: 0.0, hi: 1.0 };
    Pair { cubic, sextic }
}

fn powers([b0, b1, b2, b3]: [f64; 4]) -> [f64; 4] {
    [b0, 3.0 * (b1 - b0), 3.0 * (b2 - 2.0 * b1 + b0), b3 - 3.0 * b2 + 3.0 * b1 - b0]
}

/// The ordinates of the cubic with these values at 0, 1/3, 2/3, 1.
fn through([v0, v1, v2, v3]: [f64; 4]) -> [f64; 4] {
    [
        v0,
        (18.0 * v1 - 5.0 * v0 - 9.0 * v2 + 2.0 * v3) / 6.0,
        (18.0 * v2 - 5.0 * v3 - 9.0 * v1 + 2.0 * v0) / 6.0,
        v3,
    ]
}

fn at(c: &[f64], u: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * u + c)
}

fn add(of: [&[f64]; 2]) -> [f64; 4] {
    std::array::from_fn(|j| of.iter().filter_map(|c| c.get(j)).sum())
}

fn square(c: &[f64; 4]) -> [f64; 7] {
    let mut square = [0.0; 7];
    for (i, p) in c.iter().enumerate() {
        for (j, q) in c.iter().enumerate() {
            square[i + j] += p * q;
        }
    }
    square
}
