//! What a ray sees of the surface, and in what light.

use super::{exponent, fixed, fixed_vector, high, inverse_root, square};
use crate::arithmetic::Share;
use crate::vector::{F32x3, difference, dot, largest, scale, vector};

/// A visible sample of the surface.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    pub direction: Direction,
}

/// A direction: a vector along it, whose length is from 1/2 to 1.
#[derive(Clone, Copy)]
pub(crate) struct Direction {
    /// Its components, in units of 2⁻³⁰.
    pub along: [i32; 3],
    /// One over its length, in units of 2⁻²⁹.
    pub per_length: i32,
}

/// What [`Seen::pairs`] returns.
pub(crate) type Pair = (i32, i32);

/// The direction to the light in a solid's own space, and the light's share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ToLight {
    /// A unit vector, in units of 2⁻³¹.
    unit: [i32; 3],
    /// In units of 2⁻³¹.
    direct: i32,
}

/// The cosine of an angle, in units of 2⁻²⁸.
#[derive(Clone, Copy)]
pub(crate) struct Cosine(i32);

/// How shiny a surface is: the exponent of the highlight, or zero if there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gloss {
    pub exponent: u8,
}

/// The directions of a row's rays in a solid's own space: `first` that of column 0, `change` the difference
/// from one column to the next.
#[derive(Clone, Copy)]
pub(crate) struct Views {
    /// In units in which no component of any of the directions exceeds 2²⁹.
    first: [i32; 3],
    /// In units of 2^−`finer` of those: rounding, times a column's number, is half a unit of `first` at most.
    change: [i32; 3],
    finer: u32,
}

impl ToLight {
    /// No light: a zero vector.
    pub const NONE: Self = Self { unit: [0; 3], direct: 0 };

    /// From the unit vector that points to the light, and the light's share, `direct`, which is from 0 to 1.
    #[inline(always)]
    pub const fn new(unit: F32x3, direct: f32) -> Self {
        Self { unit: fixed_vector(unit, 31), direct: fixed(direct, 31) }
    }

    /// The mirror image of this direction in a plane with the normal n, which need not be a unit vector.
    pub const fn mirrored(self, n: F32x3) -> Self {
        let [x, y, z] = self.unit;
        let to_light = scale(vector([x as f32, y as f32, z as f32]), 1.0 / (1_u32 << 31) as f32);
        let image = difference(to_light, scale(n, 2.0 * dot(n, to_light) / dot(n, n)));
        Self { unit: fixed_vector(image, 31), direct: self.direct }
    }
}

impl Gloss {
    /// The gloss with this exponent of the highlight.
    pub const fn new(exponent: u8) -> Self {
        Self { exponent }
    }
}

impl Views {
    /// The directions of a matt solid, which has no highlight: any.
    // These numbers are not zero, because the compiler would write zeros by a call of `memclr`, a function that
    // the crate links for no other purpose.
    pub const NONE: Self = Self { first: [1; 3], change: [1; 3], finer: 1 };

    /// The directions of the columns before `end`.
    #[inline(always)]
    pub fn new(first: F32x3, change: F32x3, end: u32) -> Self {
        let finer = u32::BITS - end.leading_zeros();
        // Each of the two terms of a direction is less than 2^most.
        let most = exponent(largest(first)).max(exponent(largest(change)) + finer as i32);
        let (first, change) =
            (fixed_vector(first, 28 - most), fixed_vector(change, 28 - most + finer as i32));
        Self { first, change, finer }
    }

    /// The direction of a column's ray.
    fn of(&self, column: u32) -> Direction {
        let change = self.change.map(|change| ((i64::from(change) * i64::from(column)) >> self.finer) as i32);
        Direction::new([self.first[0] + change[0], self.first[1] + change[1], self.first[2] + change[2]])
    }
}

impl Direction {
    /// The direction of a vector, no component of which may exceed 2²⁹. A zero vector remains zero; its
    /// length counts as 1/2.
    fn new(mut along: [i32; 3]) -> Self {
        let mut square = square(along);
        // With a square from 2⁵⁸ to 2⁶⁰ the length is from 2²⁹ to 2³⁰ units, that is from 1/2 to 1. No
        // component is larger than the length.
        while square < 1 << 58 && square > 0 {
            (along, square) = (along.map(|x| x << 1), square << 2);
        }
        // A zero vector has no direction; its length counts as 1/2.
        let square = square.clamp(1 << 58, (1 << 60) - 1);
        let square = (square >> 30) as i32;
        Self { along, per_length: inverse_root(square) }
    }

