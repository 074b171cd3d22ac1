//! The outline that is turned: the squared radius as a function of height, checked when it is made.

mod error;
mod extremes;
mod quadrics;
mod steps;
mod through;

pub use error::ProfileError;
pub(crate) use extremes::Extremes;

use crate::math::const_fn;
use steps::{Counts, is_step};

/// One cubic piece of a profile: at the height `z + (top − z)·u`, for u from 0 to 1, the squared radius is `Σ
/// bⱼ·Bⱼ³(u)`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct ProfilePiece {
    /// The height of the lower knot.
    pub z: f32,
    /// The height of the upper knot.
    pub top: f32,
    /// The Bernstein ordinates of the squared radius.
    pub b: [f32; 4],
    /// The largest squared radius in the piece, or a little more: see [`Extremes::largest`].
    pub largest: f32,
    /// The u at which the squared radius is least.
    pub narrowest: f32,
}

/// The kind of an end of a profile. To close only part of an end, with a ring, put a step there: see
/// [`Profile`].
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
    /// A flat disc closes it: a step to zero.
    Capped,
}

/// The outline of a turned solid: up to N cubic Bézier segments of squared radius over height.
///
/// ```text
///  z │        b₆          k·x² + y² = f(u) = Σ bⱼ·Bⱼ³(u)      between two knots,
///  z₂├──────●             z = zᵢ + (zᵢ₊₁ − zᵢ)·u              0 ≤ u ≤ 1
///    │     b₅ ●
///    │       b₄ ●         knots      z₀ < z₁ < … < zₙ         n + 1 heights
///  z₁├─────────────●      ordinates  b₀, b₁, … b₃ₙ            3·n + 1 squared radii: neighbours
///    │         b₂ ●  b₃                                       share the one at their join
///    │       b₁ ●
///  z₀├────●
///    │  b₀
///    └──────────────── r²
/// ```
///
/// # Steps
///
/// A knot given twice is a step: at its height the outline jumps from one squared radius to another, which
/// makes a flat ring. The step has two ordinates, first the squared radius just below it, then the one just
/// above:
///
/// ```text
///  z │    b₇                  knots      z₀ < z₁ = z₂ < z₃     the step's height is given twice
///  z₃├────●                   ordinates  b₀ … b₃               the segment below,
///    │    ● b₆                           b₄ … b₇               and that above
///    │    ● b₅      b₃
///  z₂├────●─────────●  z₁     n segments and s steps have n + s + 1 knots and
///    │    b₄    b₂ ●          3·n + 1 + s ordinates
///    │          b₁ ●
///  z₀├─────────────●
///    │             b₀
///    └──────────────── r²
/// ```
///
/// Steps do not count in N, and take no memory. If the first knot is given twice, a ring closes part of the
/// lower end: the first ordinate is the squared radius of the opening, or, if it is larger than the second,
/// that of a flange. The same holds for the last knot and the upper end. A cap is a step to zero;
/// [`End::Capped`] makes it without the second knot and ordinate.
///
/// ```
/// use embedded_lathe::{End, Profile};
///
/// // A knob: a cylinder, a flat shoulder, and a thinner cylinder with a cap.
/// let knob = Profile::<2>::from_squared_radii(
///     &[0.0, 0.2, 0.2, 0.38],
///     &[0.25, 0.25, 0.25, 0.25, 0.09, 0.09, 0.09, 0.09],
/// )?
/// .top(End::Capped);
///
/// // A washer's outer wall, whose both ends are rings: a hole of radius 0.3 stays open.
/// let washer = Profile::<1>::from_squared_radii(&[0.0, 0.0, 0.1, 0.1], &[0.09, 0.25, 0.25, 0.25, 0.25, 0.09])?;
/// # Ok::<(), embedded_lathe::ProfileError>(())
/// ```
///
/// # Shapes
///
/// Cylinders, cones, spheres, paraboloids and hyperboloids are represented exactly.
///
/// To read a segment off a drawing, measure its height h, its radii r₀ at the lower end and r₁ at the upper
/// end, and r₀′ and r₁′, the derivatives of the radius by height at these ends. Its ordinates are
///
/// ```text
/// b₀ = r₀²     b₁ = r₀² + ⅔·h·r₀·r₀′     b₂ = r₁² − ⅔·h·r₁·r₁′     b₃ = r₁²
/// ```
///
/// A straight line, r₀′ = r₁′ = (r₁ − r₀)/h, makes a cone. A circle whose centre is on the axis at the height
/// c makes a sphere; on it r·r′ = c − z. Two segments join smoothly if r and r′ are the same on both sides,
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
    pub(crate) pieces: [ProfilePiece; N],
    /// How many of the array's pieces are the profile's, from the lowest up.
    pub(crate) len: usize,
    /// The factor k on x².
    pub(crate) squash: f32,
    /// The squared radii just below the lower end and just above the upper end. Each is that of the wall if
    /// the end is open, zero if it is capped, and the outer one of a step there.
    pub(crate) below: f32,
    pub(crate) above: f32,
}

