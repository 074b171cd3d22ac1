//! Upper bounds of g along a ray, in floats.

use super::{Above, FALL, Probing};
use crate::arithmetic::floats::{Numbers, Rays};
use crate::cubic::{Cubic, quadratic_max_on};
use crate::lathe::ray::LocalRay;
use crate::lathe::row::grid::SPANS;
use crate::lathe::row::ray_row::RayRow;
use crate::lathe::row::sweep::{Start, Sweep};
use crate::lathe::segment::Segment;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::vector::dot_xy;

impl Probing for Numbers {
    type Path<'a> = LocalRay;
    type Distance = f32;
}

impl Numbers {
    /// The i-th ray, with s for its t.
    #[inline(always)]
    pub(in crate::lathe::row) fn path(self, sweep: &Sweep, _rays: &Rays, i: u32) -> LocalRay {
        let (m, d) = sweep.ray(i);
        LocalRay::through(m, d)
    }

    /// Where probes begin: [`RowBounds::start`](crate::lathe::row::bounds::RowBounds::start).
    #[inline(always)]
    pub(in crate::lathe::row) fn start(self, sweep: &Sweep, _path: &LocalRay) -> f32 {
        sweep.bounds.start
    }

    /// Whether a ray is so level, and so near to the plane of an end or of a step, that both differ by less
    /// than the tolerance.
    #[inline(always)]
    pub(in crate::lathe::row) fn is_in_edge(self, sweep: &Sweep, path: &LocalRay) -> bool {
        let bounds = &sweep.bounds;
        bounds.lathe.is_near_edge(path.z, bounds.tolerance - path.dz.abs())
    }

    /// Whether a ray passes above the solid, or below it, by more than the tolerance wherever it is within
    /// the span. If so, for how many of the next rays this is certain.
    pub(in crate::lathe::row) fn beside(self, sweep: &Sweep, path: &LocalRay) -> Option<u32> {
        let (bounds, rays) = (&sweep.bounds, &sweep.direction.rays);
        let (side, edge) = if path.z > 0.0 { (1.0, bounds.high) } else { (-1.0, bounds.low) };
        let gap = side * (path.z - edge) - path.dz.abs() * bounds.span - bounds.tolerance;
        // At a fixed s the height is linear in the pixel's number.
        let closing = rays.direction_change().z.abs() * bounds.span - side * rays.origin_change().z;
        // The conversion to u32 saturates.
        (gap > 0.0).then(|| (gap / greater(0.0, closing)) as u32)
    }

    /// How fast a ray approaches the axis at s, −(x² + y²)′, and its dz. s is given by its bits.
    #[inline(always)]
    pub(in crate::lathe::row) fn approach(self, path: &LocalRay, s: u32) -> (f32, f32) {
        (-2.0 * path.around(f32::from_bits(s)).1, path.dz)
    }

    /// [`Sweep::interval`].
    #[inline(always)]
    pub(in crate::lathe::row) fn interval(self, sweep: &Sweep, path: &LocalRay) -> (f32, f32) {
        let bounds = &sweep.bounds;
        let span = (1.0 + SPANS) * bounds.span;
        let (near, far) = path.slab(bounds.low, bounds.high);
        (greater(bounds.start, greater(-span, near)), lesser(span, far))
    }

    /// The s at which a ray passes a height. For a horizontal ray it is infinite, or NaN if the ray lies at
    /// that height.
    #[inline(always)]
    pub(in crate::lathe::row) fn plane(self, path: &LocalRay, z: f32) -> f32 {
        path.plane(z)
    }

    /// An interval cut off where the ray comes into the slab of a segment. If `holds_end`, it contains that
    /// point even if it lies before the interval's begin.
    #[inline(always)]
    pub(in crate::lathe::row) fn before(
        self,
        sweep: &Sweep,
        path: &LocalRay,
        (near, far): (f32, f32),
        segment: &Segment,
        holds_end: bool,
    ) -> (f32, f32) {
        let far = lesser(far, path.slab(segment.low, segment.high).0);
        let far = greater(sweep.bounds.start, far);
        (if holds_end { lesser(near, far) } else { near }, far)
    }

    /// An s as a float.
    #[inline(always)]
    pub(in crate::lathe::row) fn length(self, _path: &LocalRay, s: f32) -> f32 {
        s
    }

