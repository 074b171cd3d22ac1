//! Whether a tracked root is its ray's nearest: whether g keeps its sign all along the ray before it.
//!
//! Most often an entering root's own slope says so. Let A = dg/ds there, J the sum of the *slope jumps* at the
//! knots that the ray may have passed before, times |dz|, and `g″ ≤ 2K` between knots. Then x before the root
//!
//! `g ≤ −(A − J)·x + K·x²`, K = convexity·dz² − q, J = slope_jumps·|dz|.
//!
//! That is negative where `K ≤ 0 < A − J`: one comparison a pixel, as far back as one segment after another
//! has K ≤ 0. Before a root that leaves, through as many segments, g is concave, and so positive if it is
//! where they begin.
//!
//! That ends at a segment with K > 0, or at a slope jump that is more than rounding. There an upper bound
//! from the ray's cubics certifies that g keeps its sign before, and for how many pixels more.
//!
//! In a root's own segment, whatever its K, g keeps its sign if it has it where the ray comes in, and, going
//! back from the root, does not curve the wrong way first and the right way then, which the sign of F‴·dz
//! decides. Where it may, the slope must be more than `|F‴/6|·h²·|dz|`, h the segment's height; where it is
//! not, the segment's cubic is asked, pixel by pixel.

use super::skip::UpperBound;
use super::sweep::{Certificate, RootStart, Sweep};
use crate::lathe::segment::Segment;
use crate::math::minmax::lesser;

/// What is found of a root that is tracked.
pub(super) enum Certification {
    /// It is the nearest, for this reason.
    Nearest(Certificate),
    /// It may not be: one may lie here. It may be nearer, or, past a rim, just behind.
    Another(RootStart),
    /// Neither is known.
    Undecided,
}

/// The part of a ray before a root's segment.
enum Before {
    /// g keeps its sign there, for all pixels before this one.
    Clear { until: u32 },
    /// A root may lie there.
    MayMeet(RootStart),
    /// Neither is known.
    Undecided,
}

/// The segments through which the slope alone certifies a root, from the root's own back along the ray.
struct Concave<'a> {
    /// The one that the ray meets first.
    first: &'a Segment,
    /// The sum of the slope jumps between them.
    slope_jumps: f32,
    /// Whether the ray meets no other segment before.
    is_all: bool,
}

