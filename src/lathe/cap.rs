//! Caps that rays come in through: there is nothing before them.

use super::follow::Seen;
use super::path::flat;
use super::sweep::Sweep;
use crate::vector::vector;

impl Sweep<'_> {
    /// What the i-th ray sees, if it comes in through a cap, clear of its rim.
    pub fn cap(&self, i: u32) -> Option<Seen> {
        let frame = self.lathe.frame;
        let (end, up) = if self.rising? { (&frame.base, -1.0) } else { (&frame.top, 1.0) };
        let (m, d) = self.ray(i);
        let p = m + d * ((end.z - m.z) / d.z);
        // The flatter the ray, the farther off rounding may put the place.
        ((end.cap - flat(p, p)) * d.z.abs() > self.doubt)
            .then_some(Seen { gradient: vector([0.0, 0.0, up]), per_length: 1.0 })
    }
}
