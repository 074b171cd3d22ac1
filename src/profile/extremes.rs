use crate::math::const_fn;

/// The least and the largest value of a cubic over [0, 1].
pub(super) struct Extremes {
    /// The least value; zero, if it is below zero by no more than rounding.
    pub least: f32,
    /// The u of the least value.
    pub narrowest: f32,
    /// The largest value, or a little more.
    pub largest: f32,
}

/// A bound on the error of a value by de Casteljau's interpolations, relative to the largest ordinate: each
/// of the three levels adds two and a half roundings at most (of a term, of the sum, and half of one in 1 −
/// u), 7.5 in all, rounded up.
const ROUNDING: f32 = 8.0 / 16_777_216.0;

impl Extremes {
    /// The extremes of `Σ bⱼ·Bⱼ³(u)`: the least and the largest of the values at the two ends and at the
    /// critical points between them.
    pub const fn of(b: [f32; 4]) -> Self {
        let [b0, b1, b2, b3] = b;
        let size = b0.abs().max(b1.abs()).max(b2.abs()).max(b3.abs());
        // Of two ends with the same radius, take the one where its square changes more slowly: if both are
        // zero, the sharper point.
        let lower = b0 < b3 || b0 == b3 && (b1 - b0).abs() <= (b2 - b3).abs();
        let (mut least, mut narrowest) = if lower { (b0, 0.0) } else { (b3, 1.0) };
        let mut largest = b0.max(b3);
        // Scaled, so that squares of differences neither over- nor underflow. The derivative is 3·(d0·(1−u)²
        // + 2·d1·u(1−u) + d2·u²).
        if size > 0.0 {
            let (d0, d1, d2) = ((b1 - b0) / size, (b2 - b1) / size, (b3 - b2) / size);
            let root = const_fn::sqrt(d1 * d1 - d0 * d2);
            let sum = if d0 - d1 >= 0.0 { d0 - d1 + root } else { d0 - d1 - root };
            let turns = [d0 / sum, sum / (d0 - 2.0 * d1 + d2)];
            let mut i = 0;
            while i < 2 {
                let u = turns[i];
                if u > 0.0 && u < 1.0 {
                    let value = bezier(b, u);
                    if value < least {
                        (least, narrowest) = (value, u);
                    }
                    largest = largest.max(value);
                }
                i += 1;
            }
        }
        // At a critical point that rounding has misplaced by e the value is off by a multiple of e² only,
        // well within the same bound.
        let slack = ROUNDING * size;
        if least < 0.0 && least >= -slack && b0 >= 0.0 && b3 >= 0.0 {
            least = 0.0;
        }
        Self { least, narrowest, largest: (largest + slack).min(b0.max(b1).max(b2).max(b3)) }
    }
}

/// The value at u by de Casteljau's interpolations.
const fn bezier([b0, b1, b2, b3]: [f32; 4], u: f32) -> f32 {
    let v = 1.0 - u;
    let (c0, c1, c2) = (b0 * v + b1 * u, b1 * v + b2 * u, b2 * v + b3 * u);
    let (d0, d1) = (c0 * v + c1 * u, c1 * v + c2 * u);
    d0 * v + d1 * u
}
