//! One cubic in squared radius over height, in f64.

use crate::bernstein;

/// Between its two heights the squared radius is the cubic with these ordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Its lower and its upper height.
    pub z: [f64; 2],
    /// The Bernstein ordinates of the squared radius.
    pub b: [f64; 4],
}

/// What two segments that meet there share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Knot {
    pub z: f64,
    /// The squared radius.
    pub f: f64,
    /// Its slope over height, below and above: two numbers at a corner.
    pub slopes: [f64; 2],
}

impl Segment {
    /// The one with these values and slopes at its ends.
    pub(crate) fn between(low: Knot, high: Knot) -> Self {
        let third = (high.z - low.z) / 3.0;
        let b = [low.f, low.f + third * low.slopes[1], high.f - third * high.slopes[0], high.f];
        Self { z: [low.z, high.z], b }
    }

    /// Its numbers as they are printed: rounded to f32. The heights first, so that slopes stay what they are.
    pub(crate) fn rounded(&self) -> Self {
        let z = self.z.map(|z| f64::from(z as f32));
        let stretch = (z[1] - z[0]) / (self.z[1] - self.z[0]);
        let [b0, b1, b2, b3] = self.b;
        let b = [b0, b0 + stretch * (b1 - b0), b3 + stretch * (b2 - b3), b3];
        Self { z, b: b.map(|b| f64::from(b as f32)) }
    }

    /// Squared radius and slope at a height.
    pub(crate) fn at(&self, z: f64) -> (f64, f64) {
        self.cubic().at(z)
    }

    /// The same by powers.
    pub(crate) fn cubic(&self) -> Cubic {
        let [b0, b1, b2, b3] = self.b;
        let c = [b0, 3.0 * (b1 - b0), 3.0 * (b2 - 2.0 * b1 + b0), b3 - b0 - 3.0 * (b2 - b1)];
        Cubic { z: self.z[0], per_height: 1.0 / (self.z[1] - self.z[0]), c }
    }

    /// Whether the squared radius stays above zero, or touches it, by more than rounding to f32 can change.
    pub(crate) fn is_solid(&self) -> bool {
        let [b0, b1, b2, b3] = self.b;
        if !(b0 >= 0.0 && b3 >= 0.0) {
            return false;
        }
        if b1 >= 0.0 && b2 >= 0.0 {
            return true;
        }
        // Beside an end on the axis the first ordinate that is not zero gives the sign.
        let leaves_axis =
            |[end, next, after]: [f64; 3]| end > 0.0 || next > 0.0 || next == 0.0 && after >= 0.0;
        if !leaves_axis([b0, b1, b2]) || !leaves_axis([b3, b2, b1]) {
            return false;
        }
        let slope = [b1 - b0, b2 - b1, b3 - b2];
        let size = b0.max(b1.abs()).max(b2.abs()).max(b3);
        bernstein::zeros(&slope).into_iter().all(|u| bernstein::value(&self.b, u) > 1e-6 * size)
    }
}

/// A segment's cubic by powers of u, constant term first.
pub(crate) struct Cubic {
    z: f64,
    per_height: f64,
    c: [f64; 4],
}

impl Cubic {
    /// Squared radius and slope at a height.
    pub(crate) fn at(&self, z: f64) -> (f64, f64) {
        let u = (z - self.z) * self.per_height;
        let [c0, c1, c2, c3] = self.c;
        (c0 + u * (c1 + u * (c2 + u * c3)), (c1 + u * (2.0 * c2 + 3.0 * u * c3)) * self.per_height)
    }
}

#[cfg(test)]
mod tests {
    use super::Segment;

    #[test]
    fn what_dips_below_zero_is_no_solid() {
        let is_solid = |b: [f64; 4]| Segment { z: [0.0, 1.0], b }.is_solid();
        assert!(
            is_solid([0.0, 0.0, 1.0, 0.0])
                && is_solid([1.0, -0.2, 0.3, 1.0])
                && is_solid([0.0, 1.0, -0.1, 1.0])
        );
        // Between its ends; beside its upper end and beside its lower one, where it is tangent to the axis.
        assert!(
            !is_solid([1.0, -2.0, -2.0, 1.0])
                && !is_solid([1.0, -0.1, 0.0, 0.0])
                && !is_solid([0.0, 0.0, -0.1, 1.0])
        );
        assert!(!is_solid([0.0, -0.1, 1.0, 1.0]) && !is_solid([-1e-9, 1.0, 1.0, 1.0]));
    }
}
