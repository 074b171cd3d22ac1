//! One segment of a lathe: its cubic, and bounds on it.

use crate::arithmetic::Wall;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::{greater, lesser};
use crate::profile::ProfilePiece;

/// One segment of a lathe: a cubic piece of the profile, prepared for rays.
/// [`Lathe::turn`](crate::Lathe::turn) makes it.
///
/// In this version a segment takes 76 bytes of flash, or of memory if it is not a `static`; 96 in the
/// arithmetic of integers, where the machine has no FPU. Other versions may differ.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Segment {
    // All lengths are in the lathe's frame. "By height" means over z, other derivatives are over u.
    /// The height of the lower end.
    pub(super) low: f32,
    /// The height of the upper end.
    pub(super) high: f32,
    /// 1/h, `h = high − low`. Infinite where the two heights are the same number in the frame.
    pub(super) per_height: f32,
    /// The power coefficients of the squared radius, `f0 + f1·u + f2·u² + f3·u³`.
    pub(super) f: [f32; 4],
    /// The Bernstein ordinates of the squared radius: accurate near u = 1, too, where the powers cancel.
    pub(super) b: [f32; 4],
    /// The height at which the segment is narrowest.
    pub(super) narrowest: f32,
    /// The squared radius of the bounding cylinder: the segment's largest squared radius, [`widened`].
    pub(super) bounding_square: f32,
    /// An upper bound of half the second derivative of the squared radius by height. It is negative where
    /// that derivative is negative all along the segment.
    pub(super) convexity: f32,
    /// The slope jump at the upper end: by how much the first derivative by height is larger where the next
    /// segment begins than where this one ends, or zero if it is not larger. Infinite at a *step*.
    pub(super) slope_jump: f32,
    /// An upper bound of the magnitude of the first derivative by height. NaN or infinite for a segment of no
    /// height.
    pub(super) max_slope: f32,
    /// The largest magnitude of half the second derivative by height. NaN or infinite for a segment of no
    /// height.
    pub(super) curvature: f32,
    /// `[f1/2, 3·f3/2]`, for [`Segment::about`].
    half: [f32; 2],
    /// The cubic in the arithmetic of rows, if that is not floats.
    pub(super) wall: Wall,
}

/// The larger of two numbers; NaN if `a` or `b` is NaN.
///
/// A segment whose height is zero in the frame has a `max_slope` of NaN or infinity.
/// Then the lathe's largest slope and its tolerance in g are NaN or infinite, too. With such a tolerance the
/// fast path decides only on rays that miss the bounding cylinder.
pub(super) const fn greater_or_nan(a: f32, b: f32) -> f32 {
    if a > b || a.is_nan() { a } else { b }
}

/// An upper bound of the magnitude of a quadratic on [0, 1], given its Bernstein ordinates.
///
/// With a = e0 − e1 and b = e2 − e1 the quadratic has its vertex at u = a/(a + b), and there the value
/// `e1 + a·b/(a + b)`. The vertex lies inside if a and b have the same sign. That value is off by 6 units of
/// 2⁻²⁴ of the largest ordinate at most.
const fn quadratic_magnitude([e0, e1, e2]: [f32; 3]) -> f32 {
    let (a, b) = (e0 - e1, e2 - e1);
    let ends = e0.abs().max(e2.abs());
    let size = ends.max(e1.abs());
    if a * b > 0.0 {
        ends.max((e1 + a * b / (a + b)).abs() + 8.0 * UNIT_ROUNDOFF * size).min(size)
    } else {
        size
    }
}

/// A squared radius r², enlarged by 2⁻⁹ of itself for a bounding cylinder. A point that is computed to be on
/// that cylinder or outside it is outside the solid, because the enlargement exceeds the rounding errors.
///
/// In units of 2⁻²⁴ the enlargement is 2¹⁵·r². If r is the lathe's largest radius, which is at least 1,
/// rounding changes x² + y² and r² together by at most 33·r² + 4·D, where D is the distance of the ray's
/// origin (see [`frame::LENGTH_TOLERANCE`](super::frame::LENGTH_TOLERANCE)). That is less than 2¹⁵·r² up to D
/// = (2¹³ − 9)·r. If the origin is farther away, or if r is so small a part of the largest radius that
/// rounding takes more than 2⁻⁹ of r², a ray that hits may be passed over. Such a ray is as near to the
/// silhouette as rounding can displace it.
pub(super) const fn widened(square: f32) -> f32 {
    square * (1.0 + 1.0 / 512.0)
}

/// The power of two p for which `p²·square` is in [1, 4), given a positive normal `square`.
pub(super) const fn power_of_two_for(square: f32) -> f32 {
    let exponent = (square.to_bits() >> 23) as i32 - 127;
    f32::from_bits(((127 - exponent.div_euclid(2)) << 23) as u32)
}

impl Segment {
    /// A segment that no ray meets, for spare capacity: it begins above every height.
    pub(super) const EMPTY: Self = Self {
        low: f32::INFINITY,
        high: 0.0,
        per_height: 0.0,
        f: [0.0; 4],
        b: [0.0; 4],
        narrowest: 0.0,
        bounding_square: 0.0,
        convexity: 0.0,
        slope_jump: 0.0,
        max_slope: 0.0,
        curvature: 0.0,
        half: [0.0; 2],
        wall: Wall::EMPTY,
    };

