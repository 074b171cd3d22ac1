use crate::math::minmax::{greater, lesser};
use crate::profile::Span;

/// One segment of a lathe, in the lathe's frame. Made by [`Lathe::turn`](crate::Lathe::turn).
///
/// In this version a segment takes 76 bytes of flash, or of memory if it is not a `static`; others may differ.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Segment {
    pub(super) low: f32,
    pub(super) high: f32,
    /// 1/(high − low).
    pub(super) per_height: f32,
    /// Squared radius, `f0 + f1·u + f2·u² + f3·u³`.
    pub(super) f: [f32; 4],
    /// The same as Bernstein ordinates: accurate near u = 1, too, where the powers cancel.
    pub(super) b: [f32; 4],
    /// The height at which the segment is narrowest.
    pub(super) narrowest: f32,
    /// The square of the radius of a cylinder around the segment, wide enough that a point on it is outside
    /// whatever rounding does.
    pub(super) reach: f32,
    /// Half the largest second derivative of the squared radius by height.
    pub(super) bulge: f32,
    /// By how much the first jumps upwards where this segment ends and the next begins, or zero.
    pub(super) kink: f32,
    /// Three times the two inner ordinates, and half of f1 and three halves of f3: what a glance needs of them.
    inner: [f32; 2],
    half: [f32; 2],
}

/// The larger of two numbers, or that which is none: what a segment of no height in the frame leaves unknown stays so.
pub(super) const fn larger(a: f32, b: f32) -> f32 {
    if a > b || a.is_nan() { a } else { b }
}

/// A squared radius widened by 2⁻⁹, a thousand times the rounding of anything compared with it.
pub(super) const fn widened(square: f32) -> f32 {
    square * (1.0 + 1.0 / 512.0)
}

/// The power of two whose square brings `square` into [1, 4).
pub(super) const fn power_of_two_for(square: f32) -> f32 {
    let exponent = (square.to_bits() >> 23) as i32 - 127;
    f32::from_bits(((127 - exponent.div_euclid(2)) << 23) as u32)
}

impl Segment {
    /// Above everything.
    pub(super) const EMPTY: Self = Self {
        low: f32::INFINITY,
        high: 0.0,
        per_height: 0.0,
        f: [0.0; 4],
        b: [0.0; 4],
        narrowest: 0.0,
        reach: 0.0,
        bulge: 0.0,
        kink: 0.0,
        inner: [0.0; 2],
        half: [0.0; 2],
    };

    pub(super) const fn new(span: &Span, middle: f32, scale: f32) -> Self {
        let square = scale * scale;
        let [b0, b1, b2, b3] = span.b;
        let b = [b0 * square, b1 * square, b2 * square, b3 * square];
        let (low, high) = ((span.z - middle) * scale, (span.top - middle) * scale);
        let per_height = 1.0 / (high - low);
        let f = crate::cubic::Cubic::from_bernstein(b).c;
        let [_, _, c2, c3] = f;
        Self {
            low,
            high,
            per_height,
            f,
            b,
            narrowest: low + span.narrowest * (high - low),
            reach: widened(span.largest * square),
            // The second derivative of a cubic is largest at an end.
            bulge: larger(c2, c2 + 3.0 * c3) * per_height * per_height,
            kink: 0.0,
            inner: [3.0 * b[1], 3.0 * b[2]],
            half: [0.5 * f[1], 1.5 * f[3]],
        }
    }

    /// Half the largest second derivative by height, whatever its sign.
    pub(super) const fn curvature(&self) -> f32 {
        let [_, _, c2, c3] = self.f;
        larger(c2.abs(), (c2 + 3.0 * c3).abs()) * self.per_height * self.per_height
    }

    /// A bound on the first derivative by height, whatever its sign.
    pub(super) const fn steepest(&self) -> f32 {
        let [b0, b1, b2, b3] = self.b;
        3.0 * (b1 - b0).abs().max((b2 - b1).abs()).max((b3 - b2).abs()) * self.per_height
    }

    /// The same, before another.
    pub(super) const fn before(self, next: &Self) -> Self {
        let jump =
            3.0 * (next.b[1] - next.b[0]) * next.per_height - 3.0 * (self.b[3] - self.b[2]) * self.per_height;
        Self { kink: if jump <= 0.0 { 0.0 } else { jump }, ..self }
    }

    /// The squared radius at the upper end, or the lower: a neighbour has the same number there.
    #[inline(always)]
    pub(super) fn end(&self, upper: bool) -> f32 {
        let [lower, .., last] = self.b;
        if upper { last } else { lower }
    }

    /// The profile's parameter at a height of the frame, held to the segment.
    #[inline]
    pub(super) fn parameter(&self, z: f32) -> f32 {
        let u = (z - self.low) * self.per_height;
        lesser(1.0, greater(0.0, u))
    }

    /// The squared radius and its derivative by u, in Bernstein form, 0 ≤ u ≤ 1: exact to a few units of 2⁻²⁴
    /// where no ordinate is negative.
    #[inline]
    pub(super) fn at(&self, u: f32) -> (f32, f32) {
        let [b0, b1, b2, b3] = self.b;
        let v = 1.0 - u;
        let (c0, c1, c2) = (b0 * v + b1 * u, b1 * v + b2 * u, b2 * v + b3 * u);
        let (d0, d1) = (c0 * v + c1 * u, c1 * v + c2 * u);
        (d0 * v + d1 * u, 3.0 * (d1 - d0))
    }

    /// The squared radius at the heights of a ray, in powers of the distance s from where that has the parameter u:
    /// Taylor's formula, κ = du/ds = dz/h.
    #[inline(always)]
    pub(super) fn along(&self, u: f32, dz: f32) -> [f32; 4] {
        let (f, slope) = self.at(u);
        let kappa = dz * self.per_height;
        let [_, _, f2, f3] = self.f;
        [f, slope * kappa, (3.0 * f3 * u + f2) * (kappa * kappa), f3 * (kappa * kappa * kappa)]
    }

    /// The squared radius at u, and halves of its first two derivatives: by Horner's rule in Bernstein form, as exact as
    /// [`Segment::at`], and in powers.
    #[inline(always)]
    pub(super) fn about(&self, u: f32) -> [f32; 3] {
        let Self { f: [b0, _, f2, _], inner: [b1, b2], b: [.., b3], half: [h0, h2], .. } = *self;
        let v = 1.0 - u;
        let w = u * u;
        let f = ((b0 * v + b1 * u) * v + b2 * w) * v + b3 * (w * u);
        let turn = h2 * u;
        let lean = turn + f2;
        [f, lean * u + h0, lean + turn]
    }
}
