//! For how many of the next pixels a margin lasts.

use super::Path;
use super::cubic::Cubic;
use crate::arithmetic::integers::{Divisor, Numbers, dot, high, narrowed, product, shifted, square_root};
use crate::lathe::row::skip::FALL;
use crate::lathe::row::sweep::Sweep;

impl Numbers {
    /// The number of next pixels for whose rays sign·g is certain to stay below zero, at every height that
    /// the i-th ray has in an interval of s. `path` is that ray. On it sign·g plus the tolerance is at most
    /// −`margin`; `margin` is positive. Zero if no next pixel is certain. See [`Sweep::below_zero`].
    ///
    /// The motion v is computed as that over 2^`fine` pixels, so that it has as many bits as there is room
    /// for.
    #[inline(never)]
    pub(in crate::lathe::row) fn certified_run(
        self,
        _sweep: &Sweep,
        _i: u32,
        path: &Path,
        sign: f32,
        margin: i64,
        (from, to): (i32, i32),
    ) -> u32 {
        let rays = path.rays;
        let [dx, dy, dz] = path.d;
        let is_level = rays.origin_change[2] == 0 && rays.direction_change[2] == 0;
        let (mut fine, mut most, mut fall) = (rays.finer - 3, i32::MAX, 0);
        if !is_level {
            // Heights change from pixel to pixel. In `most` pixels the point of a height moves by SPANS
            // spans, or dz falls by FALL of itself. At an s of 1 + SPANS spans heights may change that many
            // times faster than within the span. So from pixel to pixel it moves less than 2⁵ spans over
            // `most`, and a span is less than 2²⁷ units.
            let change = rays.direction_change[2];
            fall = if path.rises() { -change } else { change };
            let drift = i64::from(rays.limits.drift);
            let level = drift.max(shifted(i64::from(fall) * (1.0 / FALL) as i64, 3 - rays.finer)) + 1;
            most = Divisor::wide(level).of(dz.abs(), 0);
            if most == 0 {
                return 0;
            }
            // Two less than the logarithm of `most`; it is not zero, but `ilog2` would link a panic for zero.
            fine = fine.min(29 - most.leading_zeros() as i32);
        }
        // An interval that ends before it begins, perhaps far away, has no height to look at: its end stands
        // for it.
        let from = from.min(to);
        let (middle, half) = ((from + to) >> 1, (to - from + 1) >> 1);
        let [x1, y1, z1] = rays.origin_change.map(|x| x >> (rays.finer - fine));
        let [dx1, dy1, dz1] = rays.direction_change.map(|x| x >> (rays.finer - 3 - fine));
        // The motion of the ray's point at fixed s, less what takes the point back to its height along the
        // ray, at the middle and by how much it changes to the interval's end.
        let at_height = |[x, y, z]: [i32; 3]| {
            let along = if is_level { 0 } else { path.per_dz.of(z, 32) };
            [x - high(along, dx), y - high(along, dy)]
        };
        let [px, py, _] = path.at(middle);
        let (p, h) = ([px, py], [dx, dy].map(|d| high(half, d)));
        let v = at_height([x1 + high(middle, dx1), y1 + high(middle, dy1), z1 + high(middle, dz1)]);
        let w = at_height([dx1, dy1, dz1].map(|d| high(half, d)));
        // In n pixels sign·g changes by −2·n·sign·⟨P, v⟩ − n²·sign·v². `pace` is the largest value of
        // −sign·⟨P, v⟩ in the interval, and `square` that of −sign·v². The motions
        // at all heights of the interval are parallel, except for rounding. So v² is largest at one end of the
        // interval, and least at the other, unless v is zero between the two.
        let is_negative = sign.is_sign_negative();
        let pace = [dot(p, v), dot(p, w) + dot(h, v), dot(h, w), 0];
        let pace = Cubic::new(pace.map(|c| if is_negative { c } else { -c })).most();
        let (vw, ww) = (dot(v, w).abs(), dot(w, w));
        let ends = dot(v, v) + ww;
        let square = match is_negative {
            true => ends + 2 * vw,
            false if vw >= ww => 2 * vw - ends,
            false => 0,
        };
        let mut run = run(margin, pace, square, fine).min(most);
        if fall > 0 {
            // n/(1 + n·ε) is no less than n·(1 − n·ε), and n·ε no more than FALL.
            let part = path.per_dz.of_wide(i64::from(run) * i64::from(fall), 33 - rays.finer).abs();
            run -= ((i64::from(run) * i64::from(part)) >> 30) as i32 + 1;
        }
        run.max(0) as u32
    }
}

/// 2^`fine`·n, rounded down, for the n with which `2·n·pace + n²·square` comes to the margin; the three have
/// the same units. If it never does, a number greater than any row is long.
fn run(margin: i64, pace: i64, square: i64, fine: i32) -> i32 {
    let ([margin, pace, square, _], _) = narrowed([margin, pace, square, 0]);
    // Rounded to the safe side.
    let [margin, pace, square] = [margin - 1, pace + 1, square + 1];
    let discriminant = product(pace, pace) + product(square, margin);
    let root = square_root(discriminant) + 1;
    let (number, divisor) = if pace >= 0 { (margin, pace + root) } else { (root - 1 - pace, square) };
    if discriminant < 0 || divisor <= 0 { i32::MAX } else { Divisor::new(divisor).of(number, fine) }
}
