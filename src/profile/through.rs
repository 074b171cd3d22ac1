//! Profiles through points of height and radius, such as a table or a measurement gives.

use super::{Profile, ProfileError, ProfilePiece};

/// A height and the radius there.
type Point = (f32, f32);

/// An end of a segment: the squared radius there, and a third of its derivative by u. The two give the
/// ordinate at the end and the one next to it.
#[derive(Clone, Copy)]
struct Side {
    square: f32,
    third: f32,
}

impl<const N: usize> Profile<N> {
    /// A smooth profile through points of height and radius, from the lowest up. Each two neighbours of
    /// different heights are joined by one segment; there may be N segments at most.
    ///
    /// Between two points the radius only grows or only shrinks: it never overshoots the points' radii. A
    /// point given twice is a corner. Two points of the same height and different radii are a step. An end
    /// without a step is open. An end on the axis, at radius 0, is round, or pointed if its point is given
    /// twice. Between two corners without a point between them the outline is a straight line.
    ///
    /// From one corner, step or end to the next, the outline is exactly that of a quadric, such as a sphere
    /// or a hyperboloid, if three points or more lie on it there, the first and the last included. If the
    /// quadric has its equator or its waist between the first and the last of them, another must lie there.
    /// (A cone needs only two points, and at its apex the point twice.)
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Profile, Segment, valid};
    ///
    /// // A bottle: its base, from the axis out to the wall; the belly, an edge at the shoulder, the neck, its mouth.
    /// static BOTTLE: Lathe<[Segment; 5]> = Lathe::turn(valid!(Profile::through(&[
    ///     (0.0, 0.0), (0.0, 0.30), (0.1, 0.34), (0.5, 0.34), (0.7, 0.12), (0.7, 0.12), (0.9, 0.10), (1.0, 0.12),
    /// ])));
    /// // An egg: both ends on the axis, and round.
    /// let egg = Profile::<3>::through(&[(0.0, 0.0), (0.5, 0.45), (0.9, 0.4), (1.4, 0.0)])?;
    /// assert_eq!((egg.segments(), egg.largest_radius()), (3, 0.45));
    /// # Ok::<(), embedded_lathe::ProfileError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ProfileError::Radius`] names a point whose radius is negative, infinite or NaN. The other errors are
    /// those of [`Profile::from_squared_radii`]. The number of a knot in such an error is that of its point,
    /// where a point given twice counts once.
    pub const fn through(points: &[Point]) -> Result<Self, ProfileError> {
        Self::join(points, false)
    }

    /// A profile of straight lines between points of height and radius, from the lowest up: every point is a
    /// corner.
    ///
    /// ```
    /// use embedded_lathe::Profile;
    ///
    /// // A spinning top, pointed below, flat above.
    /// let top = Profile::<2>::straight(&[(0.0, 0.0), (0.6, 0.5), (0.8, 0.1), (0.8, 0.0)])?;
    /// # Ok::<(), embedded_lathe::ProfileError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors are those of [`Profile::through`].
    pub const fn straight(points: &[Point]) -> Result<Self, ProfileError> {
        Self::join(points, true)
    }

    /// The profile through points: [`straight`](Self::straight) if so asked, otherwise
    /// [`through`](Self::through).
    const fn join(points: &[Point], straight: bool) -> Result<Self, ProfileError> {
        let (mut segments, mut i, mut knot) = (0, 0, 0);
        while i < points.len() {
            let (height, radius) = points[i];
            if !(radius >= 0.0 && radius < f32::INFINITY) {
                return Err(ProfileError::Radius { point: i, radius });
            }
            if !height.is_finite() {
                return Err(ProfileError::KnotNotFinite { knot, height });
            }
            if i > 0 {
                let before = points[i - 1].0;
                if height < before {
                    return Err(ProfileError::KnotsNotIncreasing { knot, before, height });
                }
                if height > before {
                    segments += 1;
                } else if i > 1
                    && is_step(points, i - 1)
                    && points[i - 2].0 == height
                    && points[i - 1].1 != radius
                {
                    return Err(ProfileError::KnotThrice { knot, height });
                }
            }
            knot += if i + 1 < points.len() && are_one(points, i) { 0 } else { 1 };
            i += 1;
        }
        if segments == 0 {
            return Err(ProfileError::NoSegments { knots: knot });
        }
        if segments > N {
            return Err(ProfileError::TooManySegments { segments, capacity: N });
        }
        let mut pieces = [ProfilePiece::EMPTY; N];
        let (mut i, mut len) = (0, 0);
        while i + 1 < points.len() && len < N {
            if points[i + 1].0 > points[i].0 {
                let [low, high] = if straight { line(points, i) } else { smooth(points, i) };
                let b = [low.square, low.square + low.third, high.square - high.third, high.square];
                pieces[len] = match ProfilePiece::new(len, points[i].0, points[i + 1].0, b) {
                    Ok(piece) => piece,
                    Err(error) => return Err(error),
                };
                len += 1;
            }
            i += 1;
        }
        let (first, last) = (points[0].1, points[points.len() - 1].1);
        Self::of(pieces, len, first * first, last * last)
    }
}

