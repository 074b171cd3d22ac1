//! The outline that is turned: squared radius over height, checked when it is made.

mod error;
mod extremes;
mod quadrics;

pub use error::ProfileError;

use crate::math::const_fn;
use extremes::Extremes;

/// One cubic piece of a profile: between the heights z and z + h, at `z + h·u`, the squared radius is
/// `Σ bⱼ·Bⱼ³(u)`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Span {
    pub z: f32,
    pub top: f32,
    pub b: [f32; 4],
    /// The largest squared radius in the piece.
    pub largest: f32,
    /// The u at which the squared radius is least.
    pub narrowest: f32,
}

/// The kind of an end of a profile.
///
/// ```
/// use embedded_lathe::{End, Profile};
///
/// let tube = Profile::cylinder(1.0, 2.0)?.base(End::Open).top(End::Open);
/// # Ok::<(), embedded_lathe::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum End {
    /// The wall stops there. Through the opening the inside of the wall is seen.
    Open,
    /// A flat disc closes it.
    Capped,
}

/// The outline of a turned solid: up to N cubic Bézier segments of squared radius over height.
///
/// ```text
///  z │        b₆          k·x² + y² = f(u) = Σ bⱼ·Bⱼ³(u)      between two knots,
///  z₂├──────●             z = zᵢ + (zᵢ₊₁ − zᵢ)·u              0 ≤ u ≤ 1
///    │     b₅ ●
///    │       b₄ ●         knots      z₀ < z₁ < … < zₙ         n + 1 heights
///  z₁├─────────────●      ordinates  b₀, b₁, … b₃ₙ            3·n + 1 squared radii,
///    │         b₂ ●  b₃                                       the joins' shared
///    │       b₁ ●
///  z₀├────●
///    │  b₀
///    └──────────────── r²
/// ```
///
/// Cylinders, cones, spheres, paraboloids and hyperboloids are represented exactly.
///
/// To read a segment off a drawing, take its height h, the radii r₀ at its lower and r₁ at its upper end, and
/// the slopes r₀′ and r₁′ of the radius over the height there. Its ordinates are
///
/// ```text
/// b₀ = r₀²     b₁ = r₀² + ⅔·h·r₀·r₀′     b₂ = r₁² − ⅔·h·r₁·r₁′     b₃ = r₁²
/// ```
///
/// A straight line, r₀′ = r₁′ = (r₁ − r₀)/h, makes a cone. A circle whose middle is on the axis at height c,
/// where r·r′ = c − z, makes a sphere. Two segments join smoothly if r and r′ are the same on both sides,
/// that is, if (b₃ − b₂)/h of the lower one is (b₄ − b₃)/h of the upper one; otherwise there is an edge.
///
/// ```
/// use embedded_lathe::{End, Profile};
///
/// let vase = Profile::<2>::from_squared_radii(
///     &[0.0, 0.6, 1.0],
///     &[0.04, 0.16, 0.2, 0.14, 0.1, 0.02, 0.07],
/// )?
/// .base(End::Capped);
/// # Ok::<(), embedded_lathe::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Profile<const N: usize> {
    pub(crate) spans: [Span; N],
    pub(crate) len: usize,
    pub(crate) squash: f32,
    pub(crate) base: End,
    pub(crate) top: End,
}

/// A profile may be this many times as high as its largest radius, and each segment must be at least as high
/// as the radius divided by it: the cube, 10³⁰, and its inverse are normal numbers.
const MOST: f32 = 1e10;

