//! Counts the segments and the steps of a list of knots. Two neighbouring knots at different heights make a
//! segment, two at the same height a step.

use super::ProfileError;

/// How many segments and steps an outline's knots make.
pub(super) struct Counts {
    pub segments: usize,
    pub steps: usize,
}

impl Counts {
    /// Counts the segments and the steps of these knots. It does not check that the heights increase: two
    /// neighbours at falling heights count as a segment.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] if a knot is infinite or NaN, if three knots have the same height, or if there is no
    /// segment.
    pub const fn of(knots: &[f32]) -> Result<Self, ProfileError> {
        let (mut steps, mut knot) = (0, 0);
        while knot < knots.len() {
            let height = knots[knot];
            if !height.is_finite() {
                return Err(ProfileError::KnotNotFinite { knot, height });
            }
            if is_step(knots, knot) {
                if knot > 1 && is_step(knots, knot - 1) {
                    return Err(ProfileError::KnotThrice { knot, height });
                }
                steps += 1;
            }
            knot += 1;
        }
        if knots.len() < steps + 2 {
            return Err(ProfileError::NoSegments { knots: knots.len() });
        }
        Ok(Self { segments: knots.len() - 1 - steps, steps })
    }

    /// How many ordinates such an outline has: three for each segment, one for each step, and one more.
    pub const fn ordinates(&self) -> usize {
        3 * self.segments + self.steps + 1
    }
}

/// Whether the knot of this number has the same height as the one before it. False for the first, number 0.
pub(super) const fn is_step(knots: &[f32], knot: usize) -> bool {
    knot > 0 && knots[knot] == knots[knot - 1]
}
