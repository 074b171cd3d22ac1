//! What is known of all rays of a part of a row: where they pass the solid, by how much they differ, and at
//! which pixel to begin.

use super::grid::{RayGrid, SPANS, TOLERANCE, WIDENED};
use super::ray_row::RayRow;
use crate::arithmetic::{Numbers, RowLimits};
use crate::lathe::frame::View;
use crate::lathe::segment::Segment;
use crate::math::const_fn::upper_root;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::{F32x3, dot, dot_xy};

/// The error in s that the last Newton step may leave, 2⁻¹⁹: s is counted in lengths of the ray's
/// direction.
///
/// If the direction's length is 1, such an error turns the normal of a surface of radius 1 by 2⁻¹⁹, and so
/// changes one of 255 shades by 2⁻¹¹ of a shade at most.
pub(super) const ROOT: f32 = 1.0 / 524_288.0;

/// A bound of what the additions of a run of tracked pixels can do to g where distances are compared: a
/// sixteenth of the tolerance, since in `track.rs` such a run has 64 pixels at most.
const ADDITIONS: f32 = TOLERANCE / 16.0;

/// Where parallel rays begin within the span, and at heights that vary from pixel to pixel, a probe bounds g
/// from this part of the span before the point where its ray begins.
///
/// The value is a choice. If it is larger, a probe may hold for more pixels, but fails where a surface is just
/// before that point.
const LEAD: f32 = 1.0 / 8.0;

/// A part of a row of `width` pixels: the columns from `start` to before `end`.
pub(crate) struct RowPart {
    pub width: u32,
    pub start: u32,
    pub end: u32,
    /// Whether distances are compared with those of other solids. If so, a root is tracked, or a cap's pixel
    /// decided, only where the distance is known to within [`RowBounds::depth_error`].
    pub has_depth: bool,
}

/// What is known of all rays of a part of a row.
pub(super) struct RowBounds<'a> {
    pub lathe: View<'a>,
    /// How the numbers of a tracked root are held.
    pub numbers: Numbers,
    /// Whether none of the rays comes near the solid.
    pub is_culled: bool,
    /// Whether the bounds are of use. They are not if the span is too long; if the rays begin so far away
    /// that rounding decides; if they begin at the height of an end or of a step, to within the tolerance; or
    /// if a segment has no height in the frame. Nor are they for parallel rays that begin near the solid, at
    /// heights that vary, and run nearly level. Then every pixel gets a *single ray*.
    pub is_usable: bool,
    /// The s from which on probes bound g. If all rays begin before the solid, at an s below −span, this is
    /// −∞, and no root has to be compared with where they begin. If it is finite, they begin near the solid,
    /// inside of it, or past it, at the s of −`shift`. This is the same number if all of them begin at one
    /// height. If not, they are parallel, and this number is lower: each of the rays for which a probe holds
    /// begins at a height that the probed ray has beyond this s.
    pub start: f32,
    /// What relates s to the distance t along a ray: `unit·t = shift + s`. `shift` is the distance from the
    /// ray's origin to where s is zero, counted like s in lengths of D; `unit` is how many of these make a t
    /// of 1.
    pub shift: f32,
    pub unit: f32,
    /// The column that the right half begins with, the number of columns of the left half, and whether the
    /// left half sees the mirror image of what the right one sees.
    pub middle: u32,
    pub left: u32,
    pub is_mirrored: bool,
    /// Every point of the solid on every ray has |s| ≤ span.
    pub span: f32,
    /// The lowest and the highest height at which a ray of the row can meet the solid.
    pub low: f32,
    pub high: f32,
    /// The largest |dz|.
    pub steep: f32,
    /// A lower bound of q/dz² of all rays. Along every ray g is concave in a segment whose own `convexity`,
    /// the bound of F″/2, is no more than this.
    pub max_convexity: f32,
    /// True if all rays rise, false if all fall. `None` if neither is certain, or if the bounds are of no
    /// use.
    pub rising: Option<bool>,
    /// A bound of how fast heights change from pixel to pixel: the largest |∂z/∂i| at any s within the span,
    /// divided by `SPANS·span`. Divided by |dz|, it bounds how far the point of a given height moves along
    /// the rays from one pixel to the next, as a part of `SPANS·span`.
    pub drift: f32,
    /// How far rounding can move a point: `LENGTH_TOLERANCE` times the sum of the eye's distance, the solid's
    /// size and, for parallel rays, `CameraRays::rough`; and what [`Numbers::slip`] adds to this product.
    pub slip: f32,
    /// The half-width of the *undecided band*, in height, and in g where the profile is a cylinder: the row
    /// decides nothing where a height is nearer to an end than this, or g is nearer to zero. In g it grows
    /// with the slope of the profile, see [`RowBounds::tolerance_in`].
    pub tolerance: f32,
    /// The half-width of that band, in height, about the knots between segments: the same if the lathe has
    /// steps, zero if it has none.
    pub knot_tolerance: f32,
    /// A bound of D² of all rays.
    pub longest: f32,
    /// The least slope A that a root tracked in a cylinder must have for its distance to be compared with
    /// another solid's: a thirty-second of the length of the longest direction. For a cap's distance |dz|
    /// must be at least half of this least slope. Zero if distances are not compared.
    ///
    /// Each root that is tracked in a cylinder has this slope anyway: a thirty-second of the length is no
    /// more than the `2·√(D²·tolerance)` of [`SegmentBounds::slack`]. If this slope were smaller, more roots
    /// of steep segments would be tracked, but the errors of all distances would be larger.
    pub least_slope: f32,
}