    /// A segment in the frame, given its piece of the profile, the height of the frame's origin and the
    /// frame's scale. It has no slope jump yet.
    pub(super) const fn new(piece: &ProfilePiece, middle: f32, scale: f32) -> Self {
        let square = scale * scale;
        let [b0, b1, b2, b3] = piece.b;
        let b = [b0 * square, b1 * square, b2 * square, b3 * square];
        let (low, high) = ((piece.z - middle) * scale, (piece.top - middle) * scale);
        let per_height = 1.0 / (high - low);
        let f = crate::cubic::Cubic::from_bernstein(b).c;
        let [_, _, c2, c3] = f;
        Self {
            low,
            high,
            per_height,
            f,
            b,
            narrowest: low + piece.narrowest * (high - low),
            bounding_square: widened(piece.largest * square),
            // The second derivative of a cubic is linear, and so largest at an end.
            convexity: greater_or_nan(c2, c2 + 3.0 * c3) * per_height * per_height,
            slope_jump: 0.0,
            max_slope: 3.0 * quadratic_magnitude([b[1] - b[0], b[2] - b[1], b[3] - b[2]]) * per_height,
            curvature: greater_or_nan(c2.abs(), (c2 + 3.0 * c3).abs()) * per_height * per_height,
            half: [0.5 * f[1], 1.5 * f[3]],
            wall: Wall::new(f, per_height),
        }
    }

    /// This segment with its `slope_jump` computed, given the next segment.
    pub(super) const fn before(self, next: &Self) -> Self {
        let is_step = self.b[3] != next.b[0];
        Self { slope_jump: if is_step { f32::INFINITY } else { self.slope_jump_to(next) }, ..self }
    }

    /// By how much the first derivative by height is larger where the next segment begins than where this one
    /// ends, or zero if it is not larger. NaN if one of the two is NaN.
    pub(super) const fn slope_jump_to(&self, next: &Self) -> f32 {
        let jump =
            3.0 * (next.b[1] - next.b[0]) * next.per_height - 3.0 * (self.b[3] - self.b[2]) * self.per_height;
        if jump <= 0.0 { 0.0 } else { jump }
    }

    /// What a gradient's components across the axis, `(k·x, y)`, and along it, `−f′(u)/2`, are multiplied by:
    /// h and 1, or 1 and 1/h, neither more than 1. So none overflows, however flat or tall the segment is.
    #[inline(always)]
    pub(super) fn weights(&self) -> (f32, f32) {
        let height = self.high - self.low;
        if height < 1.0 { (height, 1.0) } else { (1.0, self.per_height) }
    }

    /// The squared radius at the upper end, or at the lower: the same bits as the neighbour has there, unless
    /// there is a step between them.
    #[inline(always)]
    pub(super) fn end(&self, upper: bool) -> f32 {
        let [lower, .., last] = self.b;
        if upper { last } else { lower }
    }

    /// The parameter u at a height of the frame, clamped to [0, 1]; 0 if the quotient is NaN.
    #[inline]
    pub(super) fn parameter(&self, z: f32) -> f32 {
        let u = (z - self.low) * self.per_height;
        lesser(1.0, greater(0.0, u))
    }

    /// The squared radius and its derivative over u, for 0 ≤ u ≤ 1, by de Casteljau's interpolations: where
    /// no ordinate is negative, the squared radius is off by at most 10 units of 2⁻²⁴ of itself (see
    /// [`Bernstein::at`](crate::Bernstein::at)).
    #[inline]
    pub(super) fn at(&self, u: f32) -> (f32, f32) {
        let [b0, b1, b2, b3] = self.b;
        let v = 1.0 - u;
        let (c0, c1, c2) = (b0 * v + b1 * u, b1 * v + b2 * u, b2 * v + b3 * u);
        let (d0, d1) = (c0 * v + c1 * u, c1 * v + c2 * u);
        (d0 * v + d1 * u, 3.0 * (d1 - d0))
    }

    /// The squared radius along a ray as a cubic in s, the distance from the point of the ray at the height
    /// of u, constant term first: Taylor's formula with κ = du/ds = dz/h, given u and dz,
    ///
    /// `f(u) + f′(u)·κ·s + f″(u)/2·κ²·s² + f₃·κ³·s³`.
    #[inline(always)]
    pub(super) fn along(&self, u: f32, dz: f32) -> [f32; 4] {
        let (f, slope) = self.at(u);
        let kappa = dz * self.per_height;
        let [_, _, f2, f3] = self.f;
        [f, slope * kappa, (3.0 * f3 * u + f2) * (kappa * kappa), f3 * (kappa * kappa * kappa)]
    }

    /// `[f(u), f′(u)/2, f″(u)/2]`, for 0 ≤ u ≤ 1: the squared radius by Horner's rule in Bernstein form, as
    /// accurate as by [`Segment::at`] and cheaper, the halves of its derivatives from the power coefficients.
    #[inline(always)]
    pub(super) fn about(&self, u: f32) -> [f32; 3] {
        let Self { f: [.., f2, _], b: [b0, b1, b2, b3], half: [h0, h2], .. } = *self;
        let v = 1.0 - u;
        let w = u * u;
        let f = ((b0 * v + 3.0 * b1 * u) * v + 3.0 * b2 * w) * v + b3 * (w * u);
        // f′/2 = f1/2 + f2·u + 3·f3/2·u², f″/2 = f2 + 3·f3·u.
        let half = h2 * u;
        let once = half + f2;
        [f, once * u + h0, once + half]
    }
}
