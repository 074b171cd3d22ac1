//! The fast path of one ray: conservative tests at one or two places that decide most rays.
//!
//! A place is a point of the ray, at a height of the solid. There g and its slope are known, and elsewhere g
//! lies below a parabola, by bounds of the whole profile: at the distance s from a place where g is c0 and
//! has the slope c1,
//!
//! `g ≤ c0 + (|c1| + J)·|s| + K·s²`, `K = convexity·dz² − q`, `J = (sum of the slope jumps)·|dz|`.
//!
//! The steps are
//!
//! 1. Reject: the ray misses if it passes the bounding cylinder. Its distance from the axis is its moment
//!    about the axis divided by √q, so the test compares squares and takes no division.
//! 2. Place: the point nearest to the axis, or, if that is above or below the solid, the point on the plane
//!    of the end.
//! 3. Bound: the ray misses if the parabola stays below zero.
//! 4. Solve: the cubic of the place's own segment, without its last term, has a root where the ray may enter
//!    the solid. If that root is in the segment, Newton's method finds the cubic's root from there. If not,
//!    steps 3 and 4 are repeated once, for the place at that root, or, if there is none, where the cubic
//!    without its last term is largest.
//! 5. Certify: with the slope A at the root, `g ≤ −(A − J)·x + K·x²` at the distance x before the root. If A
//!    exceeds J, that is negative for every x, and so the root is the nearest.
//!
//! Each decision keeps a tolerance, which is more than rounding can change g by:
//!
//! - For a miss, g must stay below zero by more than the tolerance.
//! - For a hit, g must rise above the tolerance somewhere beyond the root, as it does where
//!   `(A − J)² > 4·tolerance·|g″/2|`; and the root must be farther than the tolerance from the ends of the
//!   segment and from the start of the ray.
//!
//! All else is undecided and left to the *traversal*. Comparisons are written so that NaN decides nothing.
//!
//! Where a profile has steps, g may jump upwards, too. For misses the sum of all jumps is part of the
//! tolerance. Hits of such a lathe are left to the traversal.
//!
//! The code computes with half slopes: those of g and of x² + y², and J/2.

use super::is_beyond;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::lathe::frame::{Frame, View};
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native, UNIT_ROUNDOFF, cold_path};
use crate::ray::Ray;

/// What the fast path decides about a ray.
pub(super) enum Decision {
    /// The ray has no crossing beyond `t_min`.
    Miss,
    /// This is the ray's nearest crossing beyond `t_min`, and enters the solid.
    Hit(Hit),
    /// The traversal has to decide.
    Undecided,
}

/// The q above which a ray is flat enough for the fast path: with q ≥ 1/4, √q ≤ 2·q and |dz| ≤ q + dz², as
/// the tolerance needs (see [`LENGTH_TOLERANCE`](crate::lathe::frame::LENGTH_TOLERANCE)).
const FLAT: f32 = 0.25;

/// The most steps of Newton's method. They begin at the root of the parabola, which is off by the cubic term
/// only, and most rays take one or two. Each step squares the error: three bring an error of 1/4 to 2⁻¹⁶, and
/// the fourth to 2⁻³². A ray that needs more is undecided.
const NEWTON_STEPS: u32 = 4;

/// The error in s that the last of Newton's steps may leave, in units of the direction: 2⁻²⁵, the rounding of
/// s where it is at most 1.
const ROOT_ERROR: f32 = 0.5 * UNIT_ROUNDOFF;

/// What the bounds of g along a ray are computed from, the same at every place.
struct Slopes<'a> {
    frame: &'a Frame,
    dz: f32,
    /// dx² + dy², x scaled by √k.
    q: f32,
    /// convexity·dz². K is this minus q. A ray whose K is not negative is left undecided.
    convexity: f32,
}

/// A point of a ray.
struct Place {
    /// How far back the ray's origin is from the place, in units of the direction: the place is at the origin
    /// minus `back` times the direction. It is negative for a place that the ray reaches.
    back: f32,
    /// The squared distance from the axis.
    square: f32,
    /// Half the derivative of `square` along the ray.
    half_slope: f32,
    /// The height.
    z: f32,
}

/// g about a place, along the cubic of the place's segment.
struct Expansion<'a> {
    segment: &'a Segment,
    /// The segment's parameter u at the place.
    u: f32,
    /// κ, the derivative of u along the ray.
    kappa: f32,
    /// `[c0, c1, c2]` of `g = c0 + 2·c1·s + c2·s² + f₃·κ³·s³`.
    parabola: [f32; 3],
}

impl Slopes<'_> {
    /// J/2: half of what slope jumps can add to the slope of g along the ray.
    #[inline(always)]
    fn half_jump(&self) -> f32 {
        (self.frame.half_slope_jumps * self.dz).abs()
    }
}

