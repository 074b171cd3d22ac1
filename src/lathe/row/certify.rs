//! Whether a tracked root is its ray's nearest: whether g keeps its sign all along the ray before it.
//!
//! Where the ray enters the solid at the root, the slope of g there most often proves it. Let A = dg/ds be
//! that slope, and let J be |dz| times the sum of the *slope jumps* at the knots that the ray may have passed
//! before. Between knots `g″ ≤ 2K`, with `K = convexity·dz² − q` of the segment. Then, at a distance p before
//! the root,
//!
//! `g ≤ −(A − J)·p + K·p²`,
//!
//! which is negative if `K ≤ 0 < A − J`. So one comparison a pixel certifies the root, as far back along the
//! ray as all segments have K ≤ 0 and J times the span is less than a quarter of the tolerance. For such a J
//! any A suffices that exceeds [`SegmentBounds::slack`](super::bounds::SegmentBounds::slack), which is more
//! than 16·J: it is 2·|D|·√tolerance at least, and span·|D| ≥ 1 and √tolerance < 1/2. Where the ray leaves
//! the solid at the root, g is concave in each of these segments, and the slope jumps between them take less
//! than a quarter of the tolerance from g. So g is positive in all of them if it is positive where the ray
//! comes into the first.
//!
//! These proofs reach back to a segment with K > 0, or to a slope jump too large to count as rounding. For
//! the part of the ray before that place, the cubics of its segments give an upper bound of g, or of −g if
//! the ray leaves the solid at the root. If the bound is negative, g keeps its sign there; how far below zero
//! the bound is decides for how many pixels.
//!
//! In the root's own segment K may be positive. There g is a cubic in p, with the factor p. So |g| = p·B,
//! where B is a quadratic in p as long as g keeps its sign. B is |A| at the root, and it is positive where
//! the ray comes into the segment, since g has the right sign there. If B is concave, it is positive between
//! the two; the sign of F‴·dz decides whether it is concave. If B is convex, let `c = |F‴/6|·|dz|³` be its
//! coefficient of p², and P the distance from the root to where the ray comes in. Then, since B is not
//! negative at P, it is at least `(1 − p/P)·(|A| − c·p·P)` between. P is at most `h/|dz|`, with h the
//! segment's height. So B is positive if `|A| > |F‴/6|·h²·|dz|`.
//! Where |A| is less, [`Sweep::is_nearest_at`] decides, pixel by pixel. In integers the height from where the
//! ray comes in up to the root is tried first instead of h: that decides most of these pixels.
//!
//! Where the ray runs nearly level, the slope proves more, whatever the convexity of the segments. Along the
//! ray `g′ = F′·dz − (x² + y²)′`. Let `a = −(x² + y²)′` at the root, how fast the ray approaches the axis
//! there. Back along the ray a only grows, for x² + y² is convex, and F′·dz is at least −S·|dz|, with S the
//! largest slope of the profile. So if a > S·|dz|, g rises all the way to the root, and was negative before,
//! as long as it has no jumps. A is at most a + S′·|dz|, with S′ the largest slope of the root's segment: so
//! A > (S + S′)·|dz| suffices.

use super::bounds::ROOT;
use super::ray_row::RayRow;
use super::skip::{Above, Path};
use super::sweep::{Certificate, Start, Sweep};
use crate::arithmetic::Numbers;
use crate::lathe::segment::Segment;
use crate::math::minmax::greater;

/// For how many pixels at most a certificate holds whose proof is how fast the ray approaches the axis: that
/// proof takes the largest |dz| of the rays of these pixels. The value is a choice.
const LEVEL_PIXELS: u32 = 32;

/// What is known of the tracked root.
pub(super) enum Certification {
    /// The tracked root is the nearest, for this reason.
    Nearest(Certificate),
    /// The ray may meet this instead: a cap, a ring or another root, nearer than the tracked root. Where the
    /// ray passes just beside a rim, it is a root shortly behind that rim.
    Another(Start),
    /// Neither is certain.
    Undecided,
}

