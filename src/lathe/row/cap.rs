//! Caps that rays come in through. There is nothing before them, for a run that is of use begins outside.

use super::normal::Seen;
use super::sweep::Sweep;
use crate::vector::dot_xy;
use crate::vector::vector;

impl Sweep<'_> {
    /// The square of the radius of the cap that rays come in through, if there is one.
    #[inline(always)]
    pub fn cap_ahead(&self) -> Option<f32> {
        let frame = self.lathe.frame;
        let cap = if self.rising? { frame.base.cap } else { frame.top.cap };
        (cap > 0.0).then_some(cap)
    }

    /// Hands over what each ray from the i-th on sees that comes in through a cap, clear of its rim. The first that does
    /// not is the one returned.
    #[inline(always)]
    pub fn cap(&self, mut i: u32, cap: f32, mut see: impl FnMut(u32, &Seen)) -> u32 {
        let frame = self.lathe.frame;
        let (z, up) = if self.rising == Some(true) { (frame.low, -1.0) } else { (frame.high, 1.0) };
        while i < self.end {
            let (m, d) = self.ray(i);
            let p = m + d * ((z - m.z) / d.z);
            // The flatter the ray, the farther off rounding may put the place.
            if !((cap - dot_xy(p, p)) * d.z.abs() > self.doubt) {
                break;
            }
            see(i, &Seen { gradient: vector([0.0, 0.0, up]), per_length: 1.0 });
            i += 1;
        }
        i
    }
}
