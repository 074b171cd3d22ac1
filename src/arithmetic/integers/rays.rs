//! The rays of a row in integers.

use super::limits::Limits;
use super::{Numbers, fixed_vector, product};
use crate::arithmetic::RowLimits;
use crate::vector::F32x3;

/// The rays of a row of pixels: the i-th has the origin `origin + i·origin_change` and the direction
/// `direction + i·direction_change`.
#[derive(Clone, Copy)]
pub(crate) struct Rays {
    /// In units of 2^−w, with [`Numbers::w`].
    pub origin: [i32; 3],
    /// In units of 2^(−w − finer).
    pub origin_change: [i32; 3],
    /// In units of 2^−d.
    pub direction: [i32; 3],
    /// In units of 2^(3 − d − finer).
    pub direction_change: [i32; 3],
    /// 2^finer is more than the number of pixels, and at most twice that. From pixel to pixel the origin
    /// changes by at most twice the bound of M over the number of pixels, the direction by at most twice the
    /// bound of |D| over it: so no change exceeds 2³¹ units.
    pub finer: i32,
    /// What is known of all of these rays.
    pub limits: Limits,
}

impl Numbers {
    /// The rays of a part of a row, which has `pixels` pixels. `ray` is M and D of ray 0, `change` by how
    /// much the two change from pixel to pixel, `limits` what is known of all of them.
    // Not `inline(always)`: in a build for size, flash should contain it only once.
    pub fn rays(self, ray: (F32x3, F32x3), change: (F32x3, F32x3), pixels: u32, limits: &RowLimits) -> Rays {
        let finer = (u32::BITS - pixels.leading_zeros()) as i32;
        Rays {
            origin: fixed_vector(ray.0, self.w),
            origin_change: fixed_vector(change.0, self.w + finer),
            direction: fixed_vector(ray.1, self.d),
            direction_change: fixed_vector(change.1, self.d + finer - 3),
            finer,
            limits: self.limits(limits),
        }
    }
}

impl Rays {
    /// Counts the rays backwards: ray i is what ray −i was.
    pub fn reverse(&mut self) {
        self.origin_change = self.origin_change.map(|x| -x);
        self.direction_change = self.direction_change.map(|x| -x);
    }

    /// M and D of ray i + ½, which passes through the middle of the i-th pixel: in units of 2^−w and of 2^−d.
    #[inline(never)]
    pub fn at(&self, i: u32) -> ([i32; 3], [i32; 3]) {
        let twice = 2 * i as i32 + 1;
        // Said to be less than 32, the shift takes the compiler half of the instructions.
        let right = (self.finer + 1) & 31;
        let sum = |x: i32, change: i32, by: i32| x.wrapping_add((product(change, by) >> right) as i32);
        let ([x, y, z], [x1, y1, z1]) = (self.origin, self.origin_change);
        let ([dx, dy, dz], [dx1, dy1, dz1]) = (self.direction, self.direction_change);
        let m = [sum(x, x1, twice), sum(y, y1, twice), sum(z, z1, twice)];
        (m, [sum(dx, dx1, 8 * twice), sum(dy, dy1, 8 * twice), sum(dz, dz1, 8 * twice)])
    }
}
