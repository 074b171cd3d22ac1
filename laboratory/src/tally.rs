//! Verdicts, summed up.

/// Answers of one method to one family.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Backward errors in units of 2⁻²⁴, or displacements in units of the promise ([`crate::unit()`]).
    units: Vec<f64>,
    /// From the first root to the one answered, where there are both: in units of 2⁻²⁴ of the interval, or of
    /// size + distance.
    distances: Vec<f64>,
}

impl Tally {
    pub fn add(&mut self, units: f64, distance: Option<f64>) {
        // No number at all is as wrong as can be.
        self.units.push(if units.is_nan() { f64::INFINITY } else { units });
        self.distances
            .extend(distance.map(|distance| if distance.is_nan() { f64::INFINITY } else { distance }));
    }

    pub fn merge(&mut self, other: &Self) {
        self.units.extend(&other.units);
        self.distances.extend(&other.distances);
    }

    pub fn count(&self) -> usize {
        self.units.len()
    }

    /// How many answers are more wrong than that.
    pub fn beyond(&self, units: f64) -> usize {
        self.units.iter().filter(|&&u| u > units).count()
    }

    pub fn worst(&self) -> f64 {
        self.units.iter().copied().fold(0.0, f64::max)
    }

    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    pub fn quantile(&self, share: f64) -> f64 {
        quantile(&self.units, share)
    }

    /// The plain distance: median and worst.
    pub fn distances(&self) -> [f64; 2] {
        [0.5, 1.0].map(|share| quantile(&self.distances, share))
    }
}

fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().saturating_sub(1);
    sorted.get((share * last as f64).round() as usize).copied().unwrap_or(0.0)
}
