//! A profile prepared for rays: the *lathe*, its *segments*, and its own *frame*.
//!
//! ```text
//! Ray ─┬─ LocalRay ───── Chord ─────────────── Cubic ──────── crossings ── Hit
//!      │  the ray in     its part in one       g about a      where g
//!      │  the lathe's    segment's slab        point of       changes
//!      │  own frame                            the chord      sign
//!      └─ fast path: most rays need no more
//! ```
//!
//! `g = f(u) − (k·x² + y²)` is positive inside the solid and negative outside. f(u) is the squared radius of
//! the wall at the parameter u, which goes from 0 to 1 over the height of a segment. The height is linear in
//! u, so g is a cubic along a chord. The cubic is formed about the point of the chord that is nearest to the
//! axis, or about the point at the height where the segment is narrowest. So its coefficients have the size
//! of the segment, however far away the ray's origin is and however steep the ray is. A chord is passed over
//! if its point nearest to the axis lies outside the segment's bounding cylinder, unless the ray is inside
//! the solid where the chord begins.
//!
//! The traversal carries from chord to chord on which side of the surface the ray is. That is known where the
//! ray begins, and changes at crossings only. So rounding can move a crossing to the other side of the plane
//! between two segments, but not lose it there.
//!
//! The files are in four groups:
//!
//! | where | what |
//! |---|---|
//! | `frame.rs`, `segment.rs` | what a lathe is made of: one frame, and segments, with their bounds |
//! | `side.rs` | on which side of a plane a lathe lies |
//! | `within.rs` | whether one lathe lies within another |
//! | `ray/` | one ray: the fast path, the traversal, and the queries that use them |
//! | `row/` | the rays of a row of pixels together: a sweep, and the spans of pixels that it finds |

mod frame;
mod ray;
mod row;
mod segment;
mod side;
mod within;

pub(crate) use row::{CameraRays, RayGrid, RowPart, Scale, Span, Sweep};
pub use segment::Segment;

use crate::hit::{Hit, Part};
use crate::math::const_fn;
use crate::profile::Profile;
use crate::ray::Ray;
use crate::vector::{F32x3, dot_xy, to_one, vector};
use frame::{Bounds, EndPlane, Frame, View};
use segment::{greater_or_nan, power_of_two_for, widened};

/// A turned solid in its own space: the z axis is the axis of rotation.
///
/// `Lathe<[Segment; N]>` owns the segments of a [`Profile<N>`](Profile) and can be a `static`, in flash. A
/// scene takes `&Lathe`, which is `&Lathe<[Segment]>`, a reference to a lathe of any number of segments; the
/// compiler coerces `&Lathe<[Segment; N]>` to it.
///
/// ```
/// use embedded_lathe::{Lathe, Profile, Ray, Segment, valid};
///
/// static VASE: Lathe<[Segment; 2]> = Lathe::turn(valid!(Profile::from_squared_radii(
///     &[0.0, 0.6, 1.0],
///     &[0.04, 0.16, 0.2, 0.14, 0.1, 0.02, 0.07],
/// )));
///
/// let ray = Ray::new([0.0, -2.0, 0.5], [0.0, 1.0, 0.0])?;
/// let hits = VASE.hits::<9>(&ray, 0.0);
/// assert_eq!(hits.len(), 2);
/// assert!(hits[0].enters && !hits[1].enters);
/// assert_eq!(VASE.nearest(&ray, 0.0), Some(hits[0]));
/// # Ok::<(), embedded_lathe::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lathe<S: ?Sized = [Segment]> {
    frame: Frame,
    /// As many segments as the frame's `len` says, then [`Segment::EMPTY`] up to the capacity.
    segments: S,
}

impl<const N: usize> Lathe<[Segment; N]> {
    /// The lathe of a profile. Cost: some 80 operations a segment, once; none at run time in a `const`.
    #[must_use]
    pub const fn turn(profile: Profile<N>) -> Self {
        let [low, high] = profile.heights();
        Self::turn_about(profile, 0.5 * low + 0.5 * high)
    }

