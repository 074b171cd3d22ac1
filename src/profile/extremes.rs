use crate::math::{UNIT_ROUNDOFF, const_fn};

/// The least and the largest value of a cubic over [0, 1].
pub(crate) struct Extremes {
    /// The least value. It is zero if both ends are not negative and the least value is negative by no more
    /// than rounding errors.
    pub least: f32,
    /// The u of the least value.
    pub narrowest: f32,
    /// An upper bound of the largest value: the computed value plus [`VALUE_ERROR`], but at most the largest
    /// ordinate.
    pub largest: f32,
}

/// An upper bound of the rounding error of a value computed by de Casteljau's algorithm, relative to the
/// largest ordinate. Each of its three levels adds at most two and a half roundings: one of a term, one of
/// the sum, and half of one in 1 − u. That is 7.5 in all, here rounded up to 8.
const VALUE_ERROR: f32 = 8.0 * UNIT_ROUNDOFF;

impl Extremes {
    /// The extremes of `Σ bⱼ·Bⱼ³(u)`, found among the values at the two ends and at the critical points
    /// between them.
    pub const fn of(b: [f32; 4]) -> Self {
        let [b0, b1, b2, b3] = b;
        let size = b0.abs().max(b1.abs()).max(b2.abs()).max(b3.abs());
        // If both ends have the same squared radius, the end where it changes more slowly counts as the
        // narrowest: if both are zero, that is the sharper of the two tips.
        let lower = b0 < b3 || b0 == b3 && (b1 - b0).abs() <= (b2 - b3).abs();
        let (mut least, mut narrowest) = if lower { (b0, 0.0) } else { (b3, 1.0) };
        let mut largest = b0.max(b3);
        // The differences are divided by the largest ordinate, so that their squares neither overflow nor
        // underflow. The derivative is then 3·(d0·(1−u)² + 2·d1·u(1−u) + d2·u²), times that ordinate. Its
        // zeros are d0/sum and sum/(d0 − 2·d1 + d2), where `sum` adds the root of the discriminant with the
        // sign that cancels no digits. A zero that does not exist comes out NaN or infinite, and is left out.
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
        // A rounding error e in a critical point changes the value there only by a multiple of e², which is
        // well within the same bound.
        let slack = VALUE_ERROR * size;
        if least < 0.0 && least >= -slack && b0 >= 0.0 && b3 >= 0.0 {
            least = 0.0;
        }
        Self { least, narrowest, largest: (largest + slack).min(b0.max(b1).max(b2).max(b3)) }
    }
}

/// The value at u, computed by de Casteljau's algorithm.
const fn bezier([b0, b1, b2, b3]: [f32; 4], u: f32) -> f32 {
    let v = 1.0 - u;
    let (c0, c1, c2) = (b0 * v + b1 * u, b1 * v + b2 * u, b2 * v + b3 * u);
    let (d0, d1) = (c0 * v + c1 * u, c1 * v + c2 * u);
    d0 * v + d1 * u
}
