//! A region of the plane by the half-planes that it lies in, and its point nearest to a given one.

/// The part of the plane in which `a·x + b·y ≤ c` for each [a, b, c] of some half-planes.
pub(crate) struct Region {
    start: [f64; 2],
    nearest: [f64; 2],
    planes: Vec<[f64; 3]>,
}

impl Region {
    /// The whole plane, and in it the point that is wanted.
    pub fn around(start: [f64; 2]) -> Self {
        Self { start, nearest: start, planes: Vec::with_capacity(64) }
    }

    /// Of all points of the region the one nearest to that which is wanted.
    pub fn nearest(&self) -> [f64; 2] {
        self.nearest
    }

    /// Keeps what lies in a further half-plane. Returns whether there is any.
    ///
    /// If the nearest point does not lie in it, the new one lies on its edge (the distance from `start` is convex),
    /// and there on the stretch that all half-planes before leave of that line. (Seidel, Small-dimensional linear
    /// programming and convex hulls made easy, 1991.)
    pub fn cut(&mut self, plane: [f64; 3]) -> bool {
        let [a, b, c] = plane;
        let [x, y] = self.nearest;
        if !(a * x + b * y <= c) {
            let square = a * a + b * b;
            if !(square > 0.0) {
                return false;
            }
            let by = (c - a * self.start[0] - b * self.start[1]) / square;
            let foot = [self.start[0] + by * a, self.start[1] + by * b];
            let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
            for [p, q, s] in &self.planes {
                let along = a * q - b * p;
                let room = s - p * foot[0] - q * foot[1];
                if along > 0.0 {
                    to = to.min(room / along);
                } else if along < 0.0 {
                    from = from.max(room / along);
                } else if room < 0.0 {
                    return false;
                }
            }
            if !(from <= to) {
                return false;
            }
            let t = 0f64.clamp(from, to);
            self.nearest = [foot[0] - t * b, foot[1] + t * a];
        }
        self.planes.push(plane);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::Region;

    #[test]
    fn nearest_points() {
        let mut region = Region::around([3.0, 1.0]);
        // x ≤ 2, x + y ≤ 2, y ≥ −1, y ≤ 0.25: the corner moves on with each.
        assert!(region.cut([1.0, 0.0, 2.0]));
        assert_eq!(region.nearest(), [2.0, 1.0]);
        assert!(region.cut([1.0, 1.0, 2.0]));
        assert_eq!(region.nearest(), [2.0, 0.0]);
        assert!(region.cut([0.0, -1.0, 1.0]) && region.cut([1.0, 0.0, 1.5]) && region.cut([0.0, 1.0, 0.25]));
        assert_eq!(region.nearest(), [1.5, 0.25]);
        assert!(region.cut([0.0, 0.0, 0.0]) && !region.cut([-1.0, 0.0, -1.6]));
        assert!(!Region::around([0.0; 2]).cut([0.0, 0.0, -1.0]));
    }
}