    /// By how much sign·g plus its tolerance stays below zero on an interval of a ray, at least; +∞ if the
    /// interval ends before it begins. An error if an upper bound of sign·g plus its tolerance is not below
    /// zero. The segments are bounded one after another, up to the one in which [`Above::start`] is found.
    /// `last` is as in [`Sweep::below_zero`].
    #[inline(always)]
    pub(in crate::lathe::row) fn upper_bound(
        self,
        sweep: &Sweep,
        path: &LocalRay,
        sign: f32,
        (near, far): (f32, f32),
        last: usize,
    ) -> Result<f32, Above> {
        let bounds = &sweep.bounds;
        let lathe = bounds.lathe;
        let frame = lathe.frame;
        let (mut most, mut near_zero, mut start) = (f32::NEG_INFINITY, 0.0, None);
        if !(near <= far) {
            return Ok(f32::INFINITY);
        }
        let rises = path.rises();
        let (onward, entry) = if rises { (1, 0) } else { (usize::MAX, frame.len) };
        if frame.has_rings {
            let entry = if near > bounds.start { entry } else { usize::MAX };
            for (t, number, is_behind) in [(near, entry, false), (far, last, true)] {
                if let Some(plane) = lathe.plane(number) {
                    let square = if is_behind == rises { plane.above } else { plane.below };
                    most = greater(sign * (square - path.around(t).0) + bounds.tolerance, most);
                }
            }
        }
        let mut index = lathe.index_at(path.height(near));
        let mut from = near;
        // Whether sign·g is above zero where the next segment begins, as it is at the end of the one before.
        let mut is_above = false;
        while let Some(segment) = lathe.segments.get(index) {
            let (_, to) = path.slab(segment.low, segment.high);
            let to = lesser(far, to);
            let at = path.closest(from, to);
            // The segment's bounding cylinder bounds g as well, and most often suffices.
            let mut most_here = segment.bounding_square - path.around(at).0 + bounds.tolerance;
            if sign < 0.0 || is_above || !(most_here < 0.0) {
                let tolerance = bounds.tolerance_in(segment);
                let g = Cubic::new(path.g_about(segment, at).c.map(|c| sign * c));
                most_here = g.max_on(at - from, to - at) + tolerance;
                if !(most_here < 0.0) {
                    near_zero = 2.0 * tolerance;
                    let mut crosses = if g.at(from - at) > 0.0 { -1.0 } else { 1.0 };
                    let mut s = at + zero(&g, crosses);
                    // Where there is no root, Newton's steps may end anywhere.
                    let is_root = s <= to && g.at(s - at).abs() < tolerance;
                    let mut place = index;
                    if from > near && (crosses < 0.0) != is_above {
                        // Between the two segments sign·g jumps over zero.
                        (crosses, s, place) = (0.0, from, index + usize::from(!rises));
                    }
                    is_above = crosses < 0.0 && !is_root;
                    if !is_above {
                        start = Some(Start { index: place, s: greater(from, s), sign: crosses });
                    }
                }
            }
            most = greater(most_here, most);
            if start.is_some() || !(to < far) {
                break;
            }
            from = to;
            index = index.wrapping_add(onward);
        }
        if most < 0.0 { Ok(-most) } else { Err(Above { is_near: most < near_zero, start }) }
    }

    /// The number of next pixels for whose rays sign·g is certain to stay below zero, at every height that
    /// the i-th ray has in an interval of s. `path` is that ray. On it sign·g plus the tolerance is at most
    /// −`margin`; `margin` is positive. Zero if no next pixel is certain. See [`Sweep::below_zero`].
    #[inline(always)]
    pub(in crate::lathe::row) fn certified_run(
        self,
        sweep: &Sweep,
        i: u32,
        path: &LocalRay,
        sign: f32,
        margin: f32,
        (from, to): (f32, f32),
    ) -> u32 {
        let (m, d) = sweep.ray(i);
        let RayRow { right, at, apart, .. } = sweep.direction.rays;
        let drift = sweep.bounds.drift;
        let per_dz = if drift > 0.0 { path.per_dz } else { 0.0 };
        // The motion v at a height is that of the ray's point at fixed s, `(at + s·apart)·right`, and along the
        // ray by so much that z does not change. So it is `(at + s·apart)·h`, where h is horizontal.
        let rise = right.z * per_dz;
        let h = right - d * rise;
        // From here on s is counted from the middle of the interval, where the ray has its point p.
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (p, pitch) = (m + d * middle, at + apart * middle);
        // The most of −sign·⟨P, v⟩, half the first term of the change, and of −sign·v², the second.
        let (across, along) = (-sign * dot_xy(p, h), -sign * dot_xy(d, h));
        let pace = quadratic_max_on(pitch * across, pitch * along + apart * across, apart * along, half);
        let most = greater(0.0, pitch.abs() - sign * (apart * half).abs());
        let square = -sign * (most * most) * dot_xy(h, h);
        // ε, negative if dz grows. v is that of the first pixel.
        let fall = -apart * rise;
        // One over the number of pixels in which the point of a height moves by SPANS spans, or dz falls by
        // FALL of itself.
        let level = greater(drift * per_dz.abs(), fall / FALL);
        // One over the number n with which the change comes to the margin: the larger root of
        // `margin·r² − 2·pace·r − square`. If there is no such root or the margin is infinite, `rate` is NaN;
        // then, as where `rate` is not positive, the change never comes to the margin.
        let rate = (pace + Native::sqrt(pace * pace + square * margin)) / margin;
        // `greater` returns `level` if the other number is NaN. The conversion to u32 saturates.
        (1.0 / greater(level, rate + fall)) as u32
    }
}

/// About where a cubic rises through zero (sign 1) or falls through it (−1): the root of its first three
/// terms, improved by two Newton steps. If there is none, the result may be NaN or any number: it is a
/// guess.
fn zero(g: &Cubic, sign: f32) -> f32 {
    let [c0, c1, c2, _] = g.c;
    let mut s = (sign * Native::sqrt(c1 * c1 - 4.0 * c2 * c0) - c1) / (2.0 * c2);
    for _ in 0..2 {
        let (value, slope) = g.with_slope(s);
        s -= value / slope;
    }
    s
}
