//! Outlines at random, of kinds that are hard each in its own way.

use crate::cases::Outline;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One to twelve segments with any ordinates.
    Any,
    /// A quadric of any height: spheroid, cone, paraboloid, hyperboloid, a segment that closes at both ends.
    Quadric,
    /// Edges 0.1 % to 1 % of the radius high between wide segments.
    Edge,
    /// Rims that flare within 1 % to 10 %.
    Flare,
    /// A neck of a hundredth to a thousandth beside a flare.
    Neck,
    /// Ordinates and heights over three decades.
    Uneven,
    /// Ten to a million times as high as wide: cylinders, cones, cones with a tip cut off.
    Needle,
    /// Segments that close to a point at both ends, or nearly.
    Beads,
    /// Steps between segments, and rings at the ends: of any width, some a hundred-thousandth apart.
    Stepped,
}

impl Kind {
    pub const ALL: [Kind; 9] = [
        Kind::Any,
        Kind::Quadric,
        Kind::Edge,
        Kind::Flare,
        Kind::Neck,
        Kind::Uneven,
        Kind::Needle,
        Kind::Beads,
        Kind::Stepped,
    ];

    pub fn outline(self, seed: u64, number: u64) -> Outline {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(number);
        let rng = &mut rng;
        let (knots, ordinates) = match self {
            Kind::Any => any(rng),
            Kind::Quadric => quadric(rng),
            Kind::Edge => edge(rng),
            Kind::Flare => flare(rng),
            Kind::Neck => neck(rng),
            Kind::Uneven => uneven(rng),
            Kind::Needle => needle(rng),
            Kind::Beads => beads(rng),
            Kind::Stepped => stepped(rng),
        };
        let k = [1.0, 1.0, 1.0, 0.0, rng.random_range(0.05_f32..1.0)][rng.random_range(0..5)];
        Outline { name: "random", knots, ordinates, k, base_closed: rng.random(), top_closed: rng.random() }
    }
}

type Outlined = (Vec<f32>, Vec<f32>);

fn decades(rng: &mut ChaCha8Rng, low: f32, high: f32) -> f32 {
    rng.random_range(low.ln()..high.ln()).exp()
}

fn any(rng: &mut ChaCha8Rng) -> Outlined {
    let segments = rng.random_range(1..=12);
    let mut knots = vec![rng.random_range(-1.0_f32..1.0)];
    let mut ordinates = vec![rng.random_range(0.0_f32..1.0)];
    for i in 0..segments {
        knots.push(knots[i] + rng.random_range(0.05_f32..1.0));
        ordinates.extend([0; 3].map(|_| rng.random_range(0.0_f32..1.0)));
    }
    (knots, ordinates)
}

fn quadric(rng: &mut ChaCha8Rng) -> Outlined {
    let h = decades(rng, 0.1, 10.0);
    let a = rng.random_range(0.1_f32..2.0);
    let ordinates = match rng.random_range(0..5) {
        0 => vec![0.0, a, a, 0.0],
        1 => vec![a, a / 3.0, 0.0, 0.0],
        2 => vec![0.0, a / 3.0, 2.0 * a / 3.0, a],
        3 => vec![a, 0.0, 0.0, a],
        _ => vec![0.0, a, rng.random_range(0.0_f32..2.0), 0.0],
    };
    (vec![0.0, h], ordinates)
}

fn edge(rng: &mut ChaCha8Rng) -> Outlined {
    let mut o = || rng.random_range(0.02_f32..1.0);
    let (a, b) = (o(), o());
    let mut ordinates = vec![a, a, a, a, a, b, b, b, b, b];
    for b in &mut ordinates {
        if rng.random_ratio(1, 3) {
            *b = rng.random_range(0.02_f32..1.0);
        }
    }
    let h = decades(rng, 0.001, 0.01);
    (vec![0.0, 1.0, 1.0 + h, 2.0], ordinates)
}

