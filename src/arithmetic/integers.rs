//! Pixels in 32-bit integers, for machines without an FPU: numbers in fixed point, with as many bits behind
//! the point as the bounds of a row leave.
//!
//! A product is the high word of the 64-bit product of two 32-bit numbers: one instruction where the core has
//! one.

mod divisor;
mod fixed;
mod inverse_root;
mod limits;
mod rays;
mod seen;
mod wall;
// An Arm core without atomic exchanges is an ARMv6-M.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), path = "integers/words_by_halves.rs")]
mod words;
#[cfg(test)]
mod words_by_halves;

pub(crate) use divisor::{Divisor, narrowed, square_root};
pub(crate) use fixed::{dot, exponent, fixed, fixed_vector, power_of_two, shifted, wide};
pub(crate) use inverse_root::{inverse_root, square};
pub(crate) use limits::Limits;
pub(crate) use rays::Rays;
pub(crate) use seen::{Cosine, Direction, Gloss, Normal, Pair, Seen, ToLight, Views};
pub(crate) use wall::Wall;
pub(crate) use words::{high, inverse, leading_zeros, product, wide_square};

/// Of how many solids a picture keeps what is the same for all of its rows. That takes 140 bytes for each of
/// them, and spares each row some two hundred operations on floats.
pub(crate) const KEPT: usize = 6;

/// The format of s, D and coordinates in a row: how many bits of each stand behind the point. With n bits a
/// unit is 2^−n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Numbers {
    /// Of s. On the solid |s| is less than 2³⁰ units.
    pub s: i32,
    /// Of the components of D, which are less than 2³¹ units.
    pub d: i32,
    /// Of coordinates: `s + d − 32`, so that the high word of s·D is a coordinate. Those of M, where its ray
    /// meets the solid, and those of the solid are less than 2³⁰ units, and there are at most 26 bits.
    pub p: i32,
    /// Of the coordinates of all rays of the row, as far along them as a probe looks, whether a ray meets the
    /// solid or not: those of M and of s·D are less than 2²⁹ units there. It is three less than p or lower.
    pub w: i32,
}

/// A cap or a ring, and what decides whether a ray passes through it.
pub(crate) struct Flat {
    /// Its height, in units of 2^−w, with [`Numbers::w`].
    pub z: i32,
    /// The r² of its rims, in units of 2^(−2·w).
    pub inner: i64,
    pub outer: i64,
    /// The tolerance, in units of 2^(−28 − d).
    pub tolerance: i64,
    /// The least |dz| at which the row decides a pixel, in units of 2^−d.
    pub least: i32,
    /// The s at which the rays begin, in units of 2^(d − w − 32).
    pub start: i32,
    /// It is seen from above if this is 1, and from below if it is −1.
    pub up: f32,
}

impl Default for Flat {
    /// One that no ray passes through.
    // Not all zero: zeros would be written by `memclr`, which no other part of the crate needs.
    fn default() -> Self {
        Self { z: 0, inner: 1, outer: 0, tolerance: i64::MAX, least: i32::MAX, start: 0, up: 1.0 }
    }
}

/// The s of a tracked root, in units of `unit`.
#[derive(Clone, Copy)]
pub(crate) struct Length {
    pub units: i32,
    pub unit: f32,
}

impl Length {
    /// The length as a float. This takes a conversion and a product, so it is called only for pixels that
    /// need the number.
    #[inline(always)]
    pub fn float(self) -> f32 {
        self.units as f32 * self.unit
    }
}

impl Numbers {
    /// Whether a root is certified by how fast its ray approaches the axis. Without an FPU that test, in
    /// floats, would cost half of the probe that it saves.
    pub const HAS_APPROACH: bool = false;

    /// How many pixels at most are tracked in one call. From pixel to pixel M and D are changed by an
    /// addition. The additions are exact; how far rounding of what is added can move a point is part of
    /// [`Numbers::slip`].
    pub const MOST_PIXELS: u32 = 128;

    /// The format for a row, given its `span`, a bound of D², and a bound of |M|.
    pub const fn new(span: f32, longest: f32, far: f32) -> Self {
        // |s| ≤ span < 2^s; and if D² < 2^E, then |D| < 2^(E/2) ≤ 2^d.
        let d = (exponent(longest) + 1) >> 1;
        let s = if exponent(span) > 3 - d { exponent(span) } else { 3 - d };
        // No point of the solid is farther from the origin than span·|D|. So |M| ≤ 2·span·|D| where the ray
        // meets the solid: less than 2^(1 + s + d), which is 2³⁰ units. A probe looks as far as 5·span.
        let (p, most) = (29 - s - d, 29 - exponent(far));
        Self { s: 30 - s, d: 31 - d, p, w: if p - 3 < most { p - 3 } else { most } }
    }

    /// The bits of a tracked root's s as an integer, in units of 2^−n with the n of [`Numbers::s`].
    #[inline(always)]
    pub fn bits(self, s: f32) -> u32 {
        fixed(s, self.s) as u32
    }

    /// How far rounding can move a point in this arithmetic, given how far it can in floats. The two add up,
    /// since M and D are floats before they are integers.
    ///
    /// A coordinate of M is rounded by half a unit of 2^−w, and so is its change times the pixel's number;
    /// the sum is rounded down: 2 units. A component of D is rounded by half a unit of 2^−d; its change,
    /// which has three bits fewer, times the pixel's number by four units; the sum is rounded down: 5.5
    /// units.
    ///
    /// - In a probe, |s| is less than a sixth of 2³²: the errors of M, of a sixth of D, and of the
    ///   product s·D, which is rounded down, are less than 4 units of 2^−w together.
    /// - In the loop, a change is rounded by half a unit of 2^−p, and of 2^−d, and added up to 128 times
    ///   ([`Numbers::MOST_PIXELS`]); |s| is less than a quarter of 2³², and two products are
    ///   rounded down. Beside M's 2 units of 2^−w that is 64 + (5.5 + 64)/4 + 2 units of 2^−p.
    pub const fn slip(self, slip: f32) -> f32 {
        slip + 84.0 * power_of_two(-self.p) + 4.0 * power_of_two(-self.w)
    }
}
