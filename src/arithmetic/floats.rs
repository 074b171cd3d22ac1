//! Pixels in f32, for machines with an FPU.

use super::{RowLimits, Share, integers};
use crate::math::minmax::greater;
use crate::math::rsqrt_of_double;
use crate::vector::{F32x3, Vector, difference, dot, scale, vector};
use core::f32::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Of how many solids a picture keeps what is the same for all of its rows: of none, since an FPU computes it
/// again in the time that loading it takes.
pub(crate) const KEPT: usize = 0;

/// The format of s, D and coordinates in a row: f32, whatever the row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Numbers;

impl Numbers {
    /// Whether a root is certified by how fast its ray approaches the axis.
    pub const HAS_APPROACH: bool = true;

    /// How many pixels at most are tracked in one call: half a row of the usual displays.
    ///
    /// From pixel to pixel M and D are changed by an addition. After 128 additions they are off by 128·2⁻²⁴
    /// of the solid's size at most, and g by four times that, 2⁻¹⁵, which is an eighth of the tolerance.
    pub const MOST_PIXELS: u32 = 128;

    /// The format for a row, given its `span`, a bound of D², and a bound of |M|.
    #[inline(always)]
    pub const fn new(_span: f32, _longest: f32, _far: f32) -> Self {
        Self
    }

    /// Keeps none of these: the rays serve as they are given.
    #[inline(always)]
    pub fn rays(
        self,
        _ray: (F32x3, F32x3),
        _change: (F32x3, F32x3),
        _pixels: u32,
        _limits: &RowLimits,
    ) -> Rays {
        Rays
    }

    /// The bits of the s of a tracked root.
    #[inline(always)]
    pub fn bits(self, s: f32) -> u32 {
        s.to_bits()
    }

    /// How far rounding can move a point in this arithmetic, given how far it can in floats: just as far.
    #[inline(always)]
    pub const fn slip(self, slip: f32) -> f32 {
        slip
    }
}

/// A type without fields: in this arithmetic the rays that a row is set up with serve as they are.
#[derive(Clone, Copy)]
pub(crate) struct Rays;

impl Rays {
    /// Without effect: there are no rays to count backwards.
    #[inline(always)]
    pub fn reverse(&mut self) {}
}

/// A type without fields: in this arithmetic a segment has no cubic beside its coefficients in floats.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Wall;

impl Wall {
    /// That of a spare segment, which no ray meets.
    pub const EMPTY: Self = Self;

    /// That of a segment with the coefficients f and `per_height`.
    pub const fn new(_f: [f32; 4], _per_height: f32) -> Self {
        Self
    }

    /// A cubic that is zero. It is never called for: only the loop in integers asks for a cubic in integers.
    #[inline(always)]
    pub fn in_integers(&self) -> &integers::Wall {
        &integers::Wall::EMPTY
    }
}

/// A cap or a ring at the height z of the frame, of which r² is from `middle − half` to `middle + half`. It
/// is seen from above if `up` is 1, and from below if it is −1.
#[derive(Default)]
pub(crate) struct Flat {
    pub z: f32,
    pub middle: f32,
    pub half: f32,
    pub up: f32,
}

/// The s of a tracked root.
#[derive(Clone, Copy)]
pub(crate) struct Length(pub f32);

impl Length {
    /// The length as a float.
    #[inline(always)]
    pub fn float(self) -> f32 {
        self.0
    }
}

/// A visible sample of the surface.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    /// A vector of any length along the surface normal, on the side that is seen, in object space.
    gradient: F32x3,
    /// One over √2 times the length of `gradient`.
    per_length: f32,
}

/// What [`Seen::pairs`] returns.
pub(crate) type Pair = (f32, f32);

/// The direction to the light in a solid's own space. Its length is √2 times the light's share in the units
/// of a [`Share`]: so its dot product with a normal, times [`Seen::per_length`], is what Lambert's law leaves
/// of that share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ToLight(F32x3);

/// The cosine of the angle between a normal and the direction to the light, times the light's share in the
/// units of a [`Share`].
#[derive(Clone, Copy)]
pub(crate) struct Cosine(f32);

/// How shiny a surface is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gloss {
    /// The exponent of the highlight, or zero if there is none.
    pub exponent: u8,
    /// The square of the least cosine that counts. From a smaller one the highlight would be less than 2⁻²⁰.
    least: f32,
}

/// The directions of a row's rays in a solid's own space: `first` that of column 0, `change` the difference
/// from one column to the next.
#[derive(Clone, Copy)]
pub(crate) struct Views {
    first: F32x3,
    change: F32x3,
}

impl ToLight {
    /// No light: a zero vector.
    pub const NONE: Self = Self(vector([0.0; 3]));

    /// From the unit vector that points to the light, and the light's share, `direct`, which is from 0 to 1.
    #[inline(always)]
    pub const fn new(unit: F32x3, direct: f32) -> Self {
        Self(scale(unit, direct * (SQRT_2 * Share::UNITS)))
    }

    /// The mirror image of this direction in a plane with the normal n, which need not be a unit vector.
    #[inline(always)]
    pub const fn mirrored(self, n: F32x3) -> Self {
        Self(difference(self.0, scale(n, 2.0 * dot(n, self.0) / dot(n, n))))
    }
}

impl Gloss {
    /// The gloss with this exponent of the highlight.
    pub const fn new(exponent: u8) -> Self {
        // For x < 1, ln x ≤ 2·(x − 1)/(x + 1). So half of xˢ is less than 2⁻²⁰ if x is less than
        // (s − h)/(s + h), where h = 19·ln 2/2.
        const HALF: f32 = 6.6;
        let s = exponent as f32;
        let least = greater(0.0, (s - HALF) / (s + HALF));
        Self { exponent, least: least * least }
    }
}

