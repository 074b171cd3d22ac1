//! A fixed table of cubics to count instructions on, made by the same f32 arithmetic on host and target: `core` only.
//!
//! Three families, since cost depends on the question: cubics along the chords of rays at the reference vase, three well separated roots, and
//! near-double ones.

/// Cubics a family.
pub const COUNT: u32 = 64;

/// `Σ c[j]·uʲ` on [lo, hi].
#[derive(Clone, Copy)]
pub struct Item {
    pub c: [f32; 4],
    pub lo: f32,
    pub hi: f32,
}

/// The index-th cubic of a family.
pub type Make = fn(u32) -> Item;

pub const FAMILIES: [(&str, Make); 3] =
    [("rays", ray), ("separated", separated), ("near-double", near_double)];

/// A uniform number in [0, 1) for every index: Knuth's multiplicative hash, mixed.
fn uniform(index: u32, which: u32) -> f32 {
    let mut h = (index * 8 + which).wrapping_mul(2_654_435_769);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    ((h ^ (h >> 15)) >> 8) as f32 / 16_777_216.0
}

fn from_roots(p: f32, q: f32, r: f32) -> [f32; 4] {
    [-p * q * r, p * q + p * r + q * r, -(p + q + r), 1.0]
}

fn separated(i: u32) -> Item {
    let [p, q, r] = [0, 1, 2].map(|which| 0.6 * uniform(i, which));
    let c = from_roots(p - 0.9, q - 0.3, r + 0.35);
    Item { c, lo: -1.0, hi: 1.0 }
}

/// Gaps of 2⁻⁴ to 2⁻²⁰.
fn near_double(i: u32) -> Item {
    let root = 0.1 + 0.8 * uniform(i, 0);
    let mut gap = 0.0625;
    for _ in 0..i % 17 {
        gap *= 0.5;
    }
    let c = from_roots(root, root + gap, 1.5 + uniform(i, 1));
    Item { c, lo: 0.0, hi: 1.0 }
}

/// A ray of the reference camera at a point of the vase's section through its axis: g along what of it lies in one segment's slab, half a unit on
/// either side of the axis at most.
fn ray(i: u32) -> Item {
    const SEGMENTS: [(f32, f32, [f32; 4]); 4] = [
        (0.0, 0.25, [0.04, 0.16, 0.2, 0.2]),
        (0.25, 0.6, [0.2, 0.2, 0.2, 0.12]),
        (0.6, 0.85, [0.12, 0.05, 0.0, 0.01]),
        (0.85, 1.0, [0.01, 0.03, 0.042, 0.06]),
    ];
    let (low, high, [b0, b1, b2, b3]) = SEGMENTS[(i % 4) as usize];
    // From (0, −2.2, 0.9) to a point of the slab's section through the axis.
    let (x, z) = (0.45 * uniform(i, 0), low + (high - low) * uniform(i, 1));
    let slope = (z - 0.9) / 2.2;
    let at_height = |z: f32| (z - 0.9) / slope - 2.2;
    let (one, other) = (at_height(low), at_height(high));
    let (near, far) = (one.min(other).max(-0.5), one.max(other).min(0.5));
    let u = |y: f32| ((0.9 + slope * (y + 2.2) - low) / (high - low)).clamp(0.0, 1.0);
    let (at, du) = (u(near), u(far) - u(near));
    let f = [b0, 3.0 * (b1 - b0), 3.0 * (b2 - 2.0 * b1 + b0), b3 - b0 - 3.0 * (b2 - b1)];
    let (px, vx) = (x * (near + 2.2) / 2.2, x * (far - near) / 2.2);
    let c = [
        ((f[3] * at + f[2]) * at + f[1]) * at + f[0] - (px * px + near * near),
        ((3.0 * f[3] * at + 2.0 * f[2]) * at + f[1]) * du - 2.0 * (px * vx + near * (far - near)),
        (3.0 * f[3] * at + f[2]) * du * du - (vx * vx + (far - near) * (far - near)),
        f[3] * du * du * du,
    ];
    Item { c, lo: 0.0, hi: 1.0 }
}
