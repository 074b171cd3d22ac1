//! One piece of an outline: a straight line, an arc, a Bézier curve of any degree, or a cubic in r².

use crate::bernstein::{self, HIGHEST_DEGREE};

/// A point of an outline: its distance from the axis and its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Radius.
    pub r: f64,
    /// Height.
    pub z: f64,
}

/// A point.
pub const fn point(r: f64, z: f64) -> Point {
    Point { r, z }
}

impl Point {
    /// The distance from another point.
    pub fn distance(self, other: Self) -> f64 {
        (self.r - other.r).hypot(self.z - other.z)
    }
}

/// A curve (r(t), z(t)), 0 ≤ t ≤ 1, whose r or r² and z are polynomials, or for arcs ratios of polynomials
/// over one denominator w. All by their Bernstein coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    pub(crate) radius: Radius,
    /// w(t)·z(t).
    pub(crate) z: Vec<f64>,
    /// w(t), positive: one coefficient, 1, unless the piece is an arc.
    pub(crate) w: Vec<f64>,
}

/// What of a piece is polynomial.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Radius {
    /// w(t)·r(t).
    Plain(Vec<f64>),
    /// r(t)², where w = 1.
    Squared(Vec<f64>),
}

/// A piece at one t: its place, and derivatives with respect to t.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub r: f64,
    pub z: f64,
    /// r².
    pub f: f64,
    pub dr: f64,
    pub dz: f64,
    /// The slope of r² over height. Infinite where the tangent is horizontal, except at the axis.
    pub slope: f64,
}

impl Piece {
    /// A straight line.
    pub fn line(from: Point, to: Point) -> Self {
        Self::bezier(&[from, to])
    }

    /// A Bézier curve through the first and the last control point, of a degree one less than there are of
    /// them. r is r(t), not r(z): height need not be linear in t.
    ///
    /// # Panics
    ///
    /// With no control point, and with more than 17.
    pub fn bezier(points: &[Point]) -> Self {
        assert!(!points.is_empty() && points.len() <= HIGHEST_DEGREE + 1, "{} points", points.len());
        let radius = Radius::Plain(points.iter().map(|p| p.r).collect());
        Self { radius, z: points.iter().map(|p| p.z).collect(), w: vec![1.0] }
    }

    /// An arc of the ellipse `center + cos(θ)·a + sin(θ)·b` from θ = `from` to `from + sweep`, as many pieces
    /// as it has quarters. a and b are vectors of (radius, height); for a circle they are (R, 0) and (0, R).
    pub fn arc(center: Point, a: Point, b: Point, from: f64, sweep: f64) -> Vec<Self> {
        let quarters = (sweep.abs() / core::f64::consts::FRAC_PI_2 - 1e-9).ceil().clamp(1.0, 1e3);
        let step = sweep / quarters;
        let on = |angle: f64, weight: f64| {
            let (sin, cos) = angle.sin_cos();
            let along = |c: f64, a: f64, b: f64| weight * c + cos * a + sin * b;
            point(along(center.r, a.r, b.r), along(center.z, a.z, b.z))
        };
        let piece = |i: usize| {
            let start = from + step * i as f64;
            let weight = (0.5 * step).cos();
            let [p0, p1, p2] = [on(start, 1.0), on(start + 0.5 * step, weight), on(start + step, 1.0)];
            let radius = Radius::Plain(vec![p0.r, p1.r, p2.r]);
            Self { radius, z: vec![p0.z, p1.z, p2.z], w: vec![1.0, weight, 1.0] }
        };
        (0..quarters as usize).map(piece).collect()
    }

    /// A cubic in squared radius over linear height, by its ordinates, as a profile has it.
    pub fn squares(heights: [f64; 2], ordinates: [f64; 4]) -> Self {
        Self { radius: Radius::Squared(ordinates.to_vec()), z: heights.to_vec(), w: vec![1.0] }
    }

    /// Where it begins.
    pub fn start(&self) -> Point {
        self.end_point(false)
    }

    /// Where it ends.
    pub fn end(&self) -> Point {
        self.end_point(true)
    }

    fn end_point(&self, last: bool) -> Point {
        let end = |c: &[f64]| if last { c[c.len() - 1] } else { c[0] };
        let r = match &self.radius {
            Radius::Plain(r) => end(r) / end(&self.w),
            Radius::Squared(f) => end(f).max(0.0).sqrt(),
        };
        point(r, end(&self.z) / end(&self.w))
    }