    /// The lathe of a profile that is a sheet of a body, given the body's first sheet (see
    /// [`Solid::body`](crate::Solid::body)). Its heights count from the middle of the first sheet, as those
    /// of all sheets of the body do. So where two sheets meet, both compute with the same numbers, and no ray
    /// slips through between them. Rounding errors grow with the distance from that middle: take as the
    /// first sheet one whose middle is near to all the others, such as the tallest.
    #[must_use]
    pub const fn turn_beside<const M: usize>(profile: Profile<N>, first: &Profile<M>) -> Self {
        let [low, high] = first.heights();
        Self::turn_about(profile, 0.5 * low + 0.5 * high)
    }

    /// The lathe of a profile, in a frame whose origin is at the height `middle` in object space.
    const fn turn_about(profile: Profile<N>, middle: f32) -> Self {
        let len = profile.len;
        let largest = profile.largest();
        let scale = power_of_two_for(largest);
        let mut segments = [Segment::EMPTY; N];
        let mut i = 0;
        while i < len {
            segments[i] = Segment::new(&profile.pieces[i], middle, scale);
            i += 1;
        }
        let mut i = 0;
        while i + 1 < len {
            segments[i] = segments[i].before(&segments[i + 1]);
            i += 1;
        }
        let Bounds { max_slope, curvature, convexity, slope_jumps, steps } = Bounds::of(&segments, len);
        let max_slope = if curvature < f32::INFINITY { max_slope } else { f32::INFINITY };
        let (low, high) = (segments[0].low, segments[len - 1].high);
        // −low and high may differ, because the middle is rounded, or is that of another sheet.
        let half = high.abs().max(low.abs());
        let bounding_square = widened(largest * scale * scale);
        let root_squash = const_fn::sqrt(profile.squash);
        let size = const_fn::sqrt(bounding_square + half * half);
        let g_tolerance = frame::LENGTH_TOLERANCE * (2.0 + max_slope);
        let square = scale * scale;
        let base = EndPlane::new(segments[0].b[0], profile.below * square, Part::Base);
        let top = EndPlane::new(segments[len - 1].b[3], profile.above * square, Part::Top);
        // An upper bound of the sum of g's upward jumps along a ray.
        let jumps = steps + base.flange() + top.flange();
        let frame = Frame {
            len,
            squash: profile.squash,
            root_squash,
            scale,
            middle,
            low,
            high,
            bounding_square,
            size,
            half_height: half / scale,
            radius: const_fn::sqrt(bounding_square) / (scale * root_squash),
            max_slope,
            curvature,
            convexity: greater_or_nan(convexity, frame::LEAST_CONVEXITY),
            half_slope_jumps: 0.5 * slope_jumps,
            base,
            top,
            has_rings: steps > 0.0 || base.is_ring() || top.is_ring(),
            has_jumps: jumps > 0.0,
            stride: len.div_ceil(2).next_power_of_two(),
            moment_scale: scale * root_squash,
            g_tolerance,
            base_distance: frame::BASE_DISTANCE * size + jumps / g_tolerance,
        };
        Self { frame, segments }
    }
}

impl<S: ?Sized> Lathe<S> {
    /// The number of the profile's segments.
    #[must_use]
    pub const fn segments(&self) -> usize {
        self.frame.len
    }

