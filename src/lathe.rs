//! A profile made ready to meet rays: the *lathe*, its *segments*, and its own *frame*.
//!
//! ```text
//! Ray ─┬─ LocalRay ───── Chord ─────────────── Cubic ──────── crossings ── Hit
//!      │  the ray in     what of it lies in    g about the    where g
//!      │  the lathe's    one segment's slab    chord's        changes
//!      │  own frame                            narrowest      sign
//!      └─ fast path: most rays need no more
//! ```
//!
//! `g = f(u) − (k·x² + y²)` is positive inside the solid and negative outside. Heights are linear in u, so
//! along a chord g is a cubic, and because it is formed about the chord's point nearest to the axis, every
//! number in it has the size of the segment, whatever the ray's origin or slope. A chord whose nearest point
//! lies outside the segment's cylinder is passed over, but by a ray inside.
//!
//! Whether the ray is inside or outside is carried from chord to chord. It changes at crossings only, and
//! where it starts is known; so a crossing can be found a rounding early or late at a join, not lost there.
//!
//! Three rooms: the ground (`frame.rs`, `segment.rs`), one ray (`ray/`), and the rays of a row of pixels together (`row/`).

mod frame;
mod ray;
mod row;
mod segment;

pub(crate) use row::{RayRow, RowPart, Seen, Span, Sweep};
pub use segment::Segment;

use crate::hit::{Hit, Part};
use crate::math::minmax::greater;
use crate::math::{cold_path, const_fn};
use crate::profile::Profile;
use crate::vector::{F32x3, largest, saturated, vector};
use frame::{EndPlane, Frame, View};
use segment::{greater_or_nan, power_of_two_for, widened};

/// A turned solid in its own space: the z axis is the axis of rotation.
///
/// `Lathe<[Segment; N]>` owns the segments of a [`Profile<N>`](Profile) and can be a `static`, in flash. A
/// scene takes `&Lathe`, of any number of segments: a reference to the one becomes a reference to the other
/// by itself.
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
    /// As many as the frame says, then spare room, empty.
    segments: S,
}

impl<const N: usize> Lathe<[Segment; N]> {
    /// Makes a profile ready. Cost: some 80 operations a segment, once; none at run time in a `const`.
    #[must_use]
    pub const fn turn(profile: Profile<N>) -> Self {
        let len = profile.len;
        let largest = profile.largest();
        let scale = power_of_two_for(largest);
        let middle = 0.5 * profile.spans[0].z + 0.5 * profile.spans[len - 1].top;
        let mut segments = [Segment::EMPTY; N];
        let mut i = 0;
        while i < len {
            segments[i] = Segment::new(&profile.spans[i], middle, scale);
            i += 1;
        }
        let (mut max_slope, mut curvature, mut convexity, mut slope_jumps, mut steps) =
            (0.0, 0.0, 0.0, 0.0, 0.0);
        let mut i = 0;
        while i < len {
            if i + 1 < len {
                segments[i] = segments[i].before(&segments[i + 1]);
                steps += (segments[i + 1].b[0] - segments[i].b[3]).abs();
            }
            convexity = greater_or_nan(convexity, segments[i].convexity);
            slope_jumps += segments[i].slope_jump;
            max_slope = greater_or_nan(max_slope, segments[i].max_slope());
            curvature = greater_or_nan(curvature, segments[i].curvature());
            i += 1;
        }
        let (low, high) = (segments[0].low, segments[len - 1].high);
        // The middle is rounded.
        let half = high.max(-low);
        let bounding_square = widened(largest * scale * scale);
        let root_squash = const_fn::sqrt(profile.squash);
        let size = const_fn::sqrt(bounding_square + half * half);
        let g_tolerance = frame::LENGTH_TOLERANCE * (2.0 + max_slope);
        let square = scale * scale;
        let base = EndPlane::new(segments[0].b[0], profile.below * square, Part::Base);
        let top = EndPlane::new(segments[len - 1].b[3], profile.above * square, Part::Top);
        // By how much g may jump upwards along a ray, in all.
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
    /// How many segments the profile has.
    #[must_use]
    pub const fn segments(&self) -> usize {
        self.frame.len
    }

    /// The heights of the lower and of the upper end: those of the profile, to 2⁻²³ of the larger.
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

    /// The largest radius, between the knots or at one, to 10⁻⁶ of it. Along x a squashed solid reaches farther, to that over
    /// √k.
    #[must_use]
    pub const fn largest_radius(&self) -> f32 {
        const_fn::sqrt(self.frame.bounding_square / widened(1.0)) / self.frame.scale
    }
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    #[inline(always)]
    fn view(&self) -> View<'_> {
        View { frame: &self.frame, segments: self.segments.as_ref().get(..self.frame.len).unwrap_or(&[]) }
    }

    /// With the spare room.
    #[inline(always)]
    fn view_with_spare(&self) -> View<'_> {
        View { frame: &self.frame, segments: self.segments.as_ref() }
    }

    /// The height half way up.
    pub(crate) const fn middle(&self) -> f32 {
        self.frame.middle
    }

    /// Half the height of the cylinder around it.
    pub(crate) const fn half_height(&self) -> f32 {
        self.frame.half_height
    }

    /// The radius of that, infinite around a sheet.
    pub(crate) const fn radius(&self) -> f32 {
        self.frame.radius
    }

    /// The radius of a ball around all of a solid, or of what a sheet repeats along x.
    pub(crate) fn ball(&self) -> f32 {
        self.frame.size / self.frame.scale
    }

    /// A vector along the outward normal at a point of the surface, its largest component a normal number: half of
    /// `(2k·x, 2y, −f′(u)/h)` on the wall, in the lathe's frame; on a cap, and where that vector is zero, along the axis.
    pub(crate) fn gradient_at(&self, point: F32x3, hit: &Hit) -> F32x3 {
        let View { frame, segments } = self.view();
        let faces_up = match hit.part {
            Part::Base => Some(frame.base.wall < frame.base.beyond),
            Part::Top => Some(frame.top.wall > frame.top.beyond),
            Part::Ring => Some(hit.u > 0.5),
            Part::Wall => None,
        };
        if let Some(faces_up) = faces_up {
            return vector([0.0, 0.0, if faces_up { 1.0 } else { -1.0 }]);
        }
        // NaN for a segment of no height in the frame, whose 1/h is infinite.
        let slope = segments.get(hit.segment).map_or(0.0, |segment| segment.at(hit.u).1 * segment.per_height);
        let (x, y) = (frame.squash * frame.scale * point.x, frame.scale * point.y);
        let gradient = vector([x, y, -0.5 * slope]);
        // NaN if the slope is, infinite if any component is.
        let size = greater(greater(gradient.z.abs(), x.abs()), y.abs());
        if size >= f32::MIN_POSITIVE && size <= f32::MAX {
            return gradient;
        }
        cold_path();
        let gradient = saturated(gradient);
        let is_below = hit.segment == 0 && hit.u < 0.5;
        let pole = vector([0.0, 0.0, if is_below { -1.0 } else { 1.0 }]);
        if largest(gradient) >= f32::MIN_POSITIVE { gradient } else { pole }
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