    /// Moves the end points by next to nothing: to where a neighbor's are, or onto the axis.
    pub(crate) fn weld(&mut self, start: Point, end: Point) {
        let weights = [self.w[0], self.w[self.w.len() - 1]];
        let last = self.z.len() - 1;
        (self.z[0], self.z[last]) = (start.z * weights[0], end.z * weights[1]);
        match &mut self.radius {
            Radius::Plain(r) => {
                let last = r.len() - 1;
                (r[0], r[last]) = (start.r * weights[0], end.r * weights[1]);
            }
            Radius::Squared(f) => {
                for (at, r) in [(0, start.r), (3, end.r)] {
                    // The square of a root differs from the number by rounding: keep the number.
                    if f[at].max(0.0).sqrt() != r {
                        f[at] = r * r;
                    }
                }
            }
        }
    }

    /// The part from t = a to t = b, run through from a to b. The coefficients are rounded to f64.
    pub(crate) fn part(&self, a: f64, b: f64) -> Self {
        let part = |c: &[f64]| bernstein::restrict(c, a, b);
        let radius = match &self.radius {
            Radius::Plain(r) => Radius::Plain(part(r)),
            Radius::Squared(f) => Radius::Squared(part(f)),
        };
        Self { radius, z: part(&self.z), w: part(&self.w) }
    }

    /// The parts between the given t, which increase.
    pub(crate) fn cut(&self, at: &[f64]) -> Vec<Self> {
        let from = core::iter::once(0.0).chain(at.iter().copied());
        let to = at.iter().copied().chain(core::iter::once(1.0));
        from.zip(to).map(|(a, b)| if (a, b) == (0.0, 1.0) { self.clone() } else { self.part(a, b) }).collect()
    }

    /// Run through from its end to its start.
    pub(crate) fn reversed(mut self) -> Self {
        let (Radius::Plain(r) | Radius::Squared(r)) = &mut self.radius;
        r.reverse();
        self.z.reverse();
        self.w.reverse();
        self
    }