/// What a root must satisfy that is tracked in a segment.
pub(super) struct SegmentBounds {
    /// The half-width of the undecided band in g.
    pub tolerance: f32,
    /// The slope that a tracked root must exceed: `2·√(D²·tolerance) + 16·ROOT·Q`, with D² no less than that
    /// of any ray, and Q a bound of |g″/2|; or, if distances are compared, `least_slope·(1 + S/2)`, with S
    /// the largest slope of the segment, where that is more.
    ///
    /// A slope A above the first term makes g rise behind the root to A²/(4·D²), more than the tolerance, if
    /// `g″/2 ≥ −D²` there. A slope above the second makes certain that there is a root near where the last
    /// Newton step ends. The length b of that step has `b² ≤ ROOT·A/Q`; Kantorovich's theorem asks for
    /// `A ≥ 4·Q·b`, which follows from `A ≥ 16·Q·ROOT`.
    pub slack: f32,
    /// `ROOT/(Q·(1 + κ/1024))`, where κ is a bound of |du/ds|. A Newton step of length b with
    /// `b² ≤ newton_tolerance·A` leaves an error of `Q·b²/A` in s. This is ROOT at most, and so small in a low
    /// segment that the error in u is 1024·ROOT = 2⁻⁹ at most: where the root is beyond a crease at the
    /// segment's end, the ray may meet another part of the surface.
    pub newton_tolerance: f32,
}

impl RowPart {
    /// Half the number of columns of the part.
    #[inline(always)]
    pub fn half(&self) -> f32 {
        0.5 * (self.end - self.start) as f32
    }

    /// The number of the part's middle column, counted in the whole row; if there are two, the mean of both
    /// numbers.
    #[inline(always)]
    pub fn center(&self) -> f32 {
        self.start as f32 - 0.5 + self.half()
    }
}

impl<'a> RowBounds<'a> {
    /// The bounds of the rays of a part of a row, and its rays, counted from the middle of the part. The row
    /// is that of [`RayGrid::row`]. If it is one of a picture, its plane must not [pass](RayGrid::passes_by)
    /// the solid by.
    #[inline(always)]
    pub fn new(lathe: View<'a>, grid: &RayGrid, j: Option<f32>, part: &RowPart) -> (Self, RayRow) {
        let frame = lathe.frame;
        let half = part.half();
        let from_middle = part.center() - (0.5 * part.width as f32 - 0.5);
        let (mut rays, normal) = grid.row(frame, j);
        let is_whole = part.end - part.start == part.width;
        if !is_whole {
            (rays.origin, rays.direction) = rays.at(from_middle);
        }
        let (d, right, half_apart) = (rays.direction, rays.right, half * rays.apart);
        let turn = half_apart * right.z.abs();
        let steep = d.z.abs() + turn;
        // D² less dz² is convex in the pixel's number, and so no less than its tangent at the middle.
        let q = greater(0.0, dot_xy(d, d) - 2.0 * half_apart * dot_xy(d, right).abs());
        let tolerance = grid.tolerance();
        // A ball that is met by each ray that comes near the solid. Rounding moves the plane by less than the
        // slip.
        let is_outside_ball = j.is_none() && {
            let radius = WIDENED * frame.size + grid.slip;
            let from_origin = dot(normal, rays.origin);
            from_origin * from_origin > radius * radius * dot(normal, normal)
        };
        let Plane { height, spread } = Plane::of(&rays, normal, frame.bounding_square + tolerance);
        let spread = spread + grid.slip;
        let (low, high) = (greater(frame.low, height - spread), lesser(frame.high, height + spread));
        let mut start = if grid.begins_before { f32::NEG_INFINITY } else { -grid.shift };
        let mut is_usable = grid.is_usable;
        let mut drift = grid.drift;
        if start > f32::NEG_INFINITY {
            // Rounding must not decide on which side of the plane of an end or of a step the rays begin.
            is_usable &= !lathe.is_near_edge(rays.origin.z + start * d.z, tolerance);
            if rays.apart == 0.0 && rays.right.z != 0.0 {
                // The next rays begin at other heights. While a probe holds, these lie within 4/5 of the lead.
                // The rest of it is, in height, more than 4/5 of the tolerance: so a probe knows of the plane of
                // an end or of a step where rounding decides on which side of it a ray begins.
                start -= LEAD * grid.span;
                drift *= 1.25 * SPANS / LEAD;
                is_usable &= d.z.abs() > 4.0 / LEAD * tolerance;
            }
        }
        let is_culled = is_outside_ball || is_usable && low > high;
        let is_mirrored = grid.is_mirrored
            && is_usable
            && part.start == part.width - part.end
            && (part.end - part.start).is_multiple_of(2);
        let middle = if is_mirrored {
            part.width / 2
        } else {
            let height = lesser(frame.high, greater(frame.low, height));
            let pixel = 0.5 * part.width as f32 + grid.axis_column(height);
            // The conversion to u32 saturates; NaN becomes zero.
            part.start.max(part.end.min(pixel as u32))
        };
        let has_one_side = is_usable && d.z.abs() > turn;
        let bounds = Self {
            lathe,
            numbers: Numbers::new(grid.span, grid.longest, grid.far),
            is_culled,
            is_usable,
            start,
            shift: grid.shift,
            unit: grid.unit,
            middle,
            left: middle - part.start,
            is_mirrored,
            span: grid.span,
            low,
            high,
            steep,
            max_convexity: q / (steep * steep),
            rising: has_one_side.then_some(d.z > 0.0),
            drift,
            slip: grid.slip,
            tolerance,
            knot_tolerance: if frame.has_rings { tolerance } else { 0.0 },
            longest: grid.longest,
            least_slope: if part.has_depth { 0.03125 * upper_root(grid.longest) } else { 0.0 },
        };
        (bounds, rays)
    }
}