impl Sweep<'_> {
    /// Decides whether the root in the tracked segment is the nearest on the i-th ray and those that follow
    /// it.
    pub(super) fn certify(&self, i: u32) -> Certification {
        let (bounds, root) = (&self.bounds, &self.root);
        let (segment, enters) = (root.segment, root.sign > 0.0);
        let is_concave = segment.convexity <= bounds.max_convexity;
        let [_, _, _, f3] = segment.f;
        let mut bump = if is_concave { 0.0 } else { f3.abs() };
        let mut passed = Concave { first: segment, slope_jumps: 0.0, is_all: false };
        if let Some(is_rising) = bounds.rising {
            // g curves the right way all the way back.
            if (f3 > 0.0) != (is_rising == enters) {
                bump = 0.0;
            }
            if is_concave || !enters && bump == 0.0 {
                passed = self.concave(is_rising);
            }
        }
        let before = if enters && passed.is_all {
            Before::Clear { until: u32::MAX }
        } else {
            self.before(i, passed.first)
        };
        match before {
            Before::Clear { until } => {
                let slope = (passed.slope_jumps + bump * segment.per_height) * bounds.steep + bounds.slack;
                Certification::Nearest(Certificate { slope, bump, until })
            }
            Before::MayMeet(start) => Certification::Another(start),
            Before::Undecided => Certification::Undecided,
        }
    }

    /// The segments, from the root's own back, through which g is concave along every ray of the row, but for
    /// slope jumps that raise it by less than a quarter of the tolerance. (A quarter, since rounding has
    /// another: the tolerance is four times what it was seen to do.) All rays rise, or all fall.
    #[inline(always)]
    fn concave(&self, is_rising: bool) -> Concave<'_> {
        let bounds = &self.bounds;
        let (mut first, mut index, mut slope_jumps) = (self.root.segment, self.root.index, 0.0);
        loop {
            let is_all = if is_rising { first.low <= bounds.low } else { first.high >= bounds.high };
            index = if is_rising { index.wrapping_sub(1) } else { index + 1 };
            let Some(next) = bounds.lathe.segments.get(index).filter(|_| !is_all) else {
                return Concave { first, slope_jumps, is_all };
            };
            let with_next = slope_jumps + if is_rising { next.slope_jump } else { first.slope_jump };
            if !(next.convexity <= bounds.max_convexity
                && with_next * bounds.steep * bounds.span < 0.25 * bounds.tolerance)
            {
                return Concave { first, slope_jumps, is_all };
            }
            (slope_jumps, first) = (with_next, next);
        }
    }

    /// Whether g keeps its sign, below zero before a root that enters, above before one that leaves, until
    /// the i-th ray comes to a segment; and for how many pixels it still does.
    #[inline(always)]
    fn before(&self, i: u32, segment: &Segment) -> Before {
        let (bounds, root) = (&self.bounds, &self.root);
        let ray = self.ray(i);
        let (path, sign) = (self.path(ray), root.sign);
        let frame = bounds.lathe.frame;
        let end = if path.rises() { &frame.base } else { &frame.top };
        // A root that leaves is seen through an open end: through a cap the ray would have entered.
        if sign < 0.0 && end.part.is_some() {
            return Before::Undecided;
        }
        let (near, far) = self.interval(&path);
        let far = lesser(far, path.slab(segment.low, segment.high).0);
        // The point where the segment begins is bounded, too, even if the interval begins behind it: unless
        // the slope says enough of the segment by itself, its proof needs the sign of g at that point.
        let by_slope = sign > 0.0 && root.segment.convexity <= bounds.max_convexity;
        let before = (if by_slope { near } else { lesser(near, far) }, far);
        let UpperBound { g, start } = self.upper_bound(&path, sign, before);
        if g < -bounds.tolerance {
            let run = self.certified_run(&path, ray, sign, -g - bounds.tolerance, before);
            return Before::Clear { until: (i + 1).saturating_add(run) };
        }
        if g < bounds.tolerance {
            return Before::Undecided;
        }
        // What crosses before the bound's sign is turned round crosses the other way in g. With no start
        // known, it is just behind the rim of the end, in the root's own segment, and crosses as the tracked
        // root does not.
        let RootStart { index, s, sign: crosses } =
            start.unwrap_or(RootStart { index: root.index, s: far, sign: -1.0 });
        Before::MayMeet(RootStart { index, s, sign: sign * crosses })
    }

    /// Whether g keeps its sign from where a ray comes into the tracked root's segment as far as the root, by
    /// the segment's cubic. In: the root's u; the slope of g at the point as far beyond the root as Newton's
    /// last step, `back`, went back; the ray's q; and its dz in units of u.
    ///
    /// With κ = |du/ds|, A the slope at the root, and y the way back from it in u,
    ///
    /// `κ²·g = −y·B(y)`, `B = A·κ − c₂·y + c₃·y²`,
    ///
    /// and B has no zero if its discriminant is negative.
    #[cold]
    #[inline(never)]
    pub(super) fn is_nearest_by_cubic(&self, u: f32, slope: f32, back: f32, q: f32, dz: f32) -> bool {
        let [_, _, f2, f3] = self.root.segment.f;
        let kappa = dz.abs();
        let square = kappa * kappa;
        let curve = (3.0 * f3 * u + f2) * square - q;
        let (c2, slope) = (self.root.sign * curve, slope - 2.0 * curve * back);
        let bounds = &self.bounds;
        slope > bounds.slack
            && c2 * c2.abs()
                < 4.0 * (slope - bounds.tolerance) * kappa * (self.root.certificate.bump * square)
    }
}