impl Views {
    /// The directions of a matt solid, which has no highlight: any.
    // These numbers are not zero, because the compiler would write zeros by a call of `memclr`, a function that
    // the crate links for no other purpose.
    pub const NONE: Self = Self { first: vector([1.0; 3]), change: vector([1.0; 3]) };

    /// The directions of the columns before `end`.
    #[inline(always)]
    pub fn new(first: F32x3, change: F32x3, _end: u32) -> Self {
        Self { first, change }
    }
}

/// What the loop of a tracked root finds of a visible sample: a vector along the normal, as in [`Seen`]. Its
/// length is left to where the sample is lit: there other work fills the cycles in which the FPU would wait.
pub(crate) struct Normal(pub F32x3);

impl Normal {
    /// The sample that has this normal.
    #[inline(always)]
    pub fn seen(&self) -> Seen {
        Seen::new(self.0)
    }
}

impl Seen {
    /// The sample whose normal points along `gradient`. The squared length of `gradient` must be a normal
    /// number: positive, and neither subnormal nor infinite.
    #[inline(always)]
    pub fn new(gradient: F32x3) -> Self {
        let F32x3 { x, y, z } = gradient;
        let (yy, zz) = (y * y, z * z);
        Self { gradient, per_length: rsqrt_of_double(x * x + yy + zz) }
    }

    /// The sample as two pairs of numbers, which a function that is not inlined takes in registers. It would
    /// take the sample itself by reference, and so the loop would store each sample on the stack, whether it
    /// calls the function or not.
    #[inline(always)]
    pub fn pairs(&self) -> [Pair; 2] {
        let Self { gradient: F32x3 { x, y, z }, per_length } = *self;
        [(x, y), (z, per_length)]
    }

    /// The sample of these [`pairs`](Seen::pairs).
    #[inline(always)]
    pub fn of_pairs([(x, y), (z, per_length)]: [Pair; 2]) -> Self {
        Self { gradient: vector([x, y, z]), per_length }
    }

    /// The sample of a cap or a ring, seen from above if `up` is 1, and from below if it is −1: its normal
    /// points to the side from which it is seen.
    #[inline(always)]
    pub fn flat(up: f32) -> Self {
        Self { gradient: vector([0.0, 0.0, up]), per_length: FRAC_1_SQRT_2 }
    }

    /// The cosine of the angle between the normal and the direction to the light, times the light's share.
    #[inline(always)]
    pub fn cosine(&self, ToLight(to_light): &ToLight) -> Cosine {
        let (n, l) = (self.gradient, to_light);
        // In this order no sum waits for a product, see the loop of a tracked root.
        let (x, y, z) = (n.x * l.x, n.y * l.y, n.z * l.z);
        Cosine(self.per_length * (x + y + z))
    }
}

impl Cosine {
    /// The light on the surface as a share; zero where the surface faces away from the light.
    #[inline(always)]
    pub fn share(self, _: &ToLight) -> Share {
        // `Share::new` makes a negative number zero.
        Share::new(self.0)
    }
}

impl Views {
    /// Phong's highlight with a coefficient of ½, as a share: ½·cosⁿ, where n is the exponent of `gloss`, and
    /// the cosine that of the angle between the direction to the light, mirrored at the normal, and the
    /// direction from the surface to the eye along the column's ray. `cosine` is [`Seen::cosine`] of `seen`
    /// and `to_light`. The highlight is zero where the surface faces away from the light, or the mirrored
    /// light away from the eye, or where the cosine is less than the least that counts.
    #[inline(always)]
    pub fn highlight(
        &self,
        column: u32,
        seen: &Seen,
        Cosine(cosine): Cosine,
        ToLight(to_light): &ToLight,
        gloss: &Gloss,
    ) -> Share {
        let Seen { gradient, per_length } = *seen;
        if !(cosine > 0.0) {
            return Share::NONE;
        }
        let view = self.first + self.change * column as f32;
        // r·v, where r is the light's direction mirrored at the normal, and v the direction towards the eye.
        // It has the right sign before the two are made unit vectors.
        let twice = 4.0 * cosine * per_length;
        let rv = to_light.dot(view) - twice * gradient.dot(view);
        if !(rv > 0.0) {
            return Share::NONE;
        }
        let square = view.dot(view) * to_light.dot(*to_light);
        if !(rv * rv > gloss.least * square) {
            return Share::NONE;
        }
        let rv = rv * (SQRT_2 * rsqrt_of_double(square));
        Share::of_one(0.5 * power(rv, gloss.exponent))
    }
}

/// x to a whole power, by repeated squaring.
fn power(mut x: f32, mut exponent: u8) -> f32 {
    let mut product = 1.0;
    while exponent > 0 {
        if exponent & 1 == 1 {
            product *= x;
        }
        x *= x;
        exponent >>= 1;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::{Gloss, power};
    use crate::math::{Libm, Math};

    #[test]
    fn a_highlight_that_does_not_count_is_small() {
        for exponent in 1..=u8::MAX {
            let most = 0.5 * power(Libm::sqrt(Gloss::new(exponent).least), exponent);
            assert!(most < 1.0 / 1_048_576.0, "{exponent}: {most}");
            assert!(exponent < 30 || most > 0.5 / 1_048_576.0, "{exponent}: {most}");
        }
    }
}
