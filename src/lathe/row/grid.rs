//! The rays of all pixels of a picture in a lathe's frame, and what is known of all of them. For a row of the
//! picture the rays follow by a few operations.

use crate::arithmetic::{Numbers, Views};
use crate::lathe::frame::{Frame, LENGTH_TOLERANCE};
use crate::lathe::row::ray_row::RayRow;
use crate::math::const_fn::upper_root;
use crate::vector::{F32x3, cross, difference, dot, dot_xy, one_norm, scale, sum, vector};

/// The half-width, in g, of the *undecided band* about zero; what rounding can do comes on top.
///
/// The value is a choice. It is 128 times the error in s that Newton's method leaves (`ROOT`). Where the
/// radius is r, g changes by 2·r times as much as the radius does. So a change of g by the tolerance is a
/// change of the radius by 2⁻¹³/r. In the frame the solid's largest radius is between 1 and 2: at that radius
/// the change is about a hundredth of a pixel if the solid is 240 pixels wide.
pub(super) const TOLERANCE: f32 = 1.0 / 4096.0;

/// The bounds are of no use if the tolerance is not less than this: a quarter of the least value that the
/// square of the solid's largest radius can have in the frame, which is 1.
pub(super) const MOST_TOLERANCE: f32 = 0.25;

/// The factor by which the ball around the solid is enlarged, so that a ray outside of it misses by more than
/// the tolerance. The ball's own radius R is at least 1. At a point outside of the enlarged ball, at a height
/// of the solid, g ≤ −(1.125² − 1)·R² < −0.26; and the tolerance of a usable row is below [`MOST_TOLERANCE`].
pub(super) const WIDENED: f32 = 1.125;

/// Within the pixels that one probe certifies, the point of a given height may move along the rays by this
/// many times the span.
///
/// The value is a choice. If it is larger, a probe may hold for more pixels, but it has to bound g along a
/// longer part of its ray.
pub(super) const SPANS: f32 = 4.0;

/// In a picture, how many times as long as the solid's size the span may be, for the bounds to be of use. It
/// is longer where a squashed solid is seen along x: then the rays of one row may have a shorter one.
///
/// The value is a choice. The longer the span, the fewer bits integers have behind the point.
const MOST_SPAN: f32 = 8.0;

/// The rays of a picture, or of one row of it, in object space.
///
/// Pixels are counted from the middle, columns to the right and rows downwards: the numbers i and j of a
/// pixel's column and row may be halves. With the vector `i·right − j·up`, times `pitch`, in perspective the
/// direction of a ray is the sum of that vector and `forward`. In orthographic view it is `forward`, and the
/// ray's origin is the sum of `eye` and that vector times `unit`.
pub(crate) struct CameraRays {
    pub eye: F32x3,
    pub forward: F32x3,
    pub right: F32x3,
    pub up: F32x3,
    pub pitch: f32,
    /// The point of a ray at distance t is its origin plus `unit·t` times its direction.
    pub unit: f32,
    pub is_perspective: bool,
    /// An upper bound of |x| + |y| + |z| over the origins of the rays, measured in the world, where each of
    /// them was rounded by itself; zero if all rays have the same origin.
    pub rough: f32,
    /// Half the number of columns and of rows. For one row, `half_rows` is zero, and j is zero.
    pub half_columns: f32,
    pub half_rows: f32,
}

/// The rays of a picture, or of one row of it, in a lathe's frame: `M + s·D`, with M and D linear in i and j.
///
/// M lies on one plane for all rays, `⟨λ, M⟩ = 0`, where the covector λ is such that `⟨λ, D⟩ = 1` for all of
/// them. So s is ⟨λ, P⟩ at the point P of any ray. If the solid is not squashed, λ is the direction of view,
/// and s the depth from a plane through the frame's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RayGrid {
    /// M of the middle ray in the frame, and its D in object space, which [`Frame::squashed`] takes to the
    /// frame.
    origin: F32x3,
    direction: F32x3,
    /// From column to column M changes by `at·right` and D by `apart·right`, from row to row by −`at·up` and
    /// −`apart·up`. `right` and `up` are in object space, as `direction` is.
    right: F32x3,
    up: F32x3,
    at: f32,
    pub apart: f32,
    /// Whether the bounds are of use, as far as that is the same for all rows.
    pub is_usable: bool,
    /// Whether the rays begin before the solid, at an s below −`span`.
    pub begins_before: bool,
    /// Whether the left half of each row sees the mirror image of what its right half sees.
    pub is_mirrored: bool,
    /// What the bounds of a row have by these names.
    pub shift: f32,
    pub unit: f32,
    pub span: f32,
    pub drift: f32,
    pub slip: f32,
    pub longest: f32,
    /// A bound of |M| of all rays.
    pub far: f32,
    /// The distance of row j's plane from the frame's origin is at least |place + j·place_change|, in units
    /// of the radius of a ball that is met by each ray that comes near the solid. Both are zero for the rays
    /// of one row.
    place: f32,
    place_change: f32,
    /// The column whose ray is nearest to the axis at the height z is about
    /// `(axis[0] + z·axis[1])/(at + z·axis[2])`.
    axis: [f32; 3],
}