impl RowBounds<'_> {
    /// Those of the bounds that an arithmetic converts once for the row. In the result `span` is how far
    /// along a ray a probe looks: 1 + SPANS times the span.
    #[inline(always)]
    pub fn limits(&self) -> RowLimits {
        let Self { start, low, high, drift, slip, tolerance, knot_tolerance, .. } = *self;
        let span = (1.0 + SPANS) * self.span;
        RowLimits { span, start, low, high, drift, slip, tolerance, knot_tolerance }
    }

    /// The half-width of the undecided band in g, in a segment. It is larger where the profile is steep, by
    /// as much as the rounding of a height changes F.
    #[inline(always)]
    pub fn tolerance_in(&self, segment: &Segment) -> f32 {
        self.tolerance + self.slip * segment.max_slope
    }

    /// What a root must satisfy that is tracked in a segment. The steeper or the more curved a segment is,
    /// the more is asked of its own roots; those of other segments are not affected.
    #[inline(always)]
    pub fn in_segment(&self, segment: &Segment) -> SegmentBounds {
        let tolerance = self.tolerance_in(segment);
        // A bound of |g″/2| along any of the rays.
        let most = self.longest + segment.curvature * (self.steep * self.steep);
        let slack = 2.0 * Native::sqrt(self.longest * tolerance) + 16.0 * ROOT * most;
        let low = segment.per_height * self.steep / 1024.0;
        let least_slope = self.least_slope * (1.0 + 0.5 * segment.max_slope);
        SegmentBounds {
            tolerance,
            slack: greater(slack, least_slope),
            newton_tolerance: ROOT / (most + most * low),
        }
    }

    /// A bound of the difference, in t, between the distance of a tracked root or of a cap and the distance
    /// that a single ray finds there. It holds where the slope of g at the root is at least `L·(1 + S/2)`: L
    /// is [`RowBounds::least_slope`], and S is the largest |dF/dz| of the segment. It is infinite if
    /// distances are not compared.
    ///
    /// The distance of a root is off by the error of g, from rounding and a run's additions, divided by the
    /// slope, and by what the last Newton step leaves. Rounding and that step count twice, for the single ray
    /// has them as well. The error of g is 1 + S/2 times that in a cylinder, so that the quotient is the same
    /// for all segments. The distance of a cap is off by the error of its height divided by |dz|, which is
    /// L/2 at least; this counts twice, too. In addition every distance is rounded itself.
    pub fn depth_error(&self) -> f32 {
        (2.0 * ROOT + (4.0 * self.slip + ADDITIONS) / self.least_slope + self.slip) / self.unit
    }
}

/// The plane of a row's rays.
struct Plane {
    /// The height at which the plane meets the axis.
    height: f32,
    /// The largest difference from that height at any point of the plane within a cylinder around the axis.
    spread: f32,
}

impl Plane {
    /// The plane of the rays, given its normal and the square of the cylinder's radius.
    ///
    /// At each height the plane has a level line. The distance of that line from the axis is proportional to
    /// the difference between its height and the height at which the plane meets the axis.
    #[inline(always)]
    fn of(rays: &RayRow, normal: F32x3, square: f32) -> Self {
        let per_z = 1.0 / normal.z;
        let spread = Native::sqrt(square * dot_xy(normal, normal)) * per_z.abs();
        Self { height: dot(normal, rays.origin) * per_z, spread }
    }
}
