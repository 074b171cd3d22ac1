//! Cubics on which methods fail, by family. Seeded; each family says what makes a cubic its own, and the stability tests count.

use super::judge::Truth;
use super::troubles;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

/// A question: the first root of `Σ c[j]·uʲ` in [lo, hi].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Question {
    pub c: [f32; 4],
    pub lo: f32,
    pub hi: f32,
}

impl Question {
    /// Of the cubic with these roots and this leading coefficient, computed in f64 and rounded to f32.
    pub fn with_roots(roots: [f64; 3], lead: f64, lo: f64, hi: f64) -> Self {
        question(from_roots(roots, lead), lo, hi)
    }
}

pub struct Family {
    pub name: &'static str,
    make: fn(&mut ChaCha8Rng) -> Question,
    /// How many kinds of questions the family is to have.
    pub kinds: usize,
    /// Which of them a question is, from 0 on; none if it is not what the family is called.
    pub kind: fn(&Question, &Truth) -> Option<usize>,
}

impl Family {
    /// The same question for the same seed and index, each reproducible alone.
    pub fn question(&self, seed: u64, index: u64) -> Question {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(index);
        (self.make)(&mut rng)
    }
}

pub const FAMILIES: &[Family] = &[
    Family {
        name: "well separated",
        make: |rng| {
            let roots = [-0.9, -0.1, 0.6].map(|r| r + rng.random_range(0.0..0.3));
            question(from_roots(roots, signed(rng)), -1.0, 1.0)
        },
        kinds: 1,
        kind: |_, truth| only(truth.roots.len() == 3),
    },
    Family {
        name: "near-double, gaps 1e-1 to 1e-7",
        make: |rng| {
            let (r, gap) = (rng.random_range(0.05..0.95), magnitude(rng, 1e-7, 1e-1));
            let other = rng.random_range(-3.0..3.0);
            question(from_roots([r, r + gap, other], signed(rng)), 0.0, 1.0)
        },
        kinds: 1,
        kind: |question, truth| only(gap(truth) < 0.11 || nearly_double(question)),
    },
    Family {
        name: "near-triple, gaps 1e-1 to 1e-7",
        make: |rng| {
            let r = rng.random_range(0.15..0.85);
            let [p, q] = [(); 2].map(|()| r + sign(rng) * magnitude(rng, 1e-7, 1e-1));
            question(from_roots([r, p, q], signed(rng)), 0.0, 1.0)
        },
        kinds: 1,
        kind: |question, _| only(nearly_double(question) && nearly_flat(question)),
    },
    Family {
        name: "c3/c2 from 1e-1 to 1e-12",
        make: |rng| {
            let [c0, c1, c2] = [(); 3].map(|()| signed(rng));
            let c3 = c2 * sign(rng) * magnitude(rng, 1e-12, 1e-1);
            question([c0, c1, c2, c3], 0.0, 1.0)
        },
        // The ratio's decade.
        kinds: 11,
        kind: |question, _| decade(question.c[3] / question.c[2], -12, -1),
    },
    Family {
        name: "c3 = 0",
        make: |rng| {
            let [c0, c1, c2] = [(); 3].map(|()| signed(rng));
            question([c0, c1, c2, 0.0], 0.0, 1.0)
        },
        // Without a root, and with some.
        kinds: 2,
        kind: |question, truth| (question.c[3] == 0.0).then_some(truth.roots.len().min(1)),
    },
    Family {
        name: "c3 and c2 vanishing",
        make: |rng| {
            let [c0, c1] = [(); 2].map(|()| signed(rng));
            let mut small = || match rng.random_range(0..4) {
                0 => 0.0,
                _ => signed(rng) * magnitude(rng, 1e-12, 1e-1),
            };
            question([c0, c1, small(), small()], 0.0, 1.0)
        },
        // Neither is zero, one is, both are.
        kinds: 3,
        kind: |question, _| {
            let [.., c2, c3] = question.c;
            (c2.abs().max(c3.abs()) < 0.11).then_some([c2, c3].iter().filter(|c| **c == 0.0).count())
        },
    },
    Family {
        name: "roots over six decades",
        make: |rng| {
            let roots = [(); 3].map(|()| sign(rng) * magnitude(rng, 1e-3, 1e3));
            question(from_roots(roots, 1.0), -1100.0, 1100.0)
        },
        // The first root's decade.
        kinds: 6,
        kind: |_, truth| truth.roots.first().and_then(|root| decade(*root as f32, -3, 3)),
    },
    Family {
        name: "scaled by 2^-110 to 2^110",
        make: |rng| {
            let roots = [(); 3].map(|()| signed(rng));
            let power = f64::from(rng.random_range(-110..=110)).exp2();
            question(from_roots(roots, power), -1.0, 1.0)
        },
        // Small and large.
        kinds: 2,
        kind: |question, _| {
            let lead = question.c[3];
            (!(1e-2..1e2).contains(&lead)).then_some(usize::from(lead > 1.0))
        },
    },
    Family {
        name: "roots on the interval's ends",
        make: |rng| {
            let [p, q] = [(); 2].map(|()| 2.0 * signed(rng));
            let end = 0.5 + f64::from(rng.random_range(0..2));
            question(from_roots([end, p, q], signed(rng)), 0.5, 1.5)
        },
        // The lower end, and the upper.
        kinds: 2,
        kind: |_, truth| [0.5, 1.5].iter().position(|end| truth.residual(*end) < 64.0),
    },
    Family {
        name: "coefficients over 30 decades",
        make: |rng| {
            let c = [(); 4].map(|()| sign(rng) * magnitude(rng, 1e-20, 1e10));
            question(c, -1e6, 1e6)
        },
        kinds: 1,
        kind: |question, _| {
            let sizes = question.c.map(f32::abs);
            let (low, high) =
                (sizes.iter().copied().fold(f32::MAX, f32::min), sizes.iter().copied().fold(0.0, f32::max));
            only(high > 1e2 * low)
        },
    },
    Family {
        name: "any, a wide interval",
        make: |rng| {
            let c = [(); 4].map(|()| signed(rng));
            question(c, -1e4, 1e4)
        },
        // One root, and three: the ends are on different sides.
        kinds: 2,
        kind: |_, truth| [1, 3].iter().position(|count| truth.roots.len() == *count),
    },
    Family {
        name: "c2 = 0",
        make: |rng| {
            let [c0, c1, c3] = [(); 3].map(|()| signed(rng));
            question([c0, c1, 0.0, c3], -1.0, 1.0)
        },
        // No root, one, and several.
        kinds: 3,
        kind: |question, truth| (question.c[2] == 0.0).then_some(truth.roots.len().min(2)),
    },
    Family {
        name: "rays of every kind",
        make: |rng| troubles::chord(rng, false),
        // A miss, one crossing, and two.
        kinds: 3,
        kind: |_, truth| Some(truth.roots.len().min(2)),
    },
    Family {
        name: "silhouette rays",
        make: |rng| troubles::chord(rng, true),
        kinds: 1,
        kind: |question, _| only(nearly_double(question)),
    },
];

