//! The paper's way for profiles of a higher degree: the control polygon of a curve (r(t), z(t)) is halved until each part
//! is, within a tolerance, a cubic in r² over a height that is linear in t. And how many segments theory expects of other ways.
//!
//! A part is replaced by the cubic with the same r² and the same slope of r² over t at both ends, over linear height. What it
//! is off by in r² and in height, each as a polynomial in t, is at most the largest of its Bernstein coefficients.

/// A Bézier curve of radius and height, by its control points.
#[derive(Clone, Debug)]
pub struct Curve {
    pub r: Vec<f64>,
    pub z: Vec<f64>,
}

/// How many parts the curve is halved into until each is a segment within a distance.
pub fn parts(curve: &Curve, tolerance: f64) -> usize {
    if curve.error() <= tolerance {
        return 1;
    }
    let [low, high] = curve.halves();
    parts(&low, tolerance) + parts(&high, tolerance)
}

/// How many segments it takes, to first order, if each of height h is off by h⁴·|f⁗|/`per` in f = r²: 384 for cubics with
/// the curve's own values and slopes at their ends, 768 for the best that share both with their neighbors, 3072 for the best of
/// all. An error in f is √(4·f + f′²) times the distance.
pub fn expected(curve: &Curve, tolerance: f64, per: f64) -> f64 {
    let derivatives = Derivatives::of(curve);
    let density = |t: f64| {
        let [f, slope, fourth] = derivatives.at(t);
        let rise = power_value(&derivatives.dz, t);
        rise * (fourth.abs() / (per * tolerance * (4.0 * f + slope * slope).sqrt())).powf(0.25)
    };
    let count = 2000;
    (0..count).map(|i| density((f64::from(i) + 0.5) / f64::from(count))).sum::<f64>() / f64::from(count)
}

impl Curve {
    /// At most how far the curve is from the one segment that stands for it.
    fn error(&self) -> f64 {
        let square = bernstein_product(&self.r, &self.r);
        let n = square.len() - 1;
        // A cubic's inner ordinates by the slopes at its ends.
        let per_third = n as f64 / 3.0;
        let cubic = [
            square[0],
            square[0] + per_third * (square[1] - square[0]),
            square[n] - per_third * (square[n] - square[n - 1]),
            square[n],
        ];
        // Both of one degree, at least 3: each times the constant 1, whose degree makes up the difference.
        let [raised, square] = [(&cubic[..], n), (&square[..], 3)]
            .map(|(c, degree)| bernstein_product(c, &vec![1.0; degree.saturating_sub(c.len() - 1) + 1]));
        let largest = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
        let m = self.z.len() - 1;
        let linear: Vec<f64> =
            (0..=m).map(|i| self.z[0] + (self.z[m] - self.z[0]) * i as f64 / m as f64).collect();
        let least = self.r.iter().fold(f64::INFINITY, |least: f64, r| least.min(*r)).max(1e-9);
        // |Δr| = |Δr²| / (sum of both radii), of which the curve's own is no less than its control points'.
        (largest(&square, &raised) / least).hypot(largest(&self.z, &linear))
    }

    fn halves(&self) -> [Self; 2] {
        let [[low_r, high_r], [low_z, high_z]] = [&self.r, &self.z].map(|c| {
            let mut c = c.clone();
            let (mut low, mut high) = (vec![c[0]], vec![c[c.len() - 1]]);
            while c.len() > 1 {
                c = c.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
                low.push(c[0]);
                high.insert(0, c[c.len() - 1]);
            }
            [low, high]
        });
        [Self { r: low_r, z: low_z }, Self { r: high_r, z: high_z }]
    }
}

/// f and its derivatives over height, as polynomials by powers of t over powers of dz/dt.
struct Derivatives {
    dz: Vec<f64>,
    /// dᵏf/dzᵏ = numerators\[k\] / dz^(2k − 1), for k = 0 a polynomial.
    numerators: Vec<Vec<f64>>,
}

impl Derivatives {
    fn of(curve: &Curve) -> Self {
        let r = powers(&curve.r);
        let dz = derivative(&powers(&curve.z));
        let ddz = derivative(&dz);
        let mut numerators = vec![product(&r, &r)];
        numerators.push(derivative(&numerators[0]));
        for k in 1..4 {
            let last = &numerators[k];
            let falling = product(&ddz, last);
            let factor = 2.0 * k as f64 - 1.0;
            let mut next = product(&derivative(last), &dz);
            next.resize(next.len().max(falling.len()), 0.0);
            next.iter_mut().zip(&falling).for_each(|(next, falling)| *next -= factor * falling);
            numerators.push(next);
        }
        Self { dz, numerators }
    }

    /// f, its first derivative and its fourth.
    fn at(&self, t: f64) -> [f64; 3] {
        let dz = power_value(&self.dz, t);
        let numerator = |k: usize| power_value(&self.numerators[k], t);
        [numerator(0), numerator(1) / dz, numerator(4) / dz.powi(7)]
    }
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64)
}

fn bernstein_product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let (m, n) = (a.len() - 1, b.len() - 1);
    let coefficient = |k: usize| {
        let terms =
            (k.saturating_sub(n)..=k.min(m)).map(|i| binomial(m, i) * binomial(n, k - i) * a[i] * b[k - i]);
        terms.sum::<f64>() / binomial(m + n, k)
    };
    (0..=m + n).map(coefficient).collect()
}

/// Bernstein coefficients by powers, constant term first.
fn powers(c: &[f64]) -> Vec<f64> {
    let n = c.len() - 1;
    let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    let power = |k: usize| binomial(n, k) * (0..=k).map(|i| sign(k - i) * binomial(k, i) * c[i]).sum::<f64>();
    (0..=n).map(power).collect()
}

fn derivative(c: &[f64]) -> Vec<f64> {
    c.iter().enumerate().skip(1).map(|(k, c)| k as f64 * c).collect()
}

fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut c = vec![0.0; a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            c[i + j] += a * b;
        }
    }
    c
}

fn power_value(c: &[f64], t: f64) -> f64 {
    c.iter().rev().fold(0.0, |value, c| value * t + c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fourth_derivative_known_by_hand() {
        // r = 1 + t², z = 2·t: f = (1 + z²/4)², f⁗ = 24/16; at z = 2 f = 4 and f′ = 4.
        let curve = Curve { r: vec![1.0, 1.0, 2.0], z: vec![0.0, 2.0] };
        let [f, slope, fourth] = Derivatives::of(&curve).at(1.0);
        assert!((f - 4.0).abs() < 1e-12 && (slope - 4.0).abs() < 1e-12 && (fourth - 1.5).abs() < 1e-12);
    }

    #[test]
    fn what_is_cubic_is_one_part_and_halving_bounds_what_is_measured() {
        // A cone: r² is of degree 2.
        assert_eq!(parts(&Curve { r: vec![1.0, 2.0], z: vec![0.0, 1.0] }, 1e-9), 1);
        let curve = Curve { r: vec![1.0, 2.0, 0.5, 1.0], z: vec![0.0, 0.2, 1.5, 2.0] };
        let [low, high] = curve.halves();
        assert!(low.error() < curve.error() && high.error() < curve.error());
        assert_eq!(low.r[3], high.r[0]);
        let (few, many) = (parts(&curve, 1e-2), parts(&curve, 1e-4));
        // First order in the height's bend: a hundredth of the tolerance, about ten times the parts.
        assert!(many > 5 * few && many < 20 * few, "{few}, {many}");
    }
}
