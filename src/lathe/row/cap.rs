//! Pixels whose rays come in through a cap. Such a ray meets nothing of the solid before the cap: the rays of
//! a usable row begin outside of the ball around the solid, and all of the solid lies on the far side of the
//! cap's plane.

use super::sweep::{Span, Sweep};
use crate::vector::dot_xy;

impl Sweep<'_> {
    /// The span of pixels, from the i-th on, whose rays come in through a cap, clear of its rim by more than
    /// the tolerance. `None` if the i-th is not such a pixel, or if the rays of the row neither all rise nor
    /// all fall.
    #[inline(always)]
    pub(super) fn cap_span(&self, i: u32) -> Option<Span> {
        let frame = self.bounds.lathe.frame;
        let is_rising = self.bounds.rising?;
        let square = if is_rising { frame.base.cap() } else { frame.top.cap() };
        if !(square > 0.0) {
            return None;
        }
        let to = self.cap_until(i, square, is_rising);
        (to > i).then(|| Span::Cap { to, up: if is_rising { -1.0 } else { 1.0 } })
    }

    /// The t at which the i-th ray meets the plane of the upper end, if `up` is 1, or of the lower end, if it
    /// is −1.
    pub fn end_distance(&self, i: u32, up: f32) -> f32 {
        let frame = self.bounds.lathe.frame;
        let (m, d) = self.ray(i);
        let z = if up > 0.0 { frame.high } else { frame.low };
        self.scale().distance((z - m.z) / d.z)
    }

    /// The first pixel, from the i-th on, whose ray does not clearly pass through a cap, or the number of
    /// pixels if there is none. `square` is the square of the cap's radius. The cap is that of the lower end
    /// if the rays rise, of the upper end if they fall.
    #[inline(never)]
    fn cap_until(&self, mut i: u32, square: f32, is_rising: bool) -> u32 {
        let frame = self.bounds.lathe.frame;
        let z = if is_rising { frame.low } else { frame.high };
        while i < self.direction.len {
            let (m, d) = self.ray(i);
            let p = m + d * ((z - m.z) / d.z);
            // An error of the height moves the point by 1/|dz| times as much: so the flatter the ray, the
            // farther from the rim the point has to be. At |dz| = 1 its r² has to be less than the cap's by
            // the tolerance.
            let is_clear = (square - dot_xy(p, p)) * d.z.abs() > self.bounds.tolerance;
            if !(is_clear && 4.0 * d.z.abs() >= self.bounds.least_slope) {
                break;
            }
            i += 1;
        }
        i
    }
}
