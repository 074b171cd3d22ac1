//! What is known of all rays of a part of a row: where they pass the solid, by how much they differ, and at
//! which pixel to begin.

use super::ray_row::RayRow;
use crate::lathe::frame::{LENGTH_TOLERANCE, View};
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::{F32x3, cross, dot, dot_xy, one_norm, vector};

/// The half-width in g, besides rounding, of the *undecided band* about zero.
///
/// A choice, in the frame, where the largest radius is between 1 and 2: 128 times the error in s that
/// Newton's method leaves ([`ROOT`]), and 2⁻¹³/r of a radius r, which is a hundredth of a pixel where the
/// solid is 240 pixels wide.
const TOLERANCE: f32 = 1.0 / 4096.0;

/// The error in s that the last of Newton's steps may leave, 2⁻¹⁹, in units of the direction.
///
/// Along a surface of radius 1 it turns the normal by 2⁻¹⁹, and so changes a shade of 255 by 2⁻¹¹ of a step
/// at most.
const ROOT: f32 = 1.0 / 524_288.0;

/// The largest tolerance of a row of any use: a quarter of the least square that the largest radius may have,
/// 1.
const MOST_TOLERANCE: f32 = 0.25;

/// By how much the ball around the solid is widened, of radius R ≥ 1, for a ray outside of it to miss by more
/// than the tolerance: there g ≤ −(1.125² − 1)·R² < −0.26, and a usable row's tolerance is below
/// [`MOST_TOLERANCE`].
const WIDENED: f32 = 1.125;

/// How far along a ray, in spans of the row, the point of a given height may move within the pixels that one
/// probe certifies.
///
/// A choice: heights are bounded over so much more of the ray, and a probe holds for as many pixels as they
/// take to move so far.
pub(super) const SPANS: f32 = 4.0;

/// A part of a row of `width` pixels: the columns from `start` to before `end`.
pub(crate) struct RowPart {
    pub width: u32,
    pub start: u32,
    pub end: u32,
    /// Whether another solid may hide this one: then the sweep certifies misses only, and leaves all others
    /// to rays of their own.
    pub is_shared: bool,
}

/// What is known of all rays of a part of a row.
pub(super) struct RowBounds<'a> {
    pub lathe: View<'a>,
    /// Whether none of the rays comes near the solid.
    pub is_culled: bool,
    /// Whether the bounds are of use. They are not if the rays spread too wide, begin too near the solid, or
    /// so far away that rounding decides; then every ray is cast by itself.
    pub is_usable: bool,
    /// Whether roots are tracked: if the bounds are of use, and no other solid may be nearer.
    pub may_track: bool,
    /// s = 0 is at `shift` times the direction on each ray. A distance t along a ray, times `unit`, is
    /// counted as `shift + s`.
    pub shift: f32,
    pub unit: f32,
    /// The column that the right half begins with, the number of columns of the left half, and whether that
    /// is the mirror image of the right one.
    pub middle: u32,
    pub left: u32,
    pub is_mirrored: bool,
    /// Every point of the solid on every ray has |s| ≤ span.
    pub span: f32,
    /// The heights between which rays can meet the solid.
    pub low: f32,
    pub high: f32,
    /// The largest |dz|.
    pub steep: f32,
    /// The least q/dz²: where half the profile's second derivative is no more than this, g is concave along
    /// every ray.
    pub max_convexity: f32,
    /// Whether all rays rise, or all fall. `None` if there are some of both, or no roots are tracked.
    pub rising: Option<bool>,
    /// The largest |∂z/∂i| within the span, over four spans: how fast the height of a point of given s
    /// changes.
    pub drift: f32,
    /// What lies nearer than this to a decision, in g or in height, is not decided by the row.
    pub tolerance: f32,
    /// The slope that a tracked root must exceed: `2·√(q·tolerance) + 16·ROOT·Q`, Q a bound of |g″/2|.
    ///
    /// With the first term g rises behind the root to more than the tolerance, A²/(4·q), unless the profile
    /// curves it more than q does. With the second there is a root where Newton's last step ends, a step of
    /// `b² ≤ ROOT·A/Q`: Kantorovich asks for `A ≥ 4·Q·b`, and so for `A ≥ 16·Q·ROOT`.
    pub slack: f32,
    /// ROOT/Q. A step `b² ≤ step_tolerance·A` leaves an error of `Q·b²/A`, ROOT at most.
    pub step_tolerance: f32,
}

impl RowPart {
    /// Half the number of pixels.
    #[inline(always)]
    pub fn half(&self) -> f32 {
        0.5 * (self.end - self.start) as f32
    }

    /// The column half way, or, of an even number of pixels, half way between two.
    #[inline(always)]
    pub fn center(&self) -> f32 {
        self.start as f32 - 0.5 + self.half()
    }
}

