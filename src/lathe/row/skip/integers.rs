//! Upper bounds of g along a ray, in integers.
//!
//! | number | bits behind the point |
//! |---|---|
//! | s, all along the part that a probe looks at | `numbers.w + 32 − numbers.d` |
//! | D | `numbers.d` |
//! | a point's x, y and z | `numbers.w` |
//! | τ, which is −1 and 1 at the ends of a part | 30 |
//! | g, r² and margins | `2·numbers.w`, in 64 bits |
//!
//! A point is off by four units at most, which are part of the row's slip; squares and sums are exact.

mod cubic;
mod motion;

use super::{Above, Probing};
use crate::arithmetic::integers::{
    Divisor, Limits, Numbers, Rays, dot, exponent, fixed, high, power_of_two, product, shifted, wide,
};
use crate::lathe::row::sweep::{Start, Sweep};
use crate::lathe::segment::Segment;
use cubic::Cubic;

/// A ray of the row, and where it is nearest to the axis.
pub(in crate::lathe::row) struct Path<'a> {
    rays: &'a Rays,
    m: [i32; 3],
    d: [i32; 3],
    per_dz: Divisor,
    /// The s of the point nearest to the axis.
    nearest: i32,
    /// How many bits s has behind the point.
    bits: i32,
}

impl Probing for Numbers {
    type Path<'a> = Path<'a>;
    type Distance = i32;
}

impl Path<'_> {
    /// Whether the ray rises or is horizontal.
    #[inline(always)]
    pub fn rises(&self) -> bool {
        self.d[2] >= 0
    }

    /// The point at s.
    #[inline(always)]
    fn at(&self, s: i32) -> [i32; 3] {
        let ([x, y, z], [dx, dy, dz]) = (self.m, self.d);
        [x + high(s, dx), y + high(s, dy), z + high(s, dz)]
    }

    /// The s at which the ray passes a height. For a horizontal ray it is the farthest s that there is, or zero
    /// if the ray lies at that height.
    fn at_height(&self, z: i32) -> i32 {
        self.per_dz.of(z - self.m[2], 32)
    }

    /// The squared distance from the axis at s.
    #[inline(never)]
    fn square(&self, s: i32) -> i64 {
        let [x, y, _] = self.at(s);
        dot([x, y], [x, y])
    }
}