fn question(c: [f64; 4], lo: f64, hi: f64) -> Question {
    Question { c: c.map(|c| c as f32), lo: lo as f32, hi: hi as f32 }
}

fn from_roots([p, q, r]: [f64; 3], lead: f64) -> [f64; 4] {
    [-p * q * r, p * q + p * r + q * r, -(p + q + r), 1.0].map(|c| c * lead)
}

fn signed(rng: &mut ChaCha8Rng) -> f64 {
    rng.random_range(-1.0..1.0)
}

fn sign(rng: &mut ChaCha8Rng) -> f64 {
    if rng.random() { 1.0 } else { -1.0 }
}

/// Every power of ten as likely as the next.
fn magnitude(rng: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    rng.random_range(low.ln()..high.ln()).exp()
}

/// The one kind of a family that has no others.
fn only(occurred: bool) -> Option<usize> {
    occurred.then_some(0)
}

/// Which decade a magnitude lies in, from 10ᶠʳᵒᵐ on, where 0 begins, to below 10ᵗᵒ.
fn decade(x: f32, from: i32, to: i32) -> Option<usize> {
    let decade = x.abs().log10().floor() as i32;
    (from..to).position(|power| power == decade)
}

/// Between the nearest two roots.
fn gap(truth: &Truth) -> f64 {
    let gaps = truth.roots.windows(2).map(|pair| pair[1] - pair[0]);
    gaps.fold(f64::INFINITY, f64::min)
}

/// At some turning point in the interval, or at the point of inflection, the terms of g cancel to a hundredth.
fn nearly_double(question: &Question) -> bool {
    let [c0, c1, c2, c3] = question.c.map(f64::from);
    let root = (c2 * c2 - 3.0 * c3 * c1).max(0.0).sqrt();
    [-root, root].into_iter().any(|root| {
        let u = (-c2 + root) / (3.0 * c3);
        let u = if u.is_finite() { u } else { -c1 / (2.0 * c2) };
        let value = ((c3 * u + c2) * u + c1) * u + c0;
        let size = ((c3.abs() * u.abs() + c2.abs()) * u.abs() + c1.abs()) * u.abs() + c0.abs();
        value.abs() < 0.01 * size
    })
}

/// The two turning points are one, or nearly.
fn nearly_flat(question: &Question) -> bool {
    let [_, c1, c2, c3] = question.c.map(f64::from);
    (c2 * c2 - 3.0 * c3 * c1).abs() < 0.5 * c2 * c2
}