impl Place {
    /// The point of a ray that is nearest to the axis, given the ray's squared moment about the axis.
    #[inline(always)]
    fn nearest_to_axis(slopes: &Slopes, ray: &Ray, moment_squared: f32) -> Self {
        let (frame, o, d) = (slopes.frame, ray.origin, ray.direction);
        let per_q = 1.0 / slopes.q;
        let back = (o.x * (d.x * frame.squash) + o.y * d.y) * frame.scale * per_q;
        let z = (o.z - frame.middle) * frame.scale - d.z * back;
        Self { back, square: moment_squared * per_q, half_slope: 0.0, z }
    }

    /// The point at the height `end`, given the one nearest to the axis.
    #[inline(always)]
    fn moved_to(self, end: f32, slopes: &Slopes) -> Self {
        let s = (end - self.z) / slopes.dz;
        let half_slope = slopes.q * s;
        Self { back: self.back - s, square: self.square + half_slope * s, half_slope, z: end }
    }

    /// The point at the distance s farther along the ray.
    #[inline(always)]
    fn moved_by(self, s: f32, slopes: &Slopes) -> Self {
        let change = slopes.q * s;
        Self {
            back: self.back - s,
            square: self.square + (self.half_slope + self.half_slope + change) * s,
            half_slope: self.half_slope + change,
            z: self.z + slopes.dz * s,
        }
    }
}

impl<'a> Expansion<'a> {
    /// The expansion of g about a place in a segment.
    #[inline(always)]
    fn about(place: &Place, segment: &'a Segment, slopes: &Slopes) -> Self {
        let (u, kappa) = ((place.z - segment.low) * segment.per_height, slopes.dz * segment.per_height);
        let [f0, f1, f2] = segment.about(u);
        let parabola = [f0 - place.square, f1 * kappa - place.half_slope, f2 * (kappa * kappa) - slopes.q];
        Self { segment, u, kappa, parabola }
    }

    /// Whether the bound certifies that g stays below zero by more than the tolerance: all along the ray, or,
    /// with `has_one_side`, for a place on the plane of an end, on that side of the plane where the solid is.
    #[inline(always)]
    fn misses(&self, place: &Place, has_one_side: bool, slopes: &Slopes, tolerance: f32) -> bool {
        let [c0, c1, _] = self.parabola;
        let highest = c0 + tolerance;
        if !(highest < 0.0) {
            return false;
        }
        // An upper bound of half the slope of g on the way from the place into the solid. If the place is on
        // the plane of an end, the solid lies on one side of it only, the side away from the ray's point
        // nearest to the axis. There s has the sign of place.half_slope.
        let half_slope = if has_one_side && place.half_slope != 0.0 {
            greater(slopes.half_jump() + c1 * 1_f32.copysign(place.half_slope), 0.0)
        } else {
            slopes.half_jump() + c1.abs()
        };
        // Whether highest + 2·half_slope·|s| + K·s², an upper bound of g + tolerance, has no root: whether
        // its discriminant is negative.
        half_slope * half_slope < (slopes.convexity - slopes.q) * highest
    }
}

/// Where the parabola of an expansion says that the ray may enter the solid.
enum Guess {
    /// At this s, in the expansion's own segment.
    Here(f32),
    /// Near the point at this s, which is in another segment or is no root: it needs an expansion of its own.
    Elsewhere(f32),
}

impl Expansion<'_> {
    /// Returns `Here` with the lower root of the parabola, which opens downwards, if the root lies in the
    /// segment; else `Elsewhere` with it, or, if there is no root, with the s where the parabola is largest.
    #[inline(always)]
    fn guess(&self) -> Guess {
        let [c0, c1, c2] = self.parabola;
        let discriminant = c1 * c1 - c2 * c0;
        let s = (Native::sqrt(discriminant) - c1) / c2;
        // Whether u is from 0 to 1, by its bits: those of NaN and of negative numbers are larger.
        if (self.u + self.kappa * s).to_bits() <= 1_f32.to_bits() {
            return Guess::Here(s);
        }
        cold_path();
        Guess::Elsewhere(if discriminant >= 0.0 { s } else { -c1 / c2 })
    }

    /// Returns the root of g that Newton's method finds from s, and with it the slope of g before the last
    /// step. `None` if after four steps the root may still be off by more than [`ROOT_ERROR`]. `most` is an
    /// upper bound of |g″/2|.
    #[inline(always)]
    fn root_near(&self, mut s: f32, most: f32) -> Option<(f32, f32)> {
        let [c0, c1, c2] = self.parabola;
        let g = Cubic::new([c0, c1 + c1, c2, self.segment.f[3] * (self.kappa * self.kappa * self.kappa)]);
        let mut steps = NEWTON_STEPS;
        loop {
            let (value, slope) = g.with_slope(s);
            let step = value / slope;
            s -= step;
            // The error that the step leaves, most·step²/slope.
            if most * step * step <= ROOT_ERROR * slope {
                return Some((s, slope));
            }
            steps -= 1;
            if steps == 0 {
                return None;
            }
        }
    }
}

