//! Where a ray passes through a cap or a ring, in integers: points and s have the bits that they have in a
//! probe.

use crate::arithmetic::integers::{
    Divisor, Flat, Length, Numbers, Rays, dot, fixed, high, power_of_two, shifted, wide,
};
use crate::lathe::row::bounds::RowBounds;
use crate::lathe::row::sweep::Sweep;

impl Numbers {
    /// A cap or a ring at the height z, between two r², seen from above if `up` is 1, from below if it is −1.
    #[inline(always)]
    pub(in crate::lathe::row) fn flat(
        self,
        bounds: &RowBounds,
        z: f32,
        (inner, outer): (f32, f32),
        up: f32,
    ) -> Flat {
        Flat {
            z: fixed(z, self.w),
            inner: wide(inner, 2 * self.w),
            outer: wide(outer, 2 * self.w),
            tolerance: wide(bounds.tolerance, 28 + self.d),
            least: fixed(bounds.least_slope, self.d - 1),
            start: fixed(-bounds.shift, self.w + 32 - self.d),
            up,
        }
    }

    /// [`Sweep::passes`] in integers.
    #[inline(always)]
    pub(in crate::lathe::row) fn passes(
        self,
        _sweep: &Sweep,
        rays: &Rays,
        flat: &Flat,
        i: u32,
    ) -> Option<Length> {
        let ([x, y, z], [dx, dy, dz]) = rays.at(i);
        let toward = if flat.up > 0.0 { -dz } else { dz };
        if toward < flat.least.max(1) {
            return None;
        }
        let s = Divisor::new(dz).of(flat.z - z, 32);
        let p = [x + high(s, dx), y + high(s, dy)];
        let square = dot(p, p);
        let from_rims = (square - flat.inner).min(flat.outer - square);
        let from_start = shifted(i64::from(s) - i64::from(flat.start), self.w - 32 + self.d);
        // In units of 2⁻²⁸. It is less than 8, but may be far below zero.
        let clear = shifted(from_rims.min(from_start), 28 - 2 * self.w).clamp(0, i32::MAX.into()) as i32;
        let bits = self.w + 32 - self.d;
        (i64::from(clear) * i64::from(toward) > flat.tolerance)
            .then(|| Length { units: s, unit: power_of_two(-bits) })
    }
}