/// The limit of two ratios: that of a profile's height to the largest radius of its wall, and that of the
/// largest radius, flanges included, to the height of a segment. The cube of the limit, 10³⁰, and the inverse
/// of the cube are normal numbers.
const MOST_RATIO: f32 = 1e10;

impl<const N: usize> Profile<N> {
    /// A round profile of n segments and s steps, where n is from 1 to N. An end is open, unless there is a
    /// step at it.
    ///
    /// `knots` holds n + s + 1 heights from the lowest up, among them the height of each step twice.
    /// `ordinates` holds 3·n + s + 1 squared radii, the Bézier control values of the segments from the lowest
    /// up. Two neighbouring segments share the ordinate at their join; if there is a step between them, each
    /// has its own. A radius of 0.3 has the ordinate 0.09.
    ///
    /// It takes about 100 operations for each segment. In a `const` the compiler computes them.
    ///
    /// # Errors
    ///
    /// [`ProfileError`], which names the knot, the ordinate or the segment at fault. The squared radius may
    /// touch zero. Between the ends of a segment it may be negative by as much as rounding errors can make a
    /// zero: 8·2⁻²⁴ of the segment's largest ordinate.
    pub const fn from_squared_radii(knots: &[f32], ordinates: &[f32]) -> Result<Self, ProfileError> {
        let counts = match Counts::of(knots) {
            Ok(counts) => counts,
            Err(error) => return Err(error),
        };
        let len = counts.segments;
        if len > N {
            return Err(ProfileError::TooManySegments { segments: len, capacity: N });
        }
        let expected = counts.ordinates();
        if ordinates.len() != expected {
            return Err(ProfileError::OrdinateCount { expected, found: ordinates.len() });
        }
        let mut point = 0;
        while point < expected {
            if !ordinates[point].is_finite() {
                return Err(ProfileError::OrdinateNotFinite { point, square: ordinates[point] });
            }
            point += 1;
        }
        // The first and the last ordinate are the squared radii beyond the ends. Where there is no step at an
        // end, that ordinate is also the wall's, and so the end is open.
        let (below, above, last) = (ordinates[0], ordinates[expected - 1], knots.len() - 1);
        if !(below >= 0.0) {
            return Err(ProfileError::Negative { segment: 0, height: knots[0], square: below });
        }
        if !(above >= 0.0) {
            return Err(ProfileError::Negative { segment: len - 1, height: knots[last], square: above });
        }
        let mut pieces = [ProfilePiece::EMPTY; N];
        let (mut i, mut j, mut knot) = (0, 0, 1);
        while knot <= last {
            let (z, top) = (knots[knot - 1], knots[knot]);
            if is_step(knots, knot) {
                if ordinates[j] == ordinates[j + 1] {
                    return Err(ProfileError::StepWithoutWidth { knot, height: top, square: ordinates[j] });
                }
                j += 1;
            } else if top > z {
                let b = [ordinates[j], ordinates[j + 1], ordinates[j + 2], ordinates[j + 3]];
                pieces[i] = match ProfilePiece::new(i, z, top, b) {
                    Ok(piece) => piece,
                    Err(error) => return Err(error),
                };
                (i, j) = (i + 1, j + 3);
            } else {
                return Err(ProfileError::KnotsNotIncreasing { knot, before: z, height: top });
            }
            knot += 1;
        }
        Self::of(pieces, len, below, above)
    }

