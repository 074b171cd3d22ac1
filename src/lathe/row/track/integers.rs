//! The innermost loop in integers.
//!
//! The table says how many bits each number has behind the point. `numbers` are the row's [`Numbers`], and
//! `block` is that of the segment's [`Wall`](crate::arithmetic::integers::Wall):
//!
//! | number | bits behind the point |
//! |---|---|
//! | s, and its changes | `numbers.s` |
//! | D, and its change from pixel to pixel | `numbers.d` |
//! | M, its change from pixel to pixel, and a point's x, y and z | `numbers.p` |
//! | v, the parameter of a segment's cubic | 31 |
//! | x and y before they are squared | 29 − block |
//! | f and g | 26 − 2·block |
//!
//! Additions are exact unless they wrap around, and no result that has wrapped around is used:
//!
//! - M: where its ray meets the solid it is less than 2³⁰ units ([`Numbers::p`]), and it changes by at most
//!   2²⁹ units from pixel to pixel, or else a call tracks one pixel only. So M does not wrap around at the
//!   pixel after one whose root was found.
//! - M + s·D: since s·D is at most 2³⁰ units, a sum that has wrapped around is 2³⁰ units or more. The loop
//!   goes on only with an x, y and z that are less.
//! - What is computed from such an x, y and z does not overflow.
//!
//! Whether a root is accepted depends on its point alone, not on the points from which Newton's method came
//! to it.

mod gradient;
mod shift;

use crate::arithmetic::integers::{
    Length, Limits, Numbers, Rays, Seen, exponent, fixed, high, inverse, power_of_two, wide,
};
use crate::lathe::row::sweep::{NEWTON_STEPS, Sweep, TrackEnd};
use crate::math::cold_path;
use crate::vector::{dot_xy, vector};
use gradient::Gradient;

/// In a segment with a larger [`Wall::block`](crate::arithmetic::integers::Wall::block) no root is tracked.
///
/// With this one rounding changes g by less than 2⁻¹⁶, which is what the additions of 64 pixels may do in floats.
/// For what is rounded, by half a unit to two units each, are the coefficients of f, three products, and two
/// squares: together 10 units of 2^(2·block − 26).
///
/// Few segments have a larger one, for which the sum that defines `block` must be 2¹⁰ or more. Let h′ be the
/// segment's height divided by 2^[`height`](crate::arithmetic::integers::Wall::height), from 1/2 to 1. In the
/// segment w = 2·v/h′ is between −1 and 1, and f between 0 and 4. So the coefficients of f in powers of w are
/// at most 4, 6, 4 and 8: f − 2 is between −2 and 2, and of all such cubics those that are twice a Chebyshev
/// polynomial have the largest coefficients. With these limits the sum is 2¹⁰ or more only if the coefficient
/// of w³ exceeds 4.5 and h′ is below 0.6.
const MOST_BLOCK: i32 = 3;

/// Whether x is from −limit to before limit.
#[inline(always)]
fn is_within(x: i32, limit: i32) -> bool {
    (x.wrapping_add(limit) as u32) < 2 * limit as u32
}

/// Whether the slope at a root exceeds `slack + (certain − slack)·p²`, where p is the part of the segment's
/// height that the ray passes before the root, see the top of `certify.rs`: a root anywhere in the segment is
/// certified by a slope above `certain`. p is `way` over the height, of which `half`, the half, is less than
/// 2³⁰ units.
fn exceeds_part(slope: i32, [slack, certain]: [i32; 2], [way, half]: [i32; 2]) -> bool {
    let way = (way as u32 >> 1) as i32 + 1;
    i64::from(slope - slack) * i64::from(high(half, half))
        > i64::from(certain - slack + 1) * i64::from(high(way, way) + 1)
}

