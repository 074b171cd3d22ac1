//! The innermost loop: a root is tracked from ray to ray, predicted from its last changes and corrected by
//! Newton's method.

use super::normal::{Seen, Wall};
use super::sweep::{STEPS, Sweep, TrackEnd};
use crate::math::cold_path;
use crate::math::minmax::greater;
use crate::vector::{F32x3, dot_xy, vector};

/// How many pixels at most are tracked in one call.
///
/// From pixel to pixel M and D grow by an addition. After 64 of these they are off by 64·2⁻²⁴ of the solid's
/// size at most, and g by four times that, 2⁻¹⁶, which is a sixteenth of the tolerance.
const MOST_PIXELS: u32 = 64;

impl Sweep<'_> {
    /// The pixel before which a call of [`Sweep::track`] that begins with the i-th must end. It is i or less
    /// if the root has no certificate for the i-th pixel.
    #[inline(always)]
    pub(super) fn limit(&self, i: u32) -> u32 {
        (i + MOST_PIXELS.min(self.direction.len - i)).min(self.root.certificate.until)
    }

    /// Tracks the root from the i-th pixel to before pixel `to`, and calls `see` for each, with what it sees
    /// and the s of the root. Returns the first pixel for which `see` was not called, `to` at most: tracking
    /// has ended there, and [`Sweep::next`] is to be asked for what follows.
    #[inline(always)]
    pub fn track(&mut self, mut i: u32, to: u32, mut see: impl FnMut(&Seen, f32)) -> u32 {
        let Self { bounds, root, .. } = &*self;
        let (segment, sign) = (root.segment, root.sign);
        let wall = Wall::new(segment, sign, bounds.lathe.frame.root_squash);
        // Where a ray leaves the solid, the reversed ray enters it. So for sign = −1 the ray is reversed. It
        // is also mirrored in the plane y = 0, since `Wall::seen` takes `sign·y`.
        let point = |p: F32x3, low: f32| vector([p.x, sign * p.y, (p.z - low) * segment.per_height]);
        let toward = |d: F32x3| vector([sign * d.x, d.y, d.z * (sign * segment.per_height)]);
        let (m, d) = self.ray(i);
        let (mut m, mut d) = (point(m, segment.low), toward(d));
        let rays = &self.direction.rays;
        let (m1, d1) = (point(rays.origin_step, 0.0), toward(rays.direction_step));
        let [c0, c1, c2, c3] = segment.f;
        // If the rays begin near the solid, each root is to be compared with that place.
        let certain = if bounds.start > f32::NEG_INFINITY { f32::INFINITY } else { root.certificate.slope };
        let step_tolerance = root.certificate.own.step_tolerance;
        // Within the tolerance of the solid's ends and of steps, in height, the row decides nothing.
        let pad = bounds.tolerance * segment.per_height;
        let knot_pad = bounds.knot_tolerance * segment.per_height;
        let from = if root.index == 0 { pad } else { knot_pad };
        let to_end = if root.index + 1 == bounds.lathe.segments.len() { pad } else { knot_pad };
        let width = greater(0.0, 1.0 - from - to_end).to_bits();
        let (mut s, mut step, mut bend) = (root.s, root.step, root.bend);
        let start = i;

        let mut end = TrackEnd::Limit;
        'pixels: while i < to {
            let predicted = s;
            let mut tries = STEPS;
            loop {
                let (x, y, u) = (m.x + s * d.x, m.y + s * d.y, m.z + s * d.z);
                let c3u = c3 * u;
                let p2 = c3u + c2;
                let p1 = p2 * u + c1;
                let f = p1 * u + c0;
                let f1 = (c3u + p2) * u + p1;
                let b = x * d.x + y * d.y;
                let slope = f1 * d.z - (b + b);
                let back = (f - (x * x + y * y)) / slope;
                s -= back;
                // After a step the error is at most `back²·|g″/2|/slope`. If the slope is NaN or negative,
                // the test fails.
                if !(back * back <= step_tolerance * slope) {
                    cold_path();
                    tries -= 1;
                    if tries == 0 || !(slope > 0.0) {
                        end = TrackEnd::Diverged;
                        break 'pixels;
                    }
                    continue;
                }
                let (x, y, u) = (x - back * d.x, y - back * d.y, u - back * d.z);
                // As unsigned integers, the bits of a negative number or a NaN exceed those of `width`.
                if (u - from).to_bits() > width {
                    end = TrackEnd::Left { upper: u > 0.5 };
                    break 'pixels;
                }
                if !(slope > certain || self.is_nearest_at(u, sign * s, slope, back, dot_xy(d, d), d.z)) {
                    end = TrackEnd::Uncertified;
                    break 'pixels;
                }
                see(&wall.seen(x, y, u), sign * s);
                break;
            }
            // s is predicted from its first difference, `step`, and its second one, `bend`. The error of the
            // prediction that was just corrected is added to `bend`.
            bend += s - predicted;
            step += bend;
            s += step + bend;
            m += m1;
            d += d1;
            i += 1;
        }
        let root = &mut self.root;
        (root.s, root.step, root.bend, root.end) = (s, step, bend, Some(end));
        if i > start {
            root.tries = STEPS;
        }
        i
    }
}