    /// The heights of the lower and the upper end. Rounding moves each by at most 2⁻²³ of the larger of their
    /// two magnitudes from the height in the profile.
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Profile, valid};
    ///
    /// let drum = Lathe::turn(valid!(Profile::cylinder(1.5, 2.0)));
    /// assert_eq!((drum.heights(), drum.segments()), ([0.0, 2.0], 1));
    /// assert!((drum.largest_radius() - 1.5).abs() < 1e-6);
    /// ```
    #[must_use]
    pub const fn heights(&self) -> [f32; 2] {
        let Frame { middle, low, high, scale, .. } = self.frame;
        [middle + low / scale, middle + high / scale]
    }

    /// The largest radius along y, of the wall and of the steps at its ends, with a relative error of at most
    /// 1.6·10⁻⁶: that of [`Profile::largest_radius`], and two roundings. Along x a squashed solid extends to
    /// 1/√k times as much.
    #[must_use]
    pub const fn largest_radius(&self) -> f32 {
        const_fn::sqrt(self.frame.bounding_square / widened(1.0)) / self.frame.scale
    }
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// The lathe with the segments that are in use.
    #[inline(always)]
    fn view(&self) -> View<'_> {
        View { frame: &self.frame, segments: self.segments.as_ref().get(..self.frame.len).unwrap_or(&[]) }
    }

    /// The lathe with all its segments, those in spare capacity included, which no ray meets. This is cheaper
    /// than `view`, which has to cut off the spare ones.
    #[inline(always)]
    fn view_with_spare(&self) -> View<'_> {
        View { frame: &self.frame, segments: self.segments.as_ref() }
    }

    /// The height, in object space, of the frame's origin: half way between the ends, or between those of the
    /// first sheet of a body.
    pub(crate) const fn middle(&self) -> f32 {
        self.frame.middle
    }

    /// The larger of the distances of the two ends from the frame's origin, in object space. Half the height,
    /// unless the origin is in the middle of another sheet.
    pub(crate) const fn half_height(&self) -> f32 {
        self.frame.half_height
    }

    /// The radius of a cylinder that contains the solid, in object space: infinite for a sheet (k = 0).
    pub(crate) const fn radius(&self) -> f32 {
        self.frame.radius
    }

    /// The squash k of the profile (see [`Profile::squash`]).
    pub(crate) const fn squash(&self) -> f32 {
        self.frame.squash
    }

    /// Whether a point of object space lies inside the wall and between the heights of the ends, the lower
    /// one included.
    pub(crate) fn is_inside(&self, point: [f32; 3]) -> bool {
        let frame = &self.frame;
        let p = frame.point(vector(point));
        let segment = self.view().segments.get(self.view_with_spare().index_at(p.z));
        let f = segment.map_or(0.0, |segment| segment.at(segment.parameter(p.z)).0);
        frame.low <= p.z && p.z < frame.high && dot_xy(p, p) < f
    }

    /// The radius of a ball about the frame's origin, in lengths of object space. The ball contains the solid
    /// as it is after x is scaled by √k: of a squashed solid it does not contain what lies far out along x.
    pub(crate) fn ball(&self) -> f32 {
        self.frame.size / self.frame.scale
    }

    /// Returns a vector along the outward normal at a hit of a ray in object space. Its largest component is
    /// in [1, 4). On the wall it lies along half of the gradient, `(k·x, y, −f′(u)/2h)`; on a cap or a ring,
    /// and where the gradient is zero, along the axis.
    ///
    /// All lengths in it are multiplied by the frame's scale, and x is not scaled by √k. That overflows far
    /// out along a sheet, and for a direction so long that its unit does: then, too, the vector lies along
    /// the axis.
    pub(crate) fn gradient(&self, ray: &Ray, hit: &Hit) -> F32x3 {
        let View { frame, segments } = self.view();
        if hit.part == Part::Wall
            && let Some(segment) = segments.get(hit.segment)
        {
            let way = hit.t * (ray.unit * frame.scale);
            let p = ray.origin * frame.scale + ray.direction * way;
            let (across, along) = segment.weights();
            let slope = segment.at(hit.u).1;
            let gradient = vector([frame.squash * p.x * across, p.y * across, -0.5 * slope * along]);
            if let Some((gradient, _)) = to_one(gradient) {
                return gradient;
            }
        }
        // A ray enters through what faces it, and leaves through what faces the way that it goes.
        vector([0.0, 0.0, if hit.enters == (ray.direction.z < 0.0) { 1.0 } else { -1.0 }])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reaches_from_its_middle_to_both_ends() {
        let [low, high] = [1000.0001, 1000.0003];
        let ring = Lathe::turn(Profile::<1>::from_squared_radii(&[low, high], &[0.25; 4]).unwrap());
        let [below, above] = [low, high].map(|z| f64::from(z) - f64::from(ring.middle()));
        assert!(below.abs() != above.abs(), "the middle is not rounded");
        assert!(below.abs().max(above.abs()) <= f64::from(ring.half_height()), "{below} to {above}");
    }
}