impl<const N: usize> Profile<N> {
    /// A round profile of n segments, open at both ends; n is from 1 to N.
    ///
    /// The knots are n + 1 increasing heights. The ordinates are 3·n + 1 squared radii, the Bézier control
    /// values of the segments one after another, where neighbours share the one at their join. A radius of
    /// 0.3 is an ordinate of 0.09.
    ///
    /// It costs about 100 operations a segment; in a `const` the compiler does them.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], which names the knot, the ordinate or the segment at fault. A squared radius may
    /// touch zero, and pass below it by the rounding of its own evaluation: 8 units of 2⁻²⁴ of the segment's
    /// largest ordinate.
    pub const fn from_squared_radii(knots: &[f32], ordinates: &[f32]) -> Result<Self, ProfileError> {
        if knots.len() < 2 {
            return Err(ProfileError::NoSegments { knots: knots.len() });
        }
        let len = knots.len() - 1;
        if len > N {
            return Err(ProfileError::TooManySegments { segments: len, capacity: N });
        }
        if ordinates.len() != 3 * len + 1 {
            return Err(ProfileError::OrdinateCount { expected: 3 * len + 1, found: ordinates.len() });
        }
        let mut point = 0;
        while point < ordinates.len() {
            if !ordinates[point].is_finite() {
                return Err(ProfileError::OrdinateNotFinite { point, square: ordinates[point] });
            }
            point += 1;
        }
        if !knots[0].is_finite() {
            return Err(ProfileError::KnotNotFinite { knot: 0, height: knots[0] });
        }
        let mut spans = [Span::EMPTY; N];
        let mut largest = 0.0;
        let mut i = 0;
        while i < len {
            let (z, top) = (knots[i], knots[i + 1]);
            if !top.is_finite() {
                return Err(ProfileError::KnotNotFinite { knot: i + 1, height: top });
            }
            if !(top > z) {
                return Err(ProfileError::KnotsNotIncreasing { knot: i + 1, before: z, height: top });
            }
            let j = 3 * i;
            let b = [ordinates[j], ordinates[j + 1], ordinates[j + 2], ordinates[j + 3]];
            let extremes = Extremes::of(b);
            if !(extremes.least >= 0.0) {
                let height = z + (top - z) * extremes.narrowest;
                return Err(ProfileError::Negative { segment: i, height, square: extremes.least });
            }
            largest = extremes.largest.max(largest);
            spans[i] = Span { z, top, b, largest: extremes.largest, narrowest: extremes.narrowest };
            i += 1;
        }
        if !(largest >= 1e-30 && largest <= 1e30) {
            return Err(ProfileError::Size { square: largest });
        }
        let radius = const_fn::sqrt(largest);
        let height = knots[len] - knots[0];
        if !(height <= MOST * radius) {
            return Err(ProfileError::Height { height, radius });
        }
        let mut knot = 1;
        while knot <= len {
            let (before, height) = (knots[knot - 1], knots[knot]);
            if !((height - before) * MOST >= radius) {
                return Err(ProfileError::KnotsNotIncreasing { knot, before, height });
            }
            knot += 1;
        }
        Ok(Self { spans, len, squash: 1.0, base: End::Open, top: End::Open })
    }

    /// This profile stretched along x: `k·x² + y²` takes the place of `x² + y²`. With k = 1 it is round,
    /// between 0 and 1 elliptic with the half-axis r/√k along x, with k = 0 a sheet that is endless along x.
    ///
    /// # Errors
    ///
    /// [`ProfileError::Squash`] if k is outside 0 to 1, or NaN.
    pub const fn squash(self, k: f32) -> Result<Self, ProfileError> {
        if !(k >= 0.0 && k <= 1.0) {
            return Err(ProfileError::Squash { squash: k });
        }
        Ok(Self { squash: k, ..self })
    }

    /// This profile with another lower end.
    ///
    /// As all such methods it changes nothing, but returns a new value, which must be used:
    ///
    /// ```compile_fail
    /// #![deny(unused_must_use)]
    /// use embedded_lathe::{End, Profile};
    ///
    /// let profile = Profile::cylinder(1.0, 2.0)?;
    /// profile.base(End::Open); // error: unused return value of `Profile::<N>::base` that must be used
    /// # Ok::<(), embedded_lathe::ProfileError>(())
    /// ```
    #[must_use]
    pub const fn base(self, base: End) -> Self {
        Self { base, ..self }
    }

    /// This profile with another upper end.
    #[must_use]
    pub const fn top(self, top: End) -> Self {
        Self { top, ..self }
    }

    /// This profile with a flat cap at both ends.
    #[must_use]
    pub const fn closed(self) -> Self {
        self.base(End::Capped).top(End::Capped)
    }

    /// How many segments there are: at least 1, at most N.
    #[must_use]
    pub const fn segments(&self) -> usize {
        self.len
    }

    /// The heights of the lower and of the upper end.
    #[must_use]
    pub const fn heights(&self) -> [f32; 2] {
        let (mut heights, mut i) = ([0.0; 2], 0);
        // `i < N` holds whenever `i < len` does; the compiler knows the former to be in bounds.
        while i < self.len && i < N {
            heights = [if i == 0 { self.spans[i].z } else { heights[0] }, self.spans[i].top];
            i += 1;
        }
        heights
    }

    /// The largest radius, between the knots or at one: the true one or up to 6·10⁻⁷ of it more. Along x a
    /// squashed profile reaches farther, to that over √k.
    #[must_use]
    pub const fn largest_radius(&self) -> f32 {
        const_fn::sqrt(self.largest())
    }

    /// The largest squared radius.
    pub(crate) const fn largest(&self) -> f32 {
        let (mut largest, mut i) = (0.0, 0);
        while i < self.len && i < N {
            largest = self.spans[i].largest.max(largest);
            i += 1;
        }
        largest
    }
}

impl Span {
    pub const EMPTY: Self = Self { z: 0.0, top: 0.0, b: [0.0; 4], largest: 0.0, narrowest: 0.0 };
}
