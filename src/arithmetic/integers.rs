//! Pixels in 32-bit integers, for machines without an FPU: numbers in fixed point, with as many bits behind
//! the point as the bounds of a row leave.
//!
//! Products are the high words of 32-bit factors, which is one instruction where the core has it.

mod fixed;
mod inverse_root;
mod seen;

pub(crate) use fixed::{exponent, fixed, fixed_vector, high, power_of_two, wide_square};
pub(crate) use inverse_root::{inverse_root, square};
pub(crate) use seen::{Cosine, Direction, Gloss, Pair, Seen, ToLight, Views};

/// How the numbers of a sweep are held: how many bits stand behind the point.
#[derive(Clone, Copy)]
pub(crate) struct Numbers {
    /// Of s. On the solid |s| is less than 2³⁰ units.
    pub s: i32,
    /// Of the components of D, which are less than 2³¹ units.
    pub d: i32,
    /// Of coordinates: `s + d − 32`, so that the high word of s·D is a coordinate. Those of M, where its ray
    /// meets the solid, and those of the solid are less than 2³⁰ units, and there are at most 26 bits.
    pub p: i32,
}

/// The s of a tracked root, in units of `unit`.
#[derive(Clone, Copy)]
pub(crate) struct Length {
    pub units: i32,
    pub unit: f32,
}

impl Length {
    /// The length as a float. It takes a conversion and a product: where a pixel does not need it, it is not
    /// computed.
    #[inline(always)]
    pub fn float(self) -> f32 {
        self.units as f32 * self.unit
    }
}

impl Numbers {
    /// How the numbers of a row are held, given its `span` and a bound of D².
    pub fn new(span: f32, longest: f32) -> Self {
        // |s| ≤ span < 2^s; and if D² < 2^E, then |D| < 2^(E/2) ≤ 2^d.
        let d = (exponent(longest) + 1) >> 1;
        let s = exponent(span).max(3 - d);
        // No point of the solid is farther from the origin than span·|D|. So |M| ≤ 2·span·|D| where the ray
        // meets the solid: less than 2^(1 + s + d), which is 2³⁰ units.
        Self { s: 30 - s, d: 31 - d, p: 29 - s - d }
    }

    /// How far rounding can move a point, given how far it does in floats, which is added: M and D are
    /// floats before they are integers.
    ///
    /// A coordinate of M is rounded by half a unit; so is its change from pixel to pixel, which is added up
    /// to 64 times ([`MOST_PIXELS`](crate::lathe::MOST_PIXELS)). One of D is rounded as often; multiplied by
    /// s, less than 2³⁰ units, that is a quarter as much. Two products are rounded down. Together: 32.5·(1 +
    /// ¼) + 2 units.
    pub fn slip(self, slip: f32) -> f32 {
        slip + 43.0 * power_of_two(-self.p)
    }
}
