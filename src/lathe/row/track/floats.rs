//! The innermost loop in floats.

use crate::arithmetic::floats::{Length, Normal, Numbers, Rays};
use crate::lathe::row::sweep::{NEWTON_STEPS, Sweep, TrackEnd};
use crate::lathe::segment::Segment;
use crate::math::cold_path;
use crate::math::minmax::{greater, lesser};
use crate::vector::{F32x3, dot_xy, vector};

/// The part of a segment's height, at either end, in which a root where the ray enters the solid may be left
/// undecided. The value is a choice: each of these pixels is a single ray.
const LOW: f32 = 1.0 / 1024.0;

impl Numbers {
    /// [`Sweep::track`] in floats.
    #[inline(always)]
    pub(in crate::lathe::row) fn track(
        self,
        sweep: &mut Sweep,
        _rays: &Rays,
        i: u32,
        to: u32,
        mut see: impl FnMut(&Normal, Length),
    ) -> u32 {
        let Sweep { bounds, root, .. } = &*sweep;
        let (segment, sign) = (root.segment, root.sign);
        let wall = Wall::new(segment, sign, bounds.lathe.frame.root_squash);
        // Where a ray leaves the solid, the reversed ray enters it. So for sign = −1 the ray is reversed. It
        // is also mirrored in the plane y = 0, since `Wall::seen` takes `sign·y`.
        let point = |p: F32x3, low: f32| vector([p.x, sign * p.y, (p.z - low) * segment.per_height]);
        let toward = |d: F32x3| vector([sign * d.x, d.y, d.z * (sign * segment.per_height)]);
        let (m, d) = sweep.ray(i);
        let (mut m, mut d) = (point(m, segment.low), toward(d));
        let rays = &sweep.direction.rays;
        let (m1, d1) = (point(rays.origin_change(), 0.0), toward(rays.direction_change()));
        let [c0, c1, c2, c3] = segment.f;
        let certain = root.certificate.certain;
        let newton_tolerance = root.own.newton_tolerance;
        // A root is undecided if its height is within the tolerance of an end or of a step. A root where the
        // ray leaves the solid is also undecided within the slip of any other knot: at a sharp waist,
        // rounding decides whether the ray leaves there. So is one where it enters, at a crease seen edge on,
        // but in a low segment only in a small part of its height.
        let pad = bounds.tolerance * segment.per_height;
        let slip =
            if sign < 0.0 { bounds.slip } else { lesser(bounds.slip, LOW * (segment.high - segment.low)) };
        let knot_pad = greater(bounds.knot_tolerance, slip) * segment.per_height;
        let from = (if root.index == 0 { pad } else { knot_pad }).to_bits();
        let to_end = if root.index + 1 == bounds.lathe.segments.len() { pad } else { knot_pad };
        let width = greater(0.0, 1.0 - to_end).to_bits().saturating_sub(from);
        let [mut s, mut change, mut bend] = root.motion.map(f32::from_bits);
        let count = to.saturating_sub(i);
        let mut left = count;

        let mut end = TrackEnd::Limit;
        'pixels: while left > 0 {
            let mut tries = NEWTON_STEPS;
            let ahead;
            loop {
                // In this order the compiler leaves few results to wait for, see docs/TRIED.md.
                let (sx, sy, sz) = (s * d.x, s * d.y, s * d.z);
                let (x, y, u) = (m.x + sx, m.y + sy, m.z + sz);
                let (c3u, xd, yd) = (c3 * u, x * d.x, y * d.y);
                let (p2, b) = (c3u + c2, xd + yd);
                let (p2u, xx, l, yy) = (p2 * u, x * x, c3u + p2, y * y);
                let (p1, lu, square) = (p2u + c1, l * u, xx + yy);
                let (f1, p1u, b2) = (lu + p1, p1 * u, b + b);
                let (fd, f) = (f1 * d.z, p1u + c0);
                let (slope, g) = (fd - b2, f - square);
                let back = g / slope;
                // The error of the prediction is added to `bend`.
                s -= back;
                bend -= back;
                // After a Newton step the error is at most `back²·|g″/2|/slope`. If the slope is NaN or
                // negative, the test fails.
                if !(back * back <= newton_tolerance * slope) {
                    cold_path();
                    tries -= 1;
                    if tries == 0 || !(slope > 0.0) {
                        end = TrackEnd::Diverged;
                        break 'pixels;
                    }
                    continue;
                }
                let u = u - back * d.z;
                // As unsigned integers, the bits of positive numbers are in the numbers' order, and those of
                // a negative one or a NaN exceed them all. Below `from` the difference wraps around.
                if u.to_bits().wrapping_sub(from) > width {
                    end = TrackEnd::Left { upper: u > 0.5 };
                    break 'pixels;
                }
                if !(slope > certain || sweep.is_nearest_at(u, sign * s, slope, back, dot_xy(d, d), d.z)) {
                    end = TrackEnd::Uncertified;
                    break 'pixels;
                }
                let x = x - back * d.x;
                change += bend;
                let across = wall.across(x);
                let along = wall.along(u);
                let y = y - back * d.y;
                ahead = change + bend;
                see(&Normal(vector([across, y, along])), Length(sign * s));
                break;
            }
            // s is predicted from its first difference, `change`, and its second one, `bend`.
            s += ahead;
            m += m1;
            d += d1;
            left -= 1;
        }
        let root = &mut sweep.root;
        (root.motion, root.end) = ([s, change, bend].map(f32::to_bits), Some(end));
        if left < count {
            root.tries = NEWTON_STEPS;
        }
        i + (count - left)
    }
}

/// What the normals of a segment's wall are computed from where a root is tracked.
struct Wall {
    /// √k times the root's sign.
    signed_squash: f32,
    /// The coefficients of −½·dF/dz times the root's sign, in powers of u, constant term first.
    e: [f32; 3],
}

impl Wall {
    /// The wall of a segment, seen from outside at a root where rays enter the solid (`sign` is 1), from
    /// inside at one where they leave it (−1). `root_squash` is √k.
    #[inline(always)]
    fn new(segment: &Segment, sign: f32, root_squash: f32) -> Self {
        let Segment { per_height, f: [_, c1, c2, c3], .. } = *segment;
        let along = -0.5 * sign * per_height;
        Self { signed_squash: sign * root_squash, e: [along * c1, along * 2.0 * c2, along * 3.0 * c3] }
    }

    /// The x of the normal at a point of the wall with this x, scaled by √k.
    #[inline(always)]
    fn across(&self, x: f32) -> f32 {
        self.signed_squash * x
    }

    /// The z of the normal at a point of the wall with this parameter u in the segment.
    #[inline(always)]
    fn along(&self, u: f32) -> f32 {
        let [e0, e1, e2] = self.e;
        (e2 * u + e1) * u + e0
    }
}