    /// The scalar product of the unit vector in this direction and another vector, whose length may be at
    /// most 1: in units of 2⁻²⁸, if the other vector is given in units of 2⁻³¹.
    #[inline]
    fn dot(&self, [x, y, z]: [i32; 3]) -> i32 {
        let [along_x, along_y, along_z] = self.along;
        let product = high(along_x, x) + high(along_y, y) + high(along_z, z);
        high(product << 2, self.per_length)
    }
}

/// What the loop of a tracked root finds of a visible sample: here the sample itself, with the length of its
/// normal. (In floats it leaves that length to be computed later.)
pub(crate) type Normal = Seen;

impl Seen {
    /// Returns the sample itself. (In floats, the sample that has this normal.)
    #[inline(always)]
    pub fn seen(&self) -> Self {
        *self
    }

    /// The sample whose normal points along `gradient`. The squared length of `gradient` must be a normal
    /// number: positive, and neither subnormal nor infinite.
    #[inline(never)]
    pub fn new(gradient: F32x3) -> Self {
        let bits = 29 - exponent(largest(gradient));
        Self { direction: Direction::new(fixed_vector(gradient, bits)) }
    }

    /// The sample as two pairs of numbers, which a function that is not inlined takes in registers. It would
    /// take the sample itself by reference, and so the loop would store each sample on the stack, whether it
    /// calls the function or not.
    #[inline(always)]
    pub fn pairs(&self) -> [Pair; 2] {
        let Direction { along: [x, y, z], per_length } = self.direction;
        [(x, y), (z, per_length)]
    }

    /// The sample of these [`pairs`](Seen::pairs).
    #[inline(always)]
    pub fn of_pairs([(x, y), (z, per_length)]: [Pair; 2]) -> Self {
        Self { direction: Direction { along: [x, y, z], per_length } }
    }

    /// The sample of a cap or a ring, seen from above if `up` is 1, and from below if it is −1: its normal
    /// points to the side from which it is seen.
    pub fn flat(up: f32) -> Self {
        let z = if up > 0.0 { 1 << 29 } else { -1 << 29 };
        Self { direction: Direction { along: [0, 0, z], per_length: 1 << 30 } }
    }

    /// The cosine of the angle between the normal and the direction to the light.
    #[inline(always)]
    pub fn cosine(&self, to_light: &ToLight) -> Cosine {
        Cosine(self.direction.dot(to_light.unit))
    }
}

impl Cosine {
    /// The light on the surface as a share; zero where the surface faces away from the light.
    #[inline(always)]
    pub fn share(self, to_light: &ToLight) -> Share {
        Share::of_units(high(self.positive(), to_light.direct))
    }

    /// The cosine in units of 2⁻³¹, zero if it is negative.
    #[inline(always)]
    fn positive(self) -> i32 {
        self.0.clamp(0, (1 << 28) - 1) << 3
    }
}

impl Views {
    /// Phong's highlight with a coefficient of ½, as a share: ½·cosⁿ, where n is the exponent of `gloss`, and
    /// the cosine that of the angle between the direction to the light, mirrored at the normal, and the
    /// direction from the surface to the eye along the column's ray. `cosine` is [`Seen::cosine`] of `seen`
    /// and `to_light`. The highlight is zero where the surface faces away from the light, or the mirrored
    /// light away from the eye.
    #[cold]
    #[inline(never)]
    pub fn highlight(
        &self,
        column: u32,
        seen: &Seen,
        Cosine(cosine): Cosine,
        to_light: &ToLight,
        gloss: &Gloss,
    ) -> Share {
        if cosine <= 0 {
            return Share::NONE;
        }
        let (normal, view) = (seen.direction, self.of(column));
        // r·v, where r is the light's direction mirrored at the normal, and v the direction towards the eye.
        // Scalar products have 28 bits behind the point, except n·v, which has 27: the second vector of this
        // one is a direction, whose components have 30 bits, not 31.
        let nv = high(normal.dot(view.along) << 3, view.per_length);
        let rv = view.dot(to_light.unit) - (high(cosine << 2, nv << 3) << 1);
        let (mut x, mut product, mut exponent) = (Cosine(rv).positive(), i32::MAX, gloss.exponent);
        while exponent > 0 {
            if exponent & 1 == 1 {
                product = high(product, x) << 1;
            }
            x = high(x, x) << 1;
            exponent >>= 1;
        }
        Share::of_units(product >> 2)
    }
}
