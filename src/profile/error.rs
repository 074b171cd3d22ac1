use crate::message::Piece::{Count, Number, Text};
use crate::message::{Message, impl_error};

/// Why numbers do not make a profile, and which numbers they are.
///
/// ```
/// use embedded_lathe::{Profile, ProfileError};
///
/// let dips = Profile::<1>::from_squared_radii(&[0.0, 1.0], &[0.1, -0.4, -0.4, 0.1]);
/// let Err(error @ ProfileError::Negative { segment: 0, height: 0.5, square }) = dips else { panic!() };
/// assert!((square - -0.275).abs() < 1e-6);
/// assert_eq!(error.to_string(), format!("the squared radius is {square} at the height 0.5, in segment 0"));
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ProfileError {
    /// The knots have fewer than two different heights, so that there is no segment.
    NoSegments {
        /// How many knots there are.
        knots: usize,
    },
    /// More segments than the profile has room for.
    TooManySegments {
        /// How many there are.
        segments: usize,
        /// For how many segments the profile has room: its N.
        capacity: usize,
    },
    /// The number of ordinates is not three for each segment, one for each step, and one more.
    OrdinateCount {
        /// How many ordinates these knots need.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A knot is infinite or NaN.
    KnotNotFinite {
        /// Which knot, from 0.
        knot: usize,
        /// Its height.
        height: f32,
    },
    /// A knot is not above the one before it, or is above it by less than 10⁻¹⁰ of the largest radius.
    KnotsNotIncreasing {
        /// The number of the upper of the two, from 0.
        knot: usize,
        /// The height of the one before it.
        before: f32,
        /// Its own height.
        height: f32,
    },
    /// Three knots stand at one height: a step has two.
    KnotThrice {
        /// The number of the third of them, from 0.
        knot: usize,
        /// The height.
        height: f32,
    },
    /// The two ordinates of a step are equal.
    StepWithoutWidth {
        /// The number of the step's second knot, from 0.
        knot: usize,
        /// Its height.
        height: f32,
        /// The squared radius both below and above.
        square: f32,
    },
    /// An ordinate is infinite or NaN.
    OrdinateNotFinite {
        /// Which ordinate, from 0.
        point: usize,
        /// The ordinate itself.
        square: f32,
    },
    /// The squared radius is negative somewhere in a segment, at an end or between the ends, or beyond the
    /// step at an end of the profile.
    Negative {
        /// Which segment, from 0. Where the step at an end of the profile is at fault, it is the segment at
        /// that end.
        segment: usize,
        /// The height at which the squared radius is least.
        height: f32,
        /// The squared radius there.
        square: f32,
    },
    /// The largest squared radius is above 10³⁰, or, flanges at the ends left out, below 10⁻³⁰.
    Size {
        /// That largest squared radius.
        square: f32,
    },
    /// The profile is more than 10¹⁰ times as high as its wall's largest radius.
    Height {
        /// The profile's height.
        height: f32,
        /// Its wall's largest radius, flanges at the ends left out.
        radius: f32,
    },
    /// The squash is outside 0 to 1, or NaN.
    Squash {
        /// The squash given.
        squash: f32,
    },
    /// The radius of a point that a profile is to pass through is negative, infinite or NaN.
    Radius {
        /// Which point, from 0.
        point: usize,
        /// Its radius.
        radius: f32,
    },
    /// A constructor of exact profiles, such as [`Profile::cylinder`](crate::Profile::cylinder), was given a
    /// radius or a height that is negative, infinite, NaN, or zero where that is not allowed.
    Dimension {
        /// What the parameter is called.
        name: &'static str,
        /// The number given.
        value: f32,
    },
}

impl ProfileError {
    /// The error in words.
    const fn message(self) -> Message {
        match self {
            Self::NoSegments { knots } => Message::of([
                Text("a profile needs knots at 2 heights at least; in all it has "),
                Count(knots),
            ]),
            Self::TooManySegments { segments, capacity } => Message::of([
                Text("the profile has room for "),
                Count(capacity),
                Text(" segments, and the knots make "),
                Count(segments),
            ]),
            Self::OrdinateCount { expected, found } => Message::of([
                Text("there must be 3 ordinates a segment, 1 a step and 1 more, "),
                Count(expected),
                Text(", and there are "),
                Count(found),
            ]),
            Self::KnotNotFinite { knot, height } => {
                Message::of([Text("the height of knot "), Count(knot), Text(" is "), Number(height)])
            }
            Self::KnotsNotIncreasing { knot, before, height } => Message::of([
                Text("the height of knot "),
                Count(knot),
                Text(" is "),
                Number(height),
                Text(", not above, or too little above, that of the knot before it, "),
                Number(before),
            ]),
            Self::KnotThrice { knot, height } => Message::of([
                Text("knot "),
                Count(knot),
                Text(" is the third at the height "),
                Number(height),
                Text(", and a step has two"),
            ]),
            Self::StepWithoutWidth { knot, height, square } => Message::of([
                Text("the step at knot "),
                Count(knot),
                Text(", at the height "),
                Number(height),
                Text(", has one squared radius below and above, "),
                Number(square),
            ]),
            Self::OrdinateNotFinite { point, square } => {
                Message::of([Text("ordinate "), Count(point), Text(" is "), Number(square)])
            }
            Self::Negative { segment, height, square } => Message::of([
                Text("the squared radius is "),
                Number(square),
                Text(" at the height "),
                Number(height),
                Text(", in segment "),
                Count(segment),
            ]),
            Self::Size { square } => Message::of([
                Text("the largest squared radius must be from 1e-30 to 1e30, and is "),
                Number(square),
            ]),
            Self::Height { height, radius } => Message::of([
                Text("the profile is "),
                Number(height),
                Text(" high, more than 1e10 times its largest radius, "),
                Number(radius),
            ]),
            Self::Squash { squash } => {
                Message::of([Text("the squash must be from 0 to 1, and is "), Number(squash)])
            }
            Self::Radius { point, radius } => {
                Message::of([Text("the radius of point "), Count(point), Text(" is "), Number(radius)])
            }
            Self::Dimension { name, value } => {
                let fault = if value < 0.0 {
                    " must not be negative, and is "
                } else if value == 0.0 {
                    " must not be zero, and is "
                } else {
                    " must be finite, and is "
                };
                Message::of([Text("the parameter "), Text(name), Text(fault), Number(value)])
            }
        }
    }
}

impl_error!(ProfileError);