impl Numbers {
    /// [`Sweep::track`] in integers.
    #[inline(always)]
    pub(in crate::lathe::row) fn track(
        self,
        sweep: &mut Sweep,
        rays: &Rays,
        i: u32,
        to: u32,
        mut see: impl FnMut(&Seen, Length),
    ) -> u32 {
        let Sweep { bounds, root, .. } = &*sweep;
        let (segment, certificate) = (root.segment, &root.certificate);
        let numbers = self;
        let wall = segment.wall.in_integers();
        let (block, height) = (i32::from(wall.block), i32::from(wall.height));
        // The middle and half of the height.
        let [bottom, top] = [segment.low, segment.high].map(|z| fixed(z, numbers.p));
        let (middle, half) = ((bottom + top) >> 1, (top - bottom) >> 1);

        // A root where the ray leaves the solid is tracked as one where the reversed ray enters the solid's
        // image in the axis: x and y of points change their signs, and z of directions.
        let is_inside = root.sign.is_sign_negative();
        let image = |[x, y, z]: [i32; 3], [dx, dy, dz]: [i32; 3]| {
            if is_inside { ([-x, -y, z], [dx, dy, -dz]) } else { ([x, y, z], [dx, dy, dz]) }
        };
        // Points have more bits than in `rays`, changes fewer. Where a change wraps around, the next ray does
        // not, if it is in range.
        let up = numbers.p - numbers.w;
        let rounded = |x: i32, left: i32| if left < 0 { ((x >> (-1 - left)) + 1) >> 1 } else { x << left };
        let (m, d) = rays.at(i);
        let m1 = rays.origin_change.map(|x| rounded(x, up - rays.finer));
        let d1 = rays.direction_change.map(|x| rounded(x, 3 - rays.finer));
        // Whether all components are from −most to before most, a power of two.
        let are_within = |v: [i32; 3], most: i32| {
            let [x, y, z] = v.map(|x| x.wrapping_add(most) as u32);
            x | y | z < 2 * most as u32
        };
        // After a change of less than 2²⁹ units from an M in range the next does not wrap around. Of 2^(up + 1)
        // pixels or more no change is larger: see `Rays::finer`.
        let is_near =
            rays.finer > up + 1 || are_within(rays.origin_change.map(|x| x >> rays.finer), 1 << (29 - up));
        let to = if is_near { to } else { to.min(i + 1) };
        let is_tracked = are_within(m, 1 << (30 - up)) && block <= MOST_BLOCK;
        let to = if is_tracked { to } else { i };
        let ([mut mx, mut my, mut mz], [mut dx, mut dy, mut dz]) = image(m.map(|x| x << up), d);
        let ([mx1, my1, mz1], [dx1, dy1, dz1]) = image(m1, d1);
        mz = mz.wrapping_sub(middle);

        // x and y to 29 − block bits: where they are used their magnitude is less than 3·2^block, and the sum
        // of their squares less than 18·2²⁶ < 2³¹.
        let radius_bits = (29 - block - numbers.p) as u32;
        let most_radius = (3 << (numbers.p + block)).min((1 << 30) - 1);
        let parameter_bits = (31 - numbers.p - height) as u32;

        // σ, half the slope, is a term of f, 25 − 2·block − (31 − d) − height bits, and one of x and y,
        // 28 − block − (31 − d) bits. The finer of the two is shifted.
        let finer = 2 + block - height;
        let (f_right, xy_right) = ((-finer).max(0) as u32, finer.max(0) as u32);
        let slope_bits = numbers.d - 4 - block - finer.max(0);
        // The slope is off by 8 units at most: the derivative of f by 5, of which a product with dz leaves
        // half, four products by one each, and the two bounds by half a unit.
        let [certain, slack] =
            [certificate.certain, root.own.slack].map(|a| fixed(a, slope_bits).saturating_add(8));
        let least = slack.max(1 << 12);
        // σ without its last `spare` bits has 13 or more, and its inverse in units of 2^(−32 − spare) at most
        // 2²⁰. In units of s a Newton step is g/σ·2^scale: before the product g is multiplied by 2^zoom, and
        // the inverse by 2¹⁰.
        let spare = (19 - least.leading_zeros() as i32).max(0) as u32;
        let scale = numbers.s - 30 + 31 + block - (31 - numbers.d) - finer.max(0);
        let left = scale - spare as i32 - 10;
        let zoom = left.max(1);
        let back_right = (zoom - left) as u32;
        // The last Newton step, of length b, has b² ≤ newton_tolerance·A/2: it leaves ROOT/2. A is at least
        // |D|/4 at most roots; where it is less, the least A counts. And b times the relative error of σ's
        // inverse is at most 2⁻²⁰, which is another ROOT/2. That error is 2⁻¹⁰, or more where σ may be large:
        // σ is at most half the derivative of f times |dz|, plus r·|D|, where r is less than 2.
        let most = (wall.steepest() >> 1 >> f_right) + (1 << (29 - block) >> xy_right);
        let most_bits = (numbers.s - 20 + (most >> spare).leading_zeros().min(10) as i32).max(0);
        let near = |slope: i32| {
            // The most |b| for A = 2^slope. Its square is 2^twice at most, and 11/8 is less than √2.
            let twice = 2 * numbers.s + exponent(root.own.newton_tolerance) + slope - 2;
            if twice < 0 { 0 } else { (8 + 3 * (twice & 1)) << (twice >> 1).min(most_bits) >> 3 }
        };
        let usual_slope = 29 - numbers.d;
        let usual = certain.max(1 << (slope_bits + usual_slope).max(0));
        let (near, least_near) = (near(usual_slope), near(31 - least.leading_zeros() as i32 - slope_bits));

        // A root is undecided if its height is within the tolerance of an end or of a step, `pads`. A root
        // where the ray leaves the solid is also undecided within the slip of any other knot. So is one where
        // the ray enters it, if g does not exceed the tolerance at the knot behind the root: a crease that is
        // seen edge on may be a silhouette. Up to that knot g rises by the slope times the way.
        let Limits { slip, tolerance: pad, knot_tolerance: knot_pad, .. } = rays.limits;
        let pads = [
            if root.index == 0 { pad } else { knot_pad },
            if root.index + 1 == bounds.lathe.segments.len() { pad } else { knot_pad },
        ];
        let [below, above] = pads.map(|pad| half - pad.max(slip));
        let width = (below + above).max(0) as u32;
        // Whether `exceeds_part` may certify a root: if the segment is higher than twice the slip, `certain`
        // is finite, and the rays begin before the solid.
        let has_way =
            slip < half && certain < i32::MAX && bounds.start.to_bits() == f32::NEG_INFINITY.to_bits();
        let mut gradient = Gradient::new(wall, numbers, bounds.lathe.frame.root_squash, is_inside);

        let unit = power_of_two(-numbers.s);
        let signed_unit = if is_inside { -unit } else { unit };
        let [mut s, mut change, mut bend] = root.motion.map(|bits| bits as i32);
        let count = to.saturating_sub(i);
        let mut left = count;
        let mut end = if is_tracked { TrackEnd::Limit } else { TrackEnd::Uncertified };
        'pixels: while left > 0 {
            let mut tries = NEWTON_STEPS;
            loop {
                let x = mx.wrapping_add(high(s, dx));
                let y = my.wrapping_add(high(s, dy));
                let z = mz.wrapping_add(high(s, dz));
                // In its unit |v| < 1, or the shift loses bits of z.
                let v = z << parameter_bits;
                if v >> parameter_bits != z {
                    end = TrackEnd::Left { upper: z > 0 };
                    break 'pixels;
                }
                if !(is_within(x, most_radius) && is_within(y, most_radius)) {
                    end = TrackEnd::Diverged;
                    break 'pixels;
                }
                let (near_x, near_y) = (x << radius_bits, y << radius_bits);
                let (f, slope) = wall.with_slope(v);
                let g = f - (high(near_x, near_x) + high(near_y, near_y));
                let sigma =
                    (high(slope, dz) >> f_right) - ((high(near_x, dx) + high(near_y, dy)) >> xy_right);
                // With a smaller slope no root is certified. Beyond a silhouette there is no root, which a
                // probe finds out: so tracking ends as diverged, not as uncertified.
                let divisor = if sigma < least { 0 } else { sigma as u32 >> spare };
                let Some(per_sigma) = inverse(divisor) else {
                    end = TrackEnd::Diverged;
                    break 'pixels;
                };
                let zoomed = g << zoom;
                let back = if zoomed >> zoom == g {
                    high(zoomed, (per_sigma << 10) as i32) >> back_right
                } else {
                    cold_path();
                    let right = 32 + spare as i32 - scale;
                    ((i64::from(g) * i64::from(per_sigma)) >> right).clamp(-(1 << 27), 1 << 27) as i32
                };
                s = s.wrapping_sub(back);
                bend = bend.wrapping_sub(back);
                if !is_within(back, near) {
                    cold_path();
                    tries -= 1;
                    if tries == 0 {
                        end = TrackEnd::Diverged;
                        break 'pixels;
                    }
                    continue;
                }
                let (x, y, z) = (x - high(back, dx), y - high(back, dy), z - high(back, dz));
                if z.wrapping_add(below) as u32 > width {
                    cold_path();
                    if is_inside || z + half < pads[0] || half - z < pads[1] {
                        end = TrackEnd::Left { upper: z > 0 };
                        break 'pixels;
                    }
                    let to_knot = half - if dz < 0 { -z } else { z };
                    // The product is less than 2⁴⁸, and with 12 bits more less than 2⁶⁰. It has 12 more since
                    // in a steep segment σ has few bits behind the point.
                    let rise = (i64::from(sigma) * i64::from(to_knot.min(slip))) << 12;
                    let tolerance = wide(bounds.tolerance, slope_bits + 12 + numbers.p - numbers.d) + 1;
                    let tolerance = if dz < 0 { -tolerance } else { tolerance };
                    if to_knot < slip && rise <= tolerance * i64::from(dz) {
                        end = TrackEnd::Uncertified;
                        break 'pixels;
                    }
                }
                let v = z << parameter_bits;
                if sigma <= usual {
                    cold_path();
                    if !is_within(back, least_near) {
                        tries -= 1;
                        if tries == 0 {
                            end = TrackEnd::Diverged;
                            break 'pixels;
                        }
                        continue;
                    }
                    // The way from where the ray comes into the segment may be longer by the slip than it
                    // seems.
                    let way = half + if (dz < 0) != is_inside { -z } else { z } + slip;
                    let is_steep = has_way
                        && exceeds_part(sigma, [slack, certain], [way, half].map(|z| z << parameter_bits));
                    if sigma <= certain && !is_steep {
                        let u = v as f32 * (power_of_two(height - 31) * segment.per_height) + 0.5;
                        let d = vector([dx, dy, dz].map(|d| d as f32 * power_of_two(-numbers.d)));
                        let slope = sigma as f32 * power_of_two(-slope_bits);
                        let (s, back) = (s as f32 * signed_unit, back as f32 * unit);
                        let kappa = d.z * segment.per_height;
                        if !sweep.is_nearest_at(u, s, slope, back, dot_xy(d, d), kappa) {
                            end = TrackEnd::Uncertified;
                            break 'pixels;
                        }
                    }
                }
                let Some(seen) = gradient.seen(x, y, v) else {
                    end = TrackEnd::Uncertified;
                    break 'pixels;
                };
                see(&seen, Length { units: s, unit: signed_unit });
                break;
            }
            // s is predicted as in floats.
            change = change.wrapping_add(bend);
            s = s.wrapping_add(change).wrapping_add(bend);
            (mx, my, mz) = (mx.wrapping_add(mx1), my.wrapping_add(my1), mz.wrapping_add(mz1));
            (dx, dy, dz) = (dx.wrapping_add(dx1), dy.wrapping_add(dy1), dz.wrapping_add(dz1));
            left -= 1;
        }
        let root = &mut sweep.root;
        (root.motion, root.end) = ([s, change, bend].map(|s| s as u32), Some(end));
        if left < count {
            root.tries = NEWTON_STEPS;
        }
        i + (count - left)
    }
}
