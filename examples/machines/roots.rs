//! The roots of cubics on which solvers go wrong, as a number for each solver.

use crate::checksum::hash;
use embedded_lathe::Cubic;
use embedded_lathe::math::{Libm, Micromath, Native};
use embedded_lathe::solve::{Cardano, Solver, Split};

/// So many that the slowest of the emulated machines is done in ten seconds.
const COUNT: u32 = 4_000;

type Checksum = fn() -> u64;

/// The checksum of the roots of all [`cubics`], for each solver over each library.
pub const SOLVERS: [(&str, Checksum); 6] = [
    ("split native", of::<Split<Native>>),
    ("split libm", of::<Split<Libm>>),
    ("split micromath", of::<Split<Micromath>>),
    ("cardano native", of::<Cardano<Native>>),
    ("cardano libm", of::<Cardano<Libm>>),
    ("cardano micromath", of::<Cardano<Micromath>>),
];

/// The checksum of the lists of roots by the solver S: of the length of each, and the bits of its roots.
pub fn of<S: Solver>() -> u64 {
    hash(cubics().flat_map(|(g, lo, hi)| {
        let roots = g.roots_by::<S>(lo, hi);
        let count = roots.len() as u32;
        [count].into_iter().chain(roots.into_iter().map(f32::to_bits)).flat_map(u32::to_be_bytes)
    }))
}

/// Cubics and intervals: a quarter have a double root, or the nearest to one that has f32 coefficients, and a
/// quarter a triple one. The coefficients of the others are zero, subnormal, small, huge, infinite or NaN.
pub fn cubics() -> impl Iterator<Item = (Cubic, f32, f32)> {
    const ENDS: [(f32, f32); 4] = [(-1.0, 1.0), (0.0, 1.0), (f32::NEG_INFINITY, f32::INFINITY), (-1e3, 1e9)];
    let mut random = Random(0);
    (0..COUNT).map(move |i| {
        let c = [(); 4].map(|()| random.coefficient());
        let [a, b, k] = [(); 3].map(|()| random.number());
        let c = match i % 4 {
            // (u − a)²·(k·u + b) and k·(u − a)³.
            0 => [a * a * b, a * (a * k - 2.0 * b), b - 2.0 * a * k, k],
            1 => [-a * a * a * k, 3.0 * a * a * k, -3.0 * a * k, k],
            _ => c,
        };
        let (lo, hi) = ENDS[random.below(4) as usize];
        (Cubic::new(c), lo, hi)
    })
}

/// A sequence of random numbers that every machine repeats: a Weyl sequence, its bits mixed (Steele, Lea and
/// Flood 2014).
struct Random(u32);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let x = (self.0 ^ self.0 >> 16).wrapping_mul(0x21f0_aaad);
        let x = (x ^ x >> 15).wrapping_mul(0x735a_2d97);
        x ^ x >> 15
    }

    fn below(&mut self, count: u32) -> u32 {
        self.bits() % count
    }

    /// A number from −1 to 1.
    fn number(&mut self) -> f32 {
        (self.bits() as i32 >> 7) as f32 / (1 << 24) as f32
    }

    fn coefficient(&mut self) -> f32 {
        let x = self.number();
        match self.below(24) {
            0..4 => 0.0,
            4..8 => x * f32::MIN_POSITIVE,
            8..10 => f32::from_bits(self.bits() & 0x8000_0003),
            10..13 => x * 1e-30,
            13..15 => x * 1e-12,
            15..22 => x,
            22 => x * f32::MAX,
            _ => [f32::MAX, f32::MIN_POSITIVE, f32::INFINITY, f32::NAN][self.below(4) as usize],
        }
    }
}