    /// A round profile whose segments are the first `len` of `pieces`, each on top of the one before; `below`
    /// and `above` are the squared radii beyond its ends.
    ///
    /// # Errors
    ///
    /// [`ProfileError::Size`] if the profile is too large or too small, [`ProfileError::Height`] if it is too
    /// high, [`ProfileError::KnotsNotIncreasing`] if one of its segments is too low.
    const fn of(pieces: [ProfilePiece; N], len: usize, below: f32, above: f32) -> Result<Self, ProfileError> {
        let profile = Self { pieces, len, squash: 1.0, below, above };
        let wall = Self { below: 0.0, above: 0.0, ..profile }.largest();
        if !(wall >= 1e-30) {
            return Err(ProfileError::Size { square: wall });
        }
        let radius = const_fn::sqrt(wall);
        let [base, top] = profile.heights();
        let height = top - base;
        if !(height <= MOST_RATIO * radius) {
            return Err(ProfileError::Height { height, radius });
        }
        // A flange at an end may be wider than all of the wall.
        let largest = profile.largest();
        if !(largest <= 1e30) {
            return Err(ProfileError::Size { square: largest });
        }
        let radius = const_fn::sqrt(largest);
        let (mut i, mut knot, mut before) = (0, 0, below);
        while i < len && i < N {
            let ProfilePiece { z, top, b: [b0, .., b3], .. } = pieces[i];
            // Becomes the number of the segment's upper knot: one more than that of the segment before, or
            // two more if there is a step between them.
            knot += if before == b0 { 1 } else { 2 };
            before = b3;
            if !((top - z) * MOST_RATIO >= radius) {
                return Err(ProfileError::KnotsNotIncreasing { knot, before: z, height: top });
            }
            i += 1;
        }
        Ok(profile)
    }

    /// This profile stretched along x: `k·x² + y²` takes the place of `x² + y²`. With k = 1 it is round,
    /// between 0 and 1 elliptic with the half-axis r/√k along x; with k = 0 it is the outline
    /// extruded along x, without ends. An earlier squash of this profile is replaced.
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

