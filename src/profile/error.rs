use core::fmt;

/// What keeps numbers from being a profile, and which of them it is.
///
/// ```
/// use embedded_lathe::{Profile, ProfileError};
///
/// let dips = Profile::<1>::from_squared_radii(&[0.0, 1.0], &[0.1, -0.4, 0.1, 0.1]);
/// assert_eq!(dips, Err(ProfileError::Negative { segment: 0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ProfileError {
    /// Fewer than two knots: not one segment.
    NoSegments,
    /// More segments than the profile has room for.
    TooManySegments {
        /// How many there are.
        segments: usize,
    },
    /// Not three ordinates a segment and one more.
    OrdinateCount {
        /// How many the knots call for.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A knot is infinite or not a number.
    KnotNotFinite {
        /// Which knot, from 0.
        knot: usize,
    },
    /// A knot is not above the one before it, or by less than 10⁻¹⁰ of the largest radius.
    KnotsNotIncreasing {
        /// The upper of the two, from 1.
        knot: usize,
    },
    /// An ordinate is infinite or not a number.
    OrdinateNotFinite {
        /// Which ordinate, from 0.
        point: usize,
    },
    /// The squared radius is negative somewhere in a segment, be it between its ends alone.
    Negative {
        /// Which segment, from 0.
        segment: usize,
    },
    /// The squared radius is zero everywhere, or its largest value outside 10⁻³⁰ to 10³⁰.
    Size,
    /// The profile is more than 10¹⁰ times as high as its largest radius.
    Height,
    /// The squash is outside [0, 1].
    Squash,
}

impl ProfileError {
    /// The message, and the number of the culprit if there is one.
    const fn parts(self) -> (&'static str, Option<usize>) {
        match self {
            Self::NoSegments => ("a profile needs at least two knots", None),
            Self::TooManySegments { segments } => {
                ("more segments than the profile has room for: ", Some(segments))
            }
            Self::OrdinateCount { expected, .. } => {
                ("the number of ordinates is not 3 a segment and 1 more: it should be ", Some(expected))
            }
            Self::KnotNotFinite { knot } => ("not finite: knot ", Some(knot)),
            Self::KnotsNotIncreasing { knot } => {
                ("not above the knot before it, or by too little: knot ", Some(knot))
            }
            Self::OrdinateNotFinite { point } => ("not finite: ordinate ", Some(point)),
            Self::Negative { segment } => ("the squared radius is negative in segment ", Some(segment)),
            Self::Size => ("the squared radius has no largest value between 1e-30 and 1e30", None),
            Self::Height => ("the profile is more than 1e10 times as high as wide", None),
            Self::Squash => ("the squash is not between 0 and 1", None),
        }
    }

    /// Stops the compilation with the message. Called by [`valid!`](crate::valid).
    #[doc(hidden)]
    #[track_caller]
    pub const fn stop(self) -> ! {
        let (text, number) = self.parts();
        crate::valid::stop(text, number)
    }
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (text, number) = self.parts();
        f.write_str(text)?;
        match number {
            Some(number) => write!(f, "{number}"),
            None => Ok(()),
        }
    }
}

impl core::error::Error for ProfileError {}