/// Whether point i and the next one are the same. False if there is no next one.
const fn are_one(points: &[Point], i: usize) -> bool {
    i + 1 < points.len() && points[i].0 == points[i + 1].0 && points[i].1 == points[i + 1].1
}

/// Whether point i has the height of the one before it, but another radius. False for point 0.
const fn is_step(points: &[Point], i: usize) -> bool {
    i > 0 && points[i].0 == points[i - 1].0 && points[i].1 != points[i - 1].1
}

/// The lower and the upper end of the segment from point i to point i + 1 as a straight line: f is the square
/// of `r₀·(1 − u) + r₁·u`.
const fn line(points: &[Point], i: usize) -> [Side; 2] {
    let (r0, r1) = (points[i].1, points[i + 1].1);
    let two_thirds = 2.0 / 3.0 * (r1 - r0);
    [Side { square: r0 * r0, third: two_thirds * r0 }, Side { square: r1 * r1, third: two_thirds * r1 }]
}

/// The lower and the upper end of the segment from point i to point i + 1 with the slopes of Steffen's
/// monotone interpolation of the squared radius (Astronomy and Astrophysics 239, 1990).
const fn smooth(points: &[Point], i: usize) -> [Side; 2] {
    // Whether another smooth segment continues this one below, and above: not so at a corner, a step or an
    // end of the profile.
    let continues =
        [i > 0 && points[i - 1].0 < points[i].0, i + 2 < points.len() && points[i + 1].0 < points[i + 2].0];
    // An end on the axis whose point is given once is round.
    let round = [i == 0 && points[i].1 == 0.0, i + 2 == points.len() && points[i + 1].1 == 0.0];
    if !continues[0] && !continues[1] && !round[0] && !round[1] {
        return line(points, i);
    }
    let here = Rise::of(points, i);
    let [low, high] = if continues[0] && continues[1] {
        let (below, above) = (Rise::of(points, i - 1), Rise::of(points, i + 1));
        [below.joined(here), here.joined(above)]
    } else if continues[1] {
        let above = Rise::of(points, i + 1);
        [here.free(above, points[i].1 == 0.0, round[0]), here.joined(above)]
    } else if continues[0] {
        let below = Rise::of(points, i - 1);
        [below.joined(here), here.free(below, points[i + 1].1 == 0.0, round[1])]
    } else {
        // A segment without neighbours whose one end is a round pole is a paraboloid.
        [here.slope, here.slope]
    };
    let (r0, r1) = (points[i].1, points[i + 1].1);
    [
        Side { square: r0 * r0, third: low * here.height / 3.0 },
        Side { square: r1 * r1, third: high * here.height / 3.0 },
    ]
}

/// How the squared radius changes between the two points of a segment.
#[derive(Clone, Copy)]
struct Rise {
    /// The difference of the heights.
    height: f32,
    /// The difference of the squared radii, divided by `height`.
    slope: f32,
}

impl Rise {
    /// The change from point i to point i + 1.
    const fn of(points: &[Point], i: usize) -> Self {
        let ((z0, r0), (z1, r1)) = (points[i], points[i + 1]);
        let height = z1 - z0;
        Self { height, slope: (r1 - r0) * (r1 + r0) / height }
    }

    /// The slope at the point between this segment and `above`, the next one: that of the parabola through
    /// the three points of the two, limited to twice the slope of either segment. It is zero if one of the
    /// two segments rises and the other does not.
    const fn joined(self, above: Self) -> f32 {
        let whole = self.height + above.height;
        let parabola = (self.slope * above.height + above.slope * self.height) / whole;
        if !(self.slope * above.slope > 0.0) {
            return 0.0;
        }
        let least = self.slope.abs().min(above.slope.abs()).min(0.5 * parabola.abs());
        if self.slope > 0.0 { 2.0 * least } else { -2.0 * least }
    }

    /// The slope at this segment's free end, at which there is no neighbour; `other` is the neighbour at its
    /// other end. It is that of the parabola through the three points of the two segments, limited to between
    /// zero and twice this segment's slope. If the free end is a round pole, the limits are this segment's
    /// slope and twice that; if it is a pointed pole, the slope is zero.
    const fn free(self, other: Self, pole: bool, round: bool) -> f32 {
        let part = self.height / (self.height + other.height);
        let parabola = self.slope * (1.0 + part) - other.slope * part;
        let ratio = parabola / self.slope;
        if round {
            self.slope * ratio.max(1.0).min(2.0)
        } else if pole || !(ratio > 0.0) {
            0.0
        } else {
            self.slope * ratio.min(2.0)
        }
    }
}