    /// This profile with another lower end. If there is a step at that end, the new end replaces it: the ring
    /// or flange is no longer there.
    ///
    /// Like all methods of this kind it does not change the profile, but returns a new one, which must be
    /// used:
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
        Self { below: base.beyond(self.ends()[0]), ..self }
    }

    /// This profile with another upper end, which replaces a step there, too.
    #[must_use]
    pub const fn top(self, top: End) -> Self {
        Self { above: top.beyond(self.ends()[1]), ..self }
    }

    /// This profile with a flat cap at both ends, in place of what is there.
    #[must_use]
    pub const fn closed(self) -> Self {
        self.base(End::Capped).top(End::Capped)
    }

    /// This profile with room for M segments instead of N. A profile that is read at run time, into as much
    /// room as the largest may need, so gets no more than it takes: a segment of a lathe is 76 bytes, or 96.
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Profile, ProfileError, Segment};
    ///
    /// // Of as many points as a host may send …
    /// let read = Profile::<20>::through(&[(0.0, 0.2), (0.4, 0.3), (0.7, 0.1), (1.0, 0.15)])?;
    /// // … these are three segments.
    /// let vase: Lathe<[Segment; 3]> = Lathe::turn(read.resized::<3>()?);
    /// assert_eq!(vase.segments(), 3);
    ///
    /// let error = read.resized::<2>().unwrap_err();
    /// assert_eq!(error, ProfileError::TooManySegments { segments: 3, capacity: 2 });
    /// # Ok::<(), ProfileError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ProfileError::TooManySegments`] if it has more than M segments.
    pub const fn resized<const M: usize>(&self) -> Result<Profile<M>, ProfileError> {
        let Self { len, squash, below, above, .. } = *self;
        if len > M {
            return Err(ProfileError::TooManySegments { segments: len, capacity: M });
        }
        let (mut pieces, mut i) = ([ProfilePiece::EMPTY; M], 0);
        while i < M && i < N {
            pieces[i] = self.pieces[i];
            i += 1;
        }
        Ok(Profile { pieces, len, squash, below, above })
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
        // `i < len` implies `i < N`; from the latter the compiler knows that the index is in bounds.
        while i < self.len && i < N {
            heights = [if i == 0 { self.pieces[i].z } else { heights[0] }, self.pieces[i].top];
            i += 1;
        }
        heights
    }

    /// The squared radii of the wall at the lower and at the upper end.
    const fn ends(&self) -> [f32; 2] {
        let (mut ends, mut i) = ([0.0; 2], 0);
        while i < self.len && i < N {
            let [b0, .., b3] = self.pieces[i].b;
            ends = [if i == 0 { b0 } else { ends[0] }, b3];
            i += 1;
        }
        ends
    }

    /// The largest radius of the wall and of the steps at its ends. The result exceeds the exact radius by at
    /// most 1.5·10⁻⁶ of it, and falls short of it by at most 2⁻²⁴ of it. It is the extent along y; along x a
    /// squashed profile extends farther, to this radius divided by √k.
    #[must_use]
    pub const fn largest_radius(&self) -> f32 {
        // The square is too large by twice `extremes::VALUE_ERROR` at most: the bound is added to a value
        // that may be off by it. It is relative to the segment's largest ordinate, which is at most 3 times
        // the largest value: of the cubics from −1 to 1 Chebyshev's has the largest ordinates, −1, 5, −5, 1
        // (Lyche and Scherer 2000), so that those of a cubic from 0 to 1 are at most (1 + 5)/2. That makes
        // 2·8·3 = 48 units of 2⁻²⁴, half as many for the radius, and one more for the rounding of the root.
        const_fn::sqrt(self.largest())
    }

    /// The largest squared radius of the wall and of the steps at its ends, or a little more.
    pub(crate) const fn largest(&self) -> f32 {
        let (mut largest, mut i) = (self.below.max(self.above), 0);
        while i < self.len && i < N {
            largest = self.pieces[i].largest.max(largest);
            i += 1;
        }
        largest
    }
}

impl End {
    /// The squared radius beyond an end of this kind: `wall`, the wall's at that end, if it is open, zero if
    /// it is capped.
    const fn beyond(self, wall: f32) -> f32 {
        match self {
            Self::Open => wall,
            Self::Capped => 0.0,
        }
    }
}

impl ProfilePiece {
    /// Fills the places of the array after the profile's last piece.
    pub const EMPTY: Self = Self { z: 0.0, top: 0.0, b: [0.0; 4], largest: 0.0, narrowest: 0.0 };

    /// Segment number i, from the height z to `top`, with the ordinates b; i serves only the error.
    ///
    /// # Errors
    ///
    /// [`ProfileError::Negative`] if the squared radius is negative or NaN somewhere.
    const fn new(i: usize, z: f32, top: f32, b: [f32; 4]) -> Result<Self, ProfileError> {
        let extremes = Extremes::of(b);
        if !(extremes.least >= 0.0) {
            let height = z + (top - z) * extremes.narrowest;
            return Err(ProfileError::Negative { segment: i, height, square: extremes.least });
        }
        Ok(Self { z, top, b, largest: extremes.largest, narrowest: extremes.narrowest })
    }
}