impl<'a> RowBounds<'a> {
    /// The bounds of a part's rays in the frame, counted from the one half way, whose M is perpendicular to
    /// it. `shift` and `unit` are as in [`RowBounds`]; `rough` is the size of the numbers, in the frame, as
    /// which origins were rounded.
    #[inline(always)]
    pub fn new(lathe: View<'a>, rays: &RayRow, shift: f32, unit: f32, rough: f32, part: &RowPart) -> Self {
        let (half, center) = (part.half(), part.center());
        let frame = lathe.frame;
        let RayRow { origin: m, origin_step: m1, direction: d, direction_step: d1 } = *rays;
        // |M + s·D| ≤ size means |s| ≤ |M·D|/D² + size/|D|. M·D is zero half way, and D² and q lie above their tangents
        // there.
        let square = dot(d, d);
        let least = square - 2.0 * half * dot(d, d1).abs();
        let length = Native::sqrt(least);
        let across = half * (dot(m, d1) + dot(m1, d)).abs() + half * half * dot(m1, d1).abs();
        let span = (across / length + frame.size) / length;
        let distance = shift.abs() * length + frame.size + rough;
        // What rounding can do to a place, and to g: four times what it was seen to do.
        let slip = LENGTH_TOLERANCE * distance;
        let rounding = frame.g_tolerance * distance;
        let tolerance = TOLERANCE + rounding;
        // Where one of the rays is within the ball, the one half way is within a larger one, by how far they
        // are apart.
        let near = WIDENED * frame.size + slip + half * (one_norm(m1) + span * one_norm(d1));
        let is_outside_ball = dot(m, m) > near * near;
        let q = dot_xy(d, d) - 2.0 * half * dot_xy(d, d1).abs();
        let steep = d.z.abs() + half * d1.z.abs();
        let drift = m1.z.abs() + span * d1.z.abs();
        // Of use: if no ray is shorter than half the one half way, so that no bound is more than doubled by the spread; if the
        // eye is outside the span; and if rounding leaves something to decide.
        let is_usable = !frame.has_rings
            && least > 0.25 * square
            && q > 0.0
            && shift > span + slip
            && tolerance < MOST_TOLERANCE;

        let Plane { height, slope } = Plane::of(rays, frame.bounding_square + tolerance);
        let slope = slope + slip;
        let (low, high) = (greater(frame.low, height - slope), lesser(frame.high, height + slope));
        let is_culled = is_outside_ball || is_usable && low > high;
        let is_mirrored = !is_culled && is_usable && !part.is_shared && {
            // Pixels as far from the middle on either side see the same g at the same s, but for an eighth of
            // the rounding; the same heights, which count at the solid's ends; and the plane between them
            // passes the axis as near.
            let asymmetry = 8.0 * asymmetry(rays, span, drift * (1.0 + frame.max_slope));
            frame.squash == 1.0
                && (part.end - part.start).is_multiple_of(2)
                && half * asymmetry < rounding
                && asymmetry < 0.5 * rounding * one_norm(m1)
        };
        let middle = if is_culled {
            part.start
        } else if is_mirrored {
            part.start + (part.end - part.start) / 2
        } else {
            let height = lesser(frame.high, greater(frame.low, height));
            let pixel = center + nearest_pixel(rays, vector([0.0, 0.0, height]));
            part.start.max(part.end.min((pixel + 0.5) as u32))
        };
        // The longest ray of a usable row has D² ≤ 2·square: from D² = square + 2i·⟨D, D₁⟩ + i²·D₁², since
        // the eye is outside the span, which is at least half²·D₁²·shift/least, half²·D₁² < least = square −
        // 2·half·|⟨D, D₁⟩|. The rest is for rounding.
        let longest = 2.25 * square;
        // A bound of |g″/2| on any of them.
        let most = longest + frame.curvature * (steep * steep);
        let has_one_side = is_usable && !part.is_shared && d.z.abs() > half * d1.z.abs();
        Self {
            lathe,
            is_culled,
            is_usable,
            may_track: is_usable && !part.is_shared,
            shift,
            unit,
            middle,
            left: middle - part.start,
            is_mirrored,
            span,
            low,
            high,
            steep,
            max_convexity: q / (steep * steep),
            rising: has_one_side.then_some(d.z > 0.0),
            drift: drift / (SPANS * span),
            tolerance,
            slack: 2.0 * Native::sqrt(longest * tolerance) + 16.0 * ROOT * most,
            step_tolerance: ROOT / most,
        }
    }
}

/// How much g can differ, at the same s within the span, between the rays a pixel before the one half way and
/// a pixel after it; `drop` bounds how much F differs. Over n pixels it is n times as much: what differs in
/// x² + y² are the terms that change their sign with the pixel's number.
#[inline(always)]
fn asymmetry(rays: &RayRow, span: f32, drop: f32) -> f32 {
    let RayRow { origin: m, origin_step: m1, direction: d, direction_step: d1 } = *rays;
    let odd = dot_xy(m, d1) + dot_xy(m1, d);
    4.0 * (dot_xy(m, m1).abs() + span * (odd.abs() + span * dot_xy(d, d1).abs())) + 2.0 * drop
}

/// The plane of a row's rays.
struct Plane {
    /// The height at which it meets the axis.
    height: f32,
    /// By how much its heights within a cylinder around the axis differ from that at most.
    slope: f32,
}

impl Plane {
    /// The plane of the rays, given the square of the cylinder's radius. At each height the plane has a line,
    /// whose distance from the axis is proportional to the height from where the plane meets it.
    #[inline(always)]
    fn of(rays: &RayRow, reach: f32) -> Self {
        let normal = cross(rays.origin_step, rays.direction);
        let per_z = 1.0 / normal.z;
        let slope = Native::sqrt(reach * dot_xy(normal, normal)) * per_z.abs();
        Self { height: dot(normal, rays.origin) * per_z, slope }
    }
}

/// About how many pixels from the one half way the ray is that passes nearest to a point.
#[inline(always)]
fn nearest_pixel(rays: &RayRow, point: F32x3) -> f32 {
    let RayRow { origin, origin_step, direction, direction_step } = *rays;
    let there = point - origin;
    let along = dot(there, direction) / dot(direction, direction);
    let step = origin_step + direction_step * along;
    dot(there - direction * along, step) / dot(step, step)
}
