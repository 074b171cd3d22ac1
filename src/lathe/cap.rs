//! Caps that rays come in through: there is nothing before them.

use super::follow::Seen;
use super::path::flat;
use super::sweep::Sweep;
use crate::vector::vector;

impl Sweep<'_> {
    /// Hands over what each ray from the i-th on sees that comes in through a cap, clear of its rim. The first that does
    /// not is the one returned.
    #[inline(always)]
    pub fn cap(&self, mut i: u32, mut see: impl FnMut(u32, &Seen)) -> u32 {
        let (frame, segments) = (self.lathe.frame, self.lathe.segments);
        let (z, cap, square, up) = match self.rising {
            Some(true) => (frame.low, frame.base, segments.first().map_or(0.0, |segment| segment.b[0]), -1.0),
            Some(false) => (frame.high, frame.top, segments.last().map_or(0.0, |segment| segment.b[3]), 1.0),
            None => return i,
        };
        if cap.is_none() {
            return i;
        }
        while i < self.end {
            let (m, d) = self.rays.at(i as f32);
            let s = (z - m.z) / d.z;
            let p = m + d * s;
            // The flatter the ray, the farther off rounding may put the place.
            if !((square - flat(p, p)) * d.z.abs() > self.doubt) {
                break;
            }
            let t = (self.shift + s) * self.per_unit;
            see(i, &Seen { t, gradient: vector([0.0, 0.0, up]), per_length: 1.0 });
            i += 1;
        }
        i
    }
}
