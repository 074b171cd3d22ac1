//! Vectors in object or world space: micromath's [`F32x3`], and as `const fn`s those of its operations that
//! constants need. Callers of the crate give and get arrays, `[x, y, z]`.

pub(crate) use micromath::vector::{F32x3, Vector};

use crate::math::const_fn;
use crate::math::minmax::{greater, lesser};

/// The vector of three components.
pub(crate) const fn vector([x, y, z]: [f32; 3]) -> F32x3 {
    F32x3 { x, y, z }
}

/// The three components of a vector.
pub(crate) const fn array(F32x3 { x, y, z }: F32x3) -> [f32; 3] {
    [x, y, z]
}

/// Whether no component is infinite or NaN: the exponents of those are all ones.
#[inline(always)]
pub(crate) const fn finite(v: F32x3) -> bool {
    const ONES: u32 = 0xff << 23;
    let F32x3 { x, y, z } = v;
    x.to_bits() & ONES != ONES && y.to_bits() & ONES != ONES && z.to_bits() & ONES != ONES
}

/// The vector with its components made finite: −∞ and NaN become `f32::MIN`, and +∞ becomes `f32::MAX`.
#[cold]
#[inline(never)]
pub(crate) fn saturated(v: F32x3) -> F32x3 {
    vector([v.x, v.y, v.z].map(|x| lesser(f32::MAX, greater(f32::MIN, x))))
}

/// The scalar product ⟨a, b⟩.
pub(crate) const fn dot(a: F32x3, b: F32x3) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// The scalar product of the x and y components alone.
#[inline(always)]
pub(crate) const fn dot_xy(a: F32x3, b: F32x3) -> f32 {
    a.x * b.x + a.y * b.y
}

/// The vector times a number.
pub(crate) const fn scale(v: F32x3, by: f32) -> F32x3 {
    vector([v.x * by, v.y * by, v.z * by])
}

/// a + b.
pub(crate) const fn sum(a: F32x3, b: F32x3) -> F32x3 {
    vector([a.x + b.x, a.y + b.y, a.z + b.z])
}

/// a + b·by. It is always inline: micromath's operators become calls in places, and the vectors that they
/// return are passed in memory.
#[inline(always)]
pub(crate) const fn sum_scaled(a: F32x3, b: F32x3, by: f32) -> F32x3 {
    vector([a.x + b.x * by, a.y + b.y * by, a.z + b.z * by])
}

/// a − b.
pub(crate) const fn difference(a: F32x3, b: F32x3) -> F32x3 {
    vector([a.x - b.x, a.y - b.y, a.z - b.z])
}

/// The vector product a × b.
pub(crate) const fn cross(a: F32x3, b: F32x3) -> F32x3 {
    vector([a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x])
}

/// The sum of the components' magnitudes: an upper bound of the length.
pub(crate) const fn one_norm(v: F32x3) -> f32 {
    v.x.abs() + v.y.abs() + v.z.abs()
}

/// The largest magnitude among the components.
pub(crate) const fn largest(v: F32x3) -> f32 {
    greater(greater(v.x.abs(), v.y.abs()), v.z.abs())
}

/// The vector times a power of two that brings its largest magnitude into [1, 4), and that power. `None` if a
/// component is infinite or NaN, or if no component is a normal number.
///
/// The largest magnitude of the result is in [1, 2), except where that of `v` is 2¹²⁷ or more: the smallest
/// normal power, 2⁻¹²⁶, brings it into [2, 4).
pub(crate) const fn to_one(v: F32x3) -> Option<(F32x3, f32)> {
    let size = largest(v);
    if !(finite(v) && size >= f32::MIN_POSITIVE) {
        return None;
    }
    let exponent = size.to_bits() >> 23;
    let power = f32::from_bits(if exponent < 254 { 254 - exponent } else { 1 } << 23);
    Some((scale(v, power), power))
}

/// The unit vector along `v`. `None` where [`to_one`] is: a component is infinite or NaN, or all are zero or
/// subnormal.
pub(crate) const fn unit(v: F32x3) -> Option<F32x3> {
    match to_one(v) {
        Some((v, _)) => Some(scale(v, 1.0 / const_fn::sqrt(dot(v, v)))),
        None => None,
    }
}