/// What is known of the part of a ray before the first of the [`Concave`] segments.
enum Before {
    /// g keeps its sign in that part, for all pixels from the one asked for to before `until`.
    Clear { until: u32 },
    /// The ray may meet this there.
    MayMeet(Start),
    /// Neither is certain.
    Undecided,
}

/// The root's own segment and those before it along the ray in each of which g is concave, as far as slope
/// jumps between them are too small to matter.
struct Concave<'a> {
    /// The segment of them that the ray meets first, and its index.
    first: &'a Segment,
    index: usize,
    /// Whether the ray meets no other segment before `first`.
    is_all: bool,
}

impl Sweep<'_> {
    /// Decides whether the tracked root, if the i-th ray has one in the segment `root.segment`, is the ray's
    /// nearest. A certificate says for how many of the next rays it holds. This changes no field.
    pub(super) fn certify(&self, i: u32) -> Certification {
        let (bounds, root) = (&self.bounds, &self.root);
        let (segment, enters) = (root.segment, root.sign.is_sign_positive());
        let is_concave = segment.convexity <= bounds.max_convexity;
        let [_, _, _, f3] = segment.f;
        let mut bump = if is_concave { 0.0 } else { f3.abs() };
        let mut passed = Concave { first: segment, index: root.index, is_all: false };
        let (rises, turns) = self.rises_until(i);
        // If F‴·dz has this sign, B is concave: see the top of this file.
        if (f3 > 0.0) != (rises == enters) {
            bump = 0.0;
        }
        if is_concave || !enters && bump == 0.0 {
            passed = self.concave(rises);
        }
        let own = &root.own;
        let mut slope = own.slack;
        if bump > 0.0 {
            slope += bump * segment.per_height * bounds.steep;
        }
        // Before all segments the ray may still meet a ring outside of the wall of the end.
        let before = if enters && passed.is_all && !bounds.lathe.frame.has_jumps {
            Before::Clear { until: u32::MAX }
        } else {
            let path = self.path(i);
            let (approach, dz) = bounds.numbers.approach(&path, root.motion[0]);
            // dz is linear in the pixel's number.
            let last = dz + LEVEL_PIXELS as f32 * self.direction.rays.direction_change().z;
            let dz = greater(dz.abs(), last.abs());
            let least = self.least_approach(dz, own.slack);
            if approach > least {
                (slope, bump) = (least + segment.max_slope * dz, f32::NAN);
                Before::Clear { until: i.saturating_add(LEVEL_PIXELS) }
            } else {
                self.before(i, &path, &passed)
            }
        };
        match before {
            Before::Clear { until } => {
                let certain = greater(slope, self.clear_slope(rises, own.tolerance));
                Certification::Nearest(Certificate { certain, slope, bump, until: until.min(turns) })
            }
            Before::MayMeet(start) => Certification::Another(start),
            Before::Undecided => Certification::Undecided,
        }
    }

    /// The slope above which a tracked root is certain to lie behind the point where the rays begin by more
    /// than the tolerance divided by the slope. It is zero if the rays begin before the solid. If they begin
    /// near it, the slope is infinite, unless all of the root's segment lies beyond the heights at which they
    /// do.
    #[inline(always)]
    fn clear_slope(&self, rises: bool, tolerance: f32) -> f32 {
        let Self { bounds, root, .. } = self;
        if bounds.start == f32::NEG_INFINITY {
            return 0.0;
        }
        let RayRow { origin, direction, right, at, apart } = &self.direction.rays;
        let height = origin.z - bounds.shift * direction.z;
        let change = right.z * (at - bounds.shift * apart);
        let beyond = if rises { root.segment.low - height } else { height - root.segment.high };
        let beyond = beyond - self.direction.len as f32 * change.abs();
        if beyond > bounds.tolerance {
            tolerance * bounds.steep / (beyond - bounds.tolerance)
        } else {
            f32::INFINITY
        }
    }

    /// How fast a ray must approach the axis at the tracked root, so that g rises all the way to the root:
    /// the number that `a`, at the top of this file, must exceed. `dz` is |dz|, or a bound of it, `slack`
    /// that of the root's segment. The result is infinite if g may jump upwards, if the ray leaves the solid
    /// at the root, or if a probe costs less than this test in the arithmetic.
    fn least_approach(&self, dz: f32, slack: f32) -> f32 {
        let frame = self.bounds.lathe.frame;
        if Numbers::HAS_APPROACH && self.root.sign > 0.0 && !frame.has_jumps {
            frame.max_slope * dz + slack
        } else {
            f32::INFINITY
        }
    }

    /// Whether the i-th ray rises, and the first pixel after it for whose ray that is not certain.
    pub(super) fn rises_until(&self, i: u32) -> (bool, u32) {
        if let Some(is_rising) = self.bounds.rising {
            return (is_rising, u32::MAX);
        }
        self.turn(i)
    }

    /// Does what [`Sweep::rises_until`] does, where rays of both kinds may be.
    // Not inline: part of it would be computed for all spans of a row.
    #[cold]
    #[inline(never)]
    fn turn(&self, i: u32) -> (bool, u32) {
        let rays = &self.direction.rays;
        let change = rays.direction_change().z;
        let dz = rays.direction.z + change * (i as f32 + 0.5);
        let turn = -dz / change;
        // The conversion to u32 saturates.
        (dz > 0.0, if turn > 0.0 { i.saturating_add((turn as u32).max(1)) } else { u32::MAX })
    }

    /// The root's own segment, and those before it as long as g is concave in each along every ray of the
    /// row, and the slope jumps between them together raise g by less than a quarter of the tolerance.
    /// (Rounding changes g by another quarter at most.) `is_rising` says whether the rays rise.
    fn concave(&self, is_rising: bool) -> Concave<'_> {
        let bounds = &self.bounds;
        let (mut first, mut index, mut slope_jumps) = (self.root.segment, self.root.index, 0.0);
        loop {
            let is_all = if is_rising { first.low <= bounds.low } else { first.high >= bounds.high };
            let before = if is_rising { index.wrapping_sub(1) } else { index + 1 };
            let Some(next) = bounds.lathe.segments.get(before).filter(|_| !is_all) else {
                return Concave { first, index, is_all };
            };
            let with_next = slope_jumps + if is_rising { next.slope_jump } else { first.slope_jump };
            // At a step the slope jump is infinite.
            if !(next.convexity <= bounds.max_convexity
                && with_next * bounds.steep * bounds.span < 0.25 * bounds.tolerance)
            {
                return Concave { first, index, is_all };
            }
            (slope_jumps, first, index) = (with_next, next, before);
        }
    }

    /// Whether g keeps its sign along the part of the i-th ray before it comes into the first of the `passed`
    /// segments, and for how many of the next rays as well. g is to be negative if the ray enters the solid
    /// at the tracked root, positive if it leaves it.
    #[inline(always)]
    fn before(&self, i: u32, path: &Path, passed: &Concave) -> Before {
        let (bounds, root) = (&self.bounds, &self.root);
        let sign = root.sign;
        let interval = self.interval(path);
        if sign.is_sign_negative() && !self.may_begin_inside(path, interval) {
            return Before::Undecided;
        }
        // The proofs for the root's own segment need the sign of g where the ray comes into it, unless the
        // slope suffices. So g is bounded at that point in any case, even if that point lies before `near`.
        let by_slope = sign.is_sign_positive() && root.segment.convexity <= bounds.max_convexity;
        let before = bounds.numbers.before(self, path, interval, passed.first, !by_slope);
        let plane = passed.index + usize::from(!path.rises());
        let start = match self.below_zero(i, path, sign, before, plane) {
            Ok(until) => return Before::Clear { until },
            Err(Above { is_near: true, .. }) => return Before::Undecided,
            Err(Above { start, .. }) => start,
        };
        // `start.sign` says which way `sign·g` crosses zero; times `sign` it says which way g does. If no
        // start is known, g has the wrong sign already where the ray comes into the root's segment, just past
        // a rim. Then another root may lie shortly behind that point, in the same segment, where g crosses
        // zero the other way than at the tracked root.
        let Start { index, s, sign: crosses } = start.unwrap_or_else(|| Start {
            index: root.index,
            s: bounds.numbers.length(path, before.1),
            sign: -1.0,
        });
        Before::MayMeet(Start { index, s, sign: sign * crosses })
    }

    /// Whether a root is certain to be its ray's nearest, where the slope alone does not prove it. The
    /// certificate must hold for the ray. If the rays begin near the solid, the root must lie behind that
    /// place by more than rounding. If then the slope is less than the certificate asks for, g must keep its
    /// sign between the point where the ray comes into the root's segment and the root; the certificate says
    /// that g has the right sign at that point.
    ///
    /// `u` and `s` are those of the root, `q` is the ray's dx² + dy². As in [`Sweep::track`], the ray is
    /// reversed for a root where it leaves the solid: `kappa` is κ = du/ds along that ray, and `slope` is
    /// dg/ds at the point where the last Newton step began: the root plus `back` lengths of the direction,
    /// along that ray.
    ///
    /// Let A be the slope at the root, and w the distance in u from the root back towards the ray's origin.
    /// Then, with g″ taken at the root,
    ///
    /// `sign·κ²·g = −w·B(w)`, `B = A·|κ| − c₂·w + c₃·w²`, `c₂ = sign·g″/2`, `|c₃| = |f3|·κ²`.
    ///
    /// B is positive at the root and where the ray comes in. So it is positive between if c₃ ≤ 0. If c₃ > 0,
    /// B is positive between if c₂ < 0, if its discriminant is negative, or if it falls all the way: w is at
    /// most 1, and so before B's vertex if c₂ > 2·c₃. The certificate's `bump` stands for |f3|. If c₃ ≤ 0 or
    /// a concave g is certain, it is zero; then only the slope is tested here.
    ///
    /// The root is off by ROOT at most, and so g is not zero there, but A·ROOT at most: κ² times that is added
    /// to −w·B. B is least at its vertex, w = c₂/(2·c₃). It must exceed A·κ²·ROOT/w there.
    ///
    /// Beside this, a root is the nearest if the ray approaches the axis fast enough there, whatever the
    /// certificate.
    #[cold]
    #[inline(never)]
    pub(super) fn is_nearest_at(&self, u: f32, s: f32, slope: f32, back: f32, q: f32, kappa: f32) -> bool {
        let Segment { f: [_, f1, f2, f3], low, high, .. } = *self.root.segment;
        let own = &self.root.own;
        let Certificate { slope: certain, bump, .. } = self.root.certificate;
        if !((s + self.bounds.shift) * slope > own.tolerance) {
            return false;
        }
        if slope > certain {
            return true;
        }
        let half = 3.0 * f3 * u + f2;
        let curve = half * (kappa * kappa) - q;
        let (c2, slope) = (self.root.sign * curve, slope - 2.0 * curve * back);
        let approach = slope - ((half + f2) * u + f1) * kappa;
        let kappa = kappa.abs();
        let c3 = bump * kappa * kappa;
        approach > self.least_approach(kappa * (high - low), own.slack)
            || slope > own.slack
                && (c2 > 2.0 * c3 || {
                    let per_vertex = 2.0 * c3 / c2;
                    let margin = own.tolerance + slope * kappa * ROOT * per_vertex;
                    c2 * c2.abs() < 4.0 * (slope - margin) * kappa * c3
                })
    }
}