impl View<'_> {
    /// Decides whether a ray has a crossing with t > `t_min`, and which is the nearest, by one or two places
    /// of the ray. Returns `Undecided` if they do not suffice.
    #[inline]
    pub(super) fn fast_path(&self, ray: &Ray, t_min: f32) -> Decision {
        let View { frame, segments } = *self;
        let (o, d) = (ray.origin, ray.direction);
        // Reject.
        let q = d.x * frame.squash * d.x + d.y * d.y;
        let moment = (o.x * d.y - o.y * d.x) * frame.moment_scale;
        let moment_squared = moment * moment;
        if moment_squared > frame.bounding_square * q {
            return Decision::Miss;
        }
        let rise = d.z * d.z;
        let slopes = Slopes { frame, dz: d.z, q, convexity: frame.convexity * rise };
        if !(q > greater(slopes.convexity, FLAT)) {
            return Decision::Undecided;
        }

        // Place.
        let mut place = Place::nearest_to_axis(&slopes, ray, moment_squared);
        let mut tolerance = frame.g_tolerance * (frame.base_distance + place.back.abs() * (q + rise));
        let end = lesser(frame.high, greater(frame.low, place.z));
        if end != place.z {
            cold_path();
            place = place.moved_to(end, &slopes);
            // The flatter the ray, the farther rounding of heights moves its point on a plane, and x² + y²
            // with it.
            tolerance *= 1.0 + (place.half_slope / d.z).abs();
            // The solid lies only on that side of the plane where the ray is farther from the axis than at
            // this point.
            if place.square > frame.bounding_square + tolerance {
                return Decision::Miss;
            }
        }

        // Bound, and guess where the root is.
        let mut index = self.index_at(place.z);
        let mut is_first = true;
        let (expansion, s) = loop {
            let Some(segment) = segments.get(index) else {
                return Decision::Undecided;
            };
            let expansion = Expansion::about(&place, segment, &slopes);
            if expansion.misses(&place, is_first, &slopes, tolerance) {
                return Decision::Miss;
            }
            match expansion.guess() {
                Guess::Here(s) => break (expansion, s),
                Guess::Elsewhere(s) if is_first => place = place.moved_by(s, &slopes),
                Guess::Elsewhere(_) => return Decision::Undecided,
            }
            is_first = false;
            index = self.index_from(index, place.z);
        };

        // Solve.
        if frame.has_jumps {
            return Decision::Undecided;
        }
        let most = q + frame.curvature * rise;
        let Some((s, slope)) = expansion.root_near(s, most) else {
            return Decision::Undecided;
        };

        // Certify.
        let margin = 0.5 * slope - slopes.half_jump();
        let u = expansion.u + expansion.kappa * s;
        let way = s - place.back;
        let unit = frame.scale * ray.unit;
        let t = way / unit;
        // The square of the true margin, (A − J)/2 at the root, must exceed most·tolerance: then g rises
        // above the tolerance beyond the root. `margin` is computed with the slope A at the point before the
        // last step of Newton's method. Let that step be e; it changes half the slope by up to most·|e|.
        // root_near ends with (most·e)² ≤ most·ROOT_ERROR·A, and the first condition below is margin² >
        // 2·most·tolerance. So
        //
        //     (most·e/margin)² < ROOT_ERROR·A/(2·tolerance).
        //
        // Let |d|² = q + dz², S = max_slope, r the largest radius, which is in [1, 2), and D the distance of
        // the ray's origin from its point nearest to the axis. Then
        //
        //     A ≤ |d|·(S + 2·r) ≤ |d|·r·(2 + S),
        //     tolerance ≥ 32·ROOT_ERROR·(2 + S)·(2.5·r + D·|d|),
        //
        // and the quotient is less than 0.075 = 0.274² if |d| ≤ 11, or if D ≥ r/4, whatever |d| is. So the
        // true margin is at least (1 − 0.274)·margin, and its square exceeds 1.05·most·tolerance. Only a
        // camera whose angle of view, measured along the diagonal, is more than 169° makes a longer
        // direction. If its eye is nearer than r/4, a part of 2·(1 − √(|d|/160))² of the tolerance is left:
        // 2/5 or more if |d| ≤ 43, as in every picture that is no taller than wide.
        //
        // way − t_min·unit is positive if is_beyond holds. So the third condition holds only if `margin` is
        // positive, too.
        let is_certain = margin * margin > 2.0 * most * tolerance
            && lesser(u, 1.0 - u) > tolerance * expansion.segment.per_height
            && (way - t_min * unit) * margin > tolerance
            && is_beyond(t, t_min);
        if is_certain {
            Decision::Hit(Hit { t, segment: index, u, enters: true, part: Part::Wall })
        } else {
            Decision::Undecided
        }
    }
}