impl Numbers {
    /// The i-th ray.
    #[inline(always)]
    pub(in crate::lathe::row) fn path<'a>(self, _sweep: &Sweep, rays: &'a Rays, i: u32) -> Path<'a> {
        let (m, d) = rays.at(i);
        let ([x, y, _], [dx, dy, dz]) = (m, d);
        let bits = self.w + 32 - self.d;
        // −⟨M, D⟩/⟨D, D⟩.
        let toward = dot([x, y], [dx, dy]);
        let q = dot([dx, dy], [dx, dy]);
        let nearest = Divisor::wide(q).of_wide(-toward, 32);
        Path { rays, m, d, per_dz: Divisor::new(dz), nearest, bits }
    }

    /// Where probes begin: [`RowBounds::start`](crate::lathe::row::bounds::RowBounds::start).
    #[inline(always)]
    pub(in crate::lathe::row) fn start(self, _sweep: &Sweep, path: &Path) -> i32 {
        path.rays.limits.start
    }

    /// Whether a ray is so level, and for |s| ≤ 1 so near to the plane of an end or of a step, that their
    /// heights differ by less than the tolerance.
    #[inline(always)]
    pub(in crate::lathe::row) fn is_in_edge(self, sweep: &Sweep, path: &Path) -> bool {
        let bounds = &sweep.bounds;
        let ([.., z], [.., dz]) = (path.m, path.d);
        dz.abs() < fixed(bounds.tolerance, self.d) && {
            let margin = bounds.tolerance - dz.abs() as f32 * power_of_two(-self.d);
            bounds.lathe.is_near_edge(z as f32 * power_of_two(-self.w), margin)
        }
    }

    /// Returns `None`. In floats it finds rays that pass above the solid, or below it; in integers the bounds
    /// of a probe decide these, too.
    #[inline(always)]
    pub(in crate::lathe::row) fn beside(self, _sweep: &Sweep, _path: &Path) -> Option<u32> {
        None
    }

    /// Returns zeros: in integers it is not computed how fast a ray approaches the axis, see
    /// [`Numbers::HAS_APPROACH`].
    #[inline(always)]
    pub(in crate::lathe::row) fn approach(self, _path: &Path, _s: u32) -> (f32, f32) {
        (0.0, 0.0)
    }

    /// [`Sweep::interval`] in integers.
    #[inline(always)]
    pub(in crate::lathe::row) fn interval(self, _sweep: &Sweep, path: &Path) -> (i32, i32) {
        let Limits { span, start, low, high, .. } = path.rays.limits;
        let (low, high) = (path.at_height(low), path.at_height(high));
        let (near, far) = if path.rises() { (low, high) } else { (high, low) };
        (near.max(-span).max(start), far.min(span))
    }

    /// The s at which a ray passes a height.
    #[inline(never)]
    pub(in crate::lathe::row) fn plane(self, path: &Path, z: f32) -> i32 {
        path.at_height(fixed(z, self.w))
    }

    /// An interval cut off where the ray comes into the slab of a segment. If `holds_end`, it contains that
    /// point even if it lies before the interval's begin.
    #[inline(always)]
    pub(in crate::lathe::row) fn before(
        self,
        _sweep: &Sweep,
        path: &Path,
        (near, far): (i32, i32),
        segment: &Segment,
        holds_end: bool,
    ) -> (i32, i32) {
        let plane = self.plane(path, if path.rises() { segment.low } else { segment.high });
        let far = far.min(plane).max(path.rays.limits.start);
        (if holds_end { near.min(far) } else { near }, far)
    }

    /// An s as a float.
    pub(in crate::lathe::row) fn length(self, path: &Path, s: i32) -> f32 {
        s as f32 * power_of_two(-path.bits)
    }

    /// g along the part of a ray from one s to another in a segment's slab, or −g if `is_negative`: a cubic
    /// in τ, which is −1 at the first s and 1 at the second.
    #[inline(never)]
    fn g_between(self, path: &Path, segment: &Segment, (from, to): (i32, i32), is_negative: bool) -> Cubic {
        let wall = segment.wall.in_integers();
        let [bottom, top] = [segment.low, segment.high].map(|z| fixed(z, self.w));
        // The heights lie in the slab to within rounding. They are clamped to it, so that |v| ≤ 1/2; the
        // function `clamp` would link a panic.
        let parameter_bits = (31 - self.w - i32::from(wall.height)).max(0) as u32;
        let [v0, v1] = [from, to].map(|s| {
            let [.., z] = path.at(s);
            (z.max(bottom).min(top) - ((bottom + top) >> 1)) << parameter_bits
        });
        let (v, half_height) = ((v0 >> 1) + (v1 >> 1), (v1 >> 1) - (v0 >> 1));
        let times = |x: i32| high(x, half_height) << 1;
        let (f, slope) = wall.with_slope(v);
        let [.., a2, a3] = wall.a;
        // Rounding takes less than 12 units from f, or from −f.
        let f = [
            f + if is_negative { -12 } else { 12 },
            times(slope),
            times(times(a2 + (high(3 * a3, v) << 1))),
            times(times(times(a3))),
        ];
        let (middle, half) = ((from + to) >> 1, (to - from + 1) >> 1);
        let ([x, y, _], [dx, dy, _]) = (path.at(middle), path.d);
        let (p, h) = ([x, y], [high(half, dx), high(half, dy)]);
        let squares = [dot(p, p), 2 * dot(p, h), dot(h, h), 0];
        let left = 2 * self.w + 2 * i32::from(wall.block) - 26;
        // A product takes less time than a shift of 64 bits.
        let scaled =
            |f: i32| if (0..31).contains(&left) { product(f, 1 << left) } else { shifted(f.into(), left) };
        Cubic::new(core::array::from_fn(|i| {
            let g = scaled(f[i]) - squares[i];
            if is_negative { -g } else { g }
        }))
    }

    /// By how much sign·g plus its tolerance stays below zero on an interval of a ray, at least; `i64::MAX`
    /// if the interval ends before it begins. An error if an upper bound of sign·g plus its tolerance is not
    /// below zero. The segments are bounded one after another, up to the one in which [`Above::start`] is
    /// found. `last` is as in [`Sweep::below_zero`].
    #[inline(always)]
    pub(in crate::lathe::row) fn upper_bound(
        self,
        sweep: &Sweep,
        path: &Path,
        sign: f32,
        (near, far): (i32, i32),
        last: usize,
    ) -> Result<i64, Above> {
        let bounds = &sweep.bounds;
        let lathe = bounds.lathe;
        let frame = lathe.frame;
        let (mut most, mut near_zero, mut start) = (i64::MIN + 1, 0, None);
        if near > far {
            return Ok(i64::MAX);
        }
        let of_square = |square: f32| wide(square, 2 * self.w);
        let Limits { start: begin, wide_tolerance: tolerance, wide_slip: slip, .. } = path.rays.limits;
        let is_negative = sign.is_sign_negative();
        let rises = path.rises();
        let (onward, entry) = if rises { (1, 0) } else { (usize::MAX, frame.len) };
        if frame.has_rings {
            let entry = if near > begin { entry } else { usize::MAX };
            for (s, number, is_behind) in [(near, entry, false), (far, last, true)] {
                if let Some(plane) = lathe.plane(number) {
                    let square = if is_behind == rises { plane.above } else { plane.below };
                    let g = of_square(square) - path.square(s);
                    most = most.max(tolerance + if is_negative { -g } else { g });
                }
            }
        }
        let [.., z] = path.at(near);
        let mut index = lathe.last_index(|low| fixed(low, self.w) <= z);
        let mut from = near;
        // Whether sign·g is above zero where the next segment begins, as it is at the end of the one before.
        let mut is_above = false;
        while let Some(segment) = lathe.segments.get(index) {
            let to = far.min(self.plane(path, if rises { segment.high } else { segment.low })).max(from);
            // The segment's bounding cylinder bounds g as well, and most often suffices.
            let closest = path.nearest.max(from).min(to);
            let mut most_here = of_square(segment.bounding_square) - path.square(closest) + tolerance;
            if is_negative || is_above || most_here >= 0 {
                let tolerance = tolerance + shifted(slip, exponent(segment.max_slope));
                let g = self.g_between(path, segment, (from, to), is_negative);
                most_here = g.most() + tolerance;
                if most_here >= 0 {
                    near_zero = 2 * tolerance;
                    let falls = g.with_slope(-1 << 30).0 > 0;
                    if from > near && falls != is_above {
                        // Between the two segments sign·g jumps over zero.
                        let plane = index + usize::from(!rises);
                        (is_above, start) = (false, Some((plane, from, 0.0)));
                    } else {
                        is_above = falls && g.with_slope(1 << 30).0 > 0;
                        if !is_above {
                            let way = if falls { -1 } else { 1 };
                            let place = (i64::from(to - from) * i64::from(g.zero(way))) >> 31;
                            start = Some((index, ((from + to) >> 1) + place as i32, way as f32));
                        }
                    }
                }
            }
            most = most.max(most_here);
            if start.is_some() || to >= far {
                break;
            }
            from = to;
            index = index.wrapping_add(onward);
        }
        let start = start.map(|(index, s, sign)| Start { index, s: self.length(path, s), sign });
        if most < 0 { Ok(-most) } else { Err(Above { is_near: most < near_zero, start }) }
    }
}
