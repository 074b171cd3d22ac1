use crate::profile::Span;

/// One segment of a lathe, in the lathe's frame. Made by [`Lathe::turn`](crate::Lathe::turn); its size is
/// what a user needs to know.
///
/// ```
/// use embedded_lathe::Segment;
/// assert_eq!(core::mem::size_of::<Segment>(), 52);
/// ```
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
    pub(super) const EMPTY: Self =
        Self { low: 0.0, high: 0.0, per_height: 0.0, f: [0.0; 4], b: [0.0; 4], narrowest: 0.0, reach: 0.0 };

    pub(super) const fn new(span: &Span, middle: f32, scale: f32) -> Self {
        let square = scale * scale;
        let [b0, b1, b2, b3] = span.b;
        let b = [b0 * square, b1 * square, b2 * square, b3 * square];
        let (low, high) = ((span.z - middle) * scale, (span.top - middle) * scale);
        Self {
            low,
            high,
            per_height: 1.0 / (high - low),
            f: crate::cubic::Cubic::from_bernstein(b).c,
            b,
            narrowest: low + span.narrowest * (high - low),
            reach: widened(span.largest * square),
        }
    }

    /// The squared radius and its derivative by u, in Bernstein form, 0 ≤ u ≤ 1: exact to a few units of 2⁻²⁴
    /// where no ordinate is negative.
    #[inline(always)]
    pub(super) fn at(&self, u: f32) -> (f32, f32) {
        let [b0, b1, b2, b3] = self.b;
        let v = 1.0 - u;
        let (c0, c1, c2) = (b0 * v + b1 * u, b1 * v + b2 * u, b2 * v + b3 * u);
        let (d0, d1) = (c0 * v + c1 * u, c1 * v + c2 * u);
        (d0 * v + d1 * u, 3.0 * (d1 - d0))
    }
}