impl RayGrid {
    /// No rays: memory for those of a picture. All of its bits are zero.
    pub const NONE: Self = Self {
        origin: vector([0.0; 3]),
        direction: vector([0.0; 3]),
        right: vector([0.0; 3]),
        up: vector([0.0; 3]),
        at: 0.0,
        apart: 0.0,
        is_usable: false,
        begins_before: false,
        is_mirrored: false,
        shift: 0.0,
        unit: 0.0,
        span: 0.0,
        drift: 0.0,
        slip: 0.0,
        longest: 0.0,
        far: 0.0,
        place: 0.0,
        place_change: 0.0,
        axis: [0.0; 3],
    };

    /// The rays in the frame of a lathe.
    #[inline(always)]
    pub const fn new(frame: &Frame, rays: &CameraRays) -> Self {
        let CameraRays { pitch, half_columns, half_rows, .. } = *rays;
        let eye = frame.point(rays.eye);
        let [forward, right, up] =
            [frame.squashed(rays.forward), frame.squashed(rays.right), frame.squashed(rays.up)];
        let unit = frame.scale * rays.unit;

        // λ is perpendicular to `right`, and, if there are several rows, to `up`.
        let (along, square) = (dot(forward, right), dot(right, right));
        let per_square = if square > 0.0 { 1.0 / square } else { 0.0 };
        let (lambda, lambda_square);
        if half_rows > 0.0 {
            let normal = cross(right, up);
            lambda = scale(normal, 1.0 / dot(forward, normal));
            lambda_square = dot(lambda, lambda);
        } else {
            let flat = difference(forward, scale(right, along * per_square));
            lambda_square = 1.0 / dot(flat, flat);
            lambda = scale(flat, lambda_square);
        }
        let back = -dot(lambda, eye);
        let origin = sum(eye, scale(forward, back));
        let (at, apart) = if rays.is_perspective { (back * pitch, pitch) } else { (unit * pitch, 0.0) };

        // |⟨λ, P⟩| of the points of the solid.
        let span = frame.size * upper_root(lambda_square);
        // D² is convex in i and j, and so largest in a corner. The factor is for rounding, of D as well.
        let columns = half_columns * apart;
        let mut longest = dot(forward, forward) + 2.0 * columns * along.abs() + columns * columns * square;
        if half_rows > 0.0 {
            let rows = half_rows * apart;
            longest += rows * (2.0 * dot(forward, up).abs() + rows * dot(up, up))
                + 2.0 * columns * rows * dot(right, up).abs();
        }
        let longest = longest * (1.0 + 1.0 / 1024.0);
        let distance = back.abs() * upper_root(longest) + frame.size + rays.rough * unit;
        let wide = at.abs() * half_columns * one_norm(right);
        let far = one_norm(origin) + wide + at.abs() * half_rows * one_norm(up);
        let slip = Numbers::new(span, longest, far).slip(LENGTH_TOLERANCE * distance);
        let begins_before = back > span + slip;
        let height_change = (at.abs() + span * apart) * right.z.abs();
        let most_span = if half_rows > 0.0 { MOST_SPAN * frame.size } else { f32::MAX };
        let is_usable =
            span <= most_span && TOLERANCE + 2.0 * slip < MOST_TOLERANCE && frame.max_slope < f32::INFINITY;

        let (mut place, mut place_change) = (0.0, 0.0);
        if half_rows > 0.0 {
            // The normal of row j's plane is that of the middle row's plus j times its change.
            let (normal, change) = (cross(right, forward), scale(cross(right, up), -apart));
            let longest_normal =
                upper_root(dot(normal, normal)) + half_rows * upper_root(dot(change, change));
            let per_place = 1.0 / ((WIDENED * frame.size + slip) * longest_normal);
            place = dot(normal, origin) * per_place;
            place_change = (dot(change, origin) - at * dot(normal, up)) * per_place;
        }

        let is_mirrored = is_usable && frame.squash == 1.0 && {
            // Two pixels at the same distance from the middle on either side must agree, to half of what
            // rounding can do: in g at the same s; in the height, which counts at the solid's ends; and in
            // how near the plane between them passes the axis. Rounding can change g by 2 + S times the slip,
            // where S is the largest |dF/dz|. The disagreement in g is computed for S = 2. When S grows by 1,
            // it grows by that in height, less than half of the slip, and what rounding can do by the slip.
            //
            // The difference of g at the same s between the rays one pixel before the middle and one after it
            // is twice the derivative of x² + y² and of F over i. Between the rays n pixels before the middle
            // and n pixels after it, it is n times as large: x² + y² is quadratic in i.
            let most = at.abs() + span * apart;
            let mut odd = most * (dot_xy(origin, right).abs() + span * dot_xy(forward, right).abs());
            if half_rows > 0.0 {
                odd += half_rows * most * most * dot_xy(up, right).abs();
            }
            // So g disagrees by half of `asymmetry` at most, the height by a quarter of it. The plane between
            // the pixels passes the axis at a distance of about an eighth of it, divided by `wide`, at most.
            let asymmetry = 8.0 * half_columns * (odd + height_change);
            asymmetry < 2.0 * slip && asymmetry < slip * wide
        };
        let axis =
            [-dot(origin, right) * per_square, (right.z - lambda.z * along) * per_square, lambda.z * apart];
        Self {
            origin,
            direction: rays.forward,
            right: rays.right,
            up: rays.up,
            at,
            apart,
            is_usable,
            begins_before,
            is_mirrored,
            shift: back,
            unit,
            span,
            drift: height_change / (SPANS * span),
            slip,
            longest,
            far,
            place,
            place_change,
            axis,
        }
    }

