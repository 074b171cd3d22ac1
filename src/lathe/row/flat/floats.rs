//! Where a ray passes through a cap or a ring, in floats.

use crate::arithmetic::floats::{Flat, Length, Numbers, Rays};
use crate::lathe::row::bounds::RowBounds;
use crate::lathe::row::sweep::Sweep;
use crate::math::minmax::lesser;

impl Numbers {
    /// A cap or a ring at the height z, between two r², seen from above if `up` is 1, from below if it is −1.
    #[inline(always)]
    pub(in crate::lathe::row) fn flat(
        self,
        _bounds: &RowBounds,
        z: f32,
        (inner, outer): (f32, f32),
        up: f32,
    ) -> Flat {
        Flat { z, middle: 0.5 * (outer + inner), half: 0.5 * (outer - inner), up }
    }

    /// [`Sweep::passes`] in floats.
    #[inline(always)]
    pub(in crate::lathe::row) fn passes(
        self,
        sweep: &Sweep,
        _rays: &Rays,
        flat: &Flat,
        i: u32,
    ) -> Option<Length> {
        let (m, d) = sweep.ray(i);
        let s = (flat.z - m.z) / d.z;
        let (x, y) = (m.x + s * d.x, m.y + s * d.y);
        let toward = -flat.up * d.z;
        let from_rims = flat.half - (x * x + y * y - flat.middle).abs();
        let clear = lesser(from_rims, s + sweep.bounds.shift) * toward;
        (clear > sweep.bounds.tolerance && 2.0 * toward >= sweep.bounds.least_slope).then_some(Length(s))
    }
}