fn flare(rng: &mut ChaCha8Rng) -> Outlined {
    let mut o = || rng.random_range(0.02_f32..1.0);
    let ordinates = vec![o(), o(), o(), o(), o(), o(), o()];
    let h = decades(rng, 0.01, 0.1);
    if rng.random() { (vec![0.0, 1.0, 1.0 + h], ordinates) } else { (vec![-h, 0.0, 1.0], ordinates) }
}

fn neck(rng: &mut ChaCha8Rng) -> Outlined {
    let thin = decades(rng, 1e-6, 1e-3);
    let mut o = || rng.random_range(0.1_f32..1.0);
    let mut ordinates = vec![o(), o(), thin, thin, thin, o(), o()];
    if rng.random() {
        ordinates[4] = rng.random_range(0.0_f32..0.5);
    }
    if rng.random() {
        ordinates[2] = rng.random_range(0.0_f32..0.5);
    }
    (vec![0.0, rng.random_range(0.02_f32..1.0), 1.2], ordinates)
}

fn uneven(rng: &mut ChaCha8Rng) -> Outlined {
    let segments = rng.random_range(1..=8);
    let mut knots = vec![rng.random_range(-1.0_f32..0.0)];
    for i in 0..segments {
        knots.push(knots[i] + decades(rng, 1e-3, 1.0));
    }
    let ordinates = (0..3 * segments + 1).map(|_| decades(rng, 1e-3, 1.0)).collect();
    (knots, ordinates)
}

fn needle(rng: &mut ChaCha8Rng) -> Outlined {
    let height = decades(rng, 10.0, 1e6);
    // The radius at the tip, and the cone's ordinates: products of the radii.
    let tip = [1.0, 0.0, decades(rng, 1e-4, 1.0)][rng.random_range(0..3)];
    let (a, b) = ((2.0 + tip) / 3.0, (1.0 + 2.0 * tip) / 3.0);
    let ordinates = [1.0, (a * a).min((1.0 + 2.0 * tip) / 3.0), b * tip, tip * tip];
    (vec![0.0, height], ordinates.to_vec())
}

fn beads(rng: &mut ChaCha8Rng) -> Outlined {
    let mut knots = vec![0.0_f32];
    let mut ordinates = vec![0.0_f32];
    for i in 0..rng.random_range(1..=3) {
        knots.push(knots[i] + decades(rng, 0.1, 2.0));
        let inner = [(); 2].map(|()| {
            let thin = rng.random_ratio(1, 3);
            if thin { decades(rng, 1e-6, 1e-1) } else { rng.random_range(0.05_f32..1.0) }
        });
        ordinates.extend([inner[0], inner[1], 0.0]);
    }
    (knots, ordinates)
}

fn stepped(rng: &mut ChaCha8Rng) -> Outlined {
    let segments = rng.random_range(1..=8);
    let (mut knots, mut ordinates) = (vec![rng.random_range(-1.0_f32..1.0)], Vec::new());
    let square = |rng: &mut ChaCha8Rng| match rng.random_range(0..6) {
        0 => 0.0,
        1 => decades(rng, 1e-4, 1.0),
        _ => rng.random_range(0.0_f32..1.0),
    };
    ordinates.push(square(rng));
    for i in 0..=segments {
        let (last, z) = (ordinates[ordinates.len() - 1], knots[knots.len() - 1]);
        if rng.random_ratio(2, 3) {
            // Narrower or wider, some by a hair.
            let other = if rng.random_ratio(1, 6) { last * 0.999_99 } else { square(rng) };
            if other != last {
                knots.push(z);
                ordinates.push(other);
            }
        }
        if i < segments {
            let height = if rng.random_ratio(1, 6) { 1e-5 } else { rng.random_range(0.05_f32..0.6) };
            knots.push(z + height);
            ordinates.extend([square(rng), square(rng), square(rng)]);
        }
    }
    (knots, ordinates)
}