    /// The half-width of the undecided band, as [`RowBounds`](super::bounds::RowBounds) has it by this name.
    #[inline(always)]
    pub const fn tolerance(&self) -> f32 {
        TOLERANCE + 2.0 * self.slip
    }

    /// Whether the plane of row j of a picture is certain to pass the solid by.
    #[inline(always)]
    pub fn passes_by(&self, j: f32) -> bool {
        (self.place + j * self.place_change).abs() > 1.0
    }

    /// The rays of row j of a picture in the lathe's frame, counted from the middle of the row, and a normal
    /// of their plane. `None` stands for the row if the rays are those of one row.
    #[inline(always)]
    pub(super) fn row(&self, frame: &Frame, j: Option<f32>) -> (RayRow, F32x3) {
        let (at, apart, right) = (self.at, self.apart, frame.squashed(self.right));
        let (mut origin, direction) = (self.origin, frame.squashed(self.direction_of(j)));
        if let Some(j) = j {
            origin -= frame.squashed(self.up) * (j * at);
        }
        let rays = RayRow { origin, direction, right, at, apart };
        (rays, cross(right, direction))
    }

    /// The direction of the middle ray of such a row, in object space.
    #[inline(always)]
    fn direction_of(&self, j: Option<f32>) -> F32x3 {
        j.map_or(self.direction, |j| self.direction - self.up * (j * self.apart))
    }

    /// The directions of the rays of such a row in object space, in the columns before `end`.
    #[inline(always)]
    pub fn views(&self, j: Option<f32>, width: u32, end: u32) -> Views {
        let change = self.right * self.apart;
        Views::new(self.direction_of(j) - change * (0.5 * width as f32 - 0.5), change, end)
    }

    /// About the column, counted from the middle, whose ray is nearest to the axis at a height.
    #[inline(always)]
    pub fn axis_column(&self, z: f32) -> f32 {
        let [column, change, depth_change] = self.axis;
        (column + z * change) / (self.at + z * depth_change)
    }

    /// A normal, in object space, of the plane in which a mirrored row's left half is the mirror image of its
    /// right half.
    pub const fn mirror(&self) -> F32x3 {
        self.right
    }
}