    /// The t at which a piece that rises, or one that falls, has the height z: by bisection.
    pub(crate) fn at_height(&self, z: f64) -> f64 {
        let rises = self.end().z > self.start().z;
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle: f64 = 0.5 * (low + high);
            let height = bernstein::value(&self.z, middle) / bernstein::value(&self.w, middle);
            if (height < z) == rises {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    pub(crate) fn is_finite(&self) -> bool {
        let (Radius::Plain(r) | Radius::Squared(r)) = &self.radius;
        r.iter().chain(&self.z).chain(&self.w).all(|c| c.is_finite())
    }

    /// The piece with the sign of every radius changed.
    pub(crate) fn mirrored(mut self) -> Self {
        if let Radius::Plain(r) = &mut self.radius {
            r.iter_mut().for_each(|r| *r = -*r);
        }
        self
    }

    /// The piece with its radii multiplied by one factor and its heights by another.
    pub(crate) fn stretched(mut self, across: f64, along: f64) -> Self {
        self.z.iter_mut().for_each(|z| *z *= along);
        match &mut self.radius {
            Radius::Plain(r) => r.iter_mut().for_each(|r| *r *= across),
            Radius::Squared(f) => f.iter_mut().for_each(|f| *f *= across * across),
        }
        self
    }

    /// Moved along the axis and away from it.
    pub(crate) fn moved(mut self, by: Point) -> Self {
        for (z, w) in self.z.iter_mut().zip(self.w.iter().chain(core::iter::repeat(&1.0))) {
            *z += by.z * w;
        }
        if let Radius::Plain(r) = &mut self.radius {
            for (r, w) in r.iter_mut().zip(self.w.iter().chain(core::iter::repeat(&1.0))) {
                *r += by.r * w;
            }
        }
        self
    }

    /// The point at t.
    pub fn at(&self, t: f64) -> Point {
        let jet = self.jet(t);
        point(jet.r, jet.z)
    }

    pub(crate) fn jet(&self, t: f64) -> Jet {
        let [w, dw, ddw] = values(&self.w, t);
        let over = |[x, dx, ddx]: [f64; 3]| {
            let x = x / w;
            let dx = (dx - x * dw) / w;
            [x, dx, (ddx - x * ddw - 2.0 * dx * dw) / w]
        };
        let [z, dz, ddz] = over(values(&self.z, t));
        let (r, dr, [f, df, ddf]) = match &self.radius {
            Radius::Plain(r) => {
                let [r, dr, ddr] = over(values(r, t));
                (r, dr, [r * r, 2.0 * r * dr, 2.0 * (dr * dr + r * ddr)])
            }
            Radius::Squared(f) => {
                let [f, df, ddf] = values(f, t);
                let r = f.max(0.0).sqrt();
                (r, if r > 0.0 { 0.5 * df / r } else { df.signum() * f64::MAX.sqrt() }, [f, df, ddf])
            }
        };
        // At the axis both r and dz may vanish: the limit is that of the next derivatives.
        let still = 1e-7 * (dr.abs() + ddz.abs());
        let slope =
            if dz.abs() <= still && df.abs() <= still * (dr.abs() + r.abs()) { ddf / ddz } else { df / dz };
        Jet { r, z, f, dr, dz, slope }
    }

    /// The t in (0, 1) at which the height turns or stands still.
    pub(crate) fn turns(&self) -> Vec<f64> {
        self.still(&self.z)
    }

    /// The t in (0, 1) at which the radius turns or stands still.
    pub(crate) fn radius_turns(&self) -> Vec<f64> {
        let (Radius::Plain(c) | Radius::Squared(c)) = &self.radius;
        self.still(c)
    }

    /// Where the derivative of c/w is zero.
    fn still(&self, c: &[f64]) -> Vec<f64> {
        let (dc, dw) = (bernstein::derivative(c), bernstein::derivative(&self.w));
        if self.w.len() == 1 {
            return bernstein::zeros(&dc);
        }
        let falling = bernstein::scale(&bernstein::product(c, &dw), -1.0);
        bernstein::zeros(&bernstein::sum(&bernstein::product(&dc, &self.w), &falling))
    }

    /// The t in (0, 1) at which it meets the axis.
    pub(crate) fn meets_axis(&self) -> Vec<f64> {
        let (Radius::Plain(c) | Radius::Squared(c)) = &self.radius;
        bernstein::zeros(c)
    }

    /// Whether it lies on the axis, all of it.
    pub(crate) fn is_on_axis(&self, within: f64) -> bool {
        match &self.radius {
            Radius::Plain(r) => r.iter().all(|r| r.abs() <= within),
            Radius::Squared(f) => f.iter().all(|f| f.abs() <= within * within),
        }
    }

    /// Whether it is a straight line by its form.
    pub(crate) fn is_straight(&self) -> bool {
        matches!(&self.radius, Radius::Plain(r) if r.len() == 2)
    }

    /// Lower and upper ends of a box that contains it: the hull of its control points.
    pub(crate) fn hull(&self) -> [Point; 2] {
        let weights = || self.w.iter().copied().chain(core::iter::repeat(1.0));
        let zs = self.z.iter().zip(weights()).map(|(z, w)| z / w);
        let rs: Vec<f64> = match &self.radius {
            Radius::Plain(r) => r.iter().zip(weights()).map(|(r, w)| r / w).collect(),
            Radius::Squared(f) => {
                let largest = f.iter().fold(0.0, |f: f64, g| f.max(*g));
                vec![f.iter().fold(f64::MAX, |f, g| f.min(*g)).max(0.0).sqrt(), largest.sqrt()]
            }
        };
        let least = |c: &mut dyn Iterator<Item = f64>| c.fold(f64::INFINITY, f64::min);
        let largest = |c: &mut dyn Iterator<Item = f64>| c.fold(f64::NEG_INFINITY, f64::max);
        [
            point(least(&mut rs.iter().copied()), least(&mut zs.clone())),
            point(largest(&mut rs.iter().copied()), largest(&mut zs.clone())),
        ]
    }
}

/// A polynomial's value and its first two derivatives.
fn values(c: &[f64], t: f64) -> [f64; 3] {
    let first = bernstein::derivative(c);
    [bernstein::value(c, t), bernstein::value(&first, t), bernstein::value(&bernstein::derivative(&first), t)]
}
