use super::Functions;

/// The interval cut at the critical points; in the first piece with a change of sign, the root by `find`. Scaled by a power of two first.
fn first_root<F: Functions>(
    c: &[f32; 4],
    lo: f32,
    hi: f32,
    find: fn(&[f32; 4], f32, f32, bool) -> f32,
) -> Option<f32> {
    let largest = c.iter().fold(0f32, |largest, c| largest.max(c.abs()));
    let exponent = (largest.to_bits() >> 23).clamp(1, 253);
    let c = &c.map(|c| c * f32::from_bits((254 - exponent) << 23));
    let [_, c1, c2, c3] = *c;
    let root = F::sqrt(c2 * c2 - 3.0 * c3 * c1);
    let sum = -if c2 < 0.0 { c2 - root } else { c2 + root };
    let (one, other) = (c1 / sum, sum / (3.0 * c3));
    let cuts = if one < other { [one, other, hi] } else { [other, one, hi] };
    let mut from = lo;
    let mut positive = value(c, lo) > 0.0;
    if value(c, lo) == 0.0 {
        return Some(lo);
    }
    for cut in cuts {
        // Not so for NaN: no critical points.
        if from < cut && cut <= hi {
            let after = value(c, cut) > 0.0;
            if after != positive {
                return Some(find(c, from, cut, positive));
            }
            (from, positive) = (cut, after);
        }
    }
    (value(c, hi) == 0.0).then_some(hi)
}

fn value(&[c0, c1, c2, c3]: &[f32; 4], u: f32) -> f32 {
    ((c3 * u + c2) * u + c1) * u + c0
}

/// Critical points, then bisection until no float lies between the ends.
pub fn bisection<F: Functions>(c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    first_root::<F>(c, lo, hi, |c, mut lo, mut hi, falling| {
        for _ in 0..200 {
            let middle = 0.5 * lo + 0.5 * hi;
            if !(lo < middle && middle < hi) {
                break;
            }
            if (value(c, middle) > 0.0) == falling {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        if value(c, lo).abs() < value(c, hi).abs() { lo } else { hi }
    })
}

/// Critical points, then Newton's method from the middle of the bracket; a step that leaves it is replaced by its middle.
pub fn newton<F: Functions>(c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    first_root::<F>(c, lo, hi, |c, mut lo, mut hi, falling| {
        let &[_, c1, c2, c3] = c;
        let mut u = 0.5 * lo + 0.5 * hi;
        for _ in 0..200 {
            let g = value(c, u);
            if g == 0.0 {
                break;
            }
            if (g > 0.0) == falling {
                lo = u;
            } else {
                hi = u;
            }
            let next = u - g / ((3.0 * c3 * u + 2.0 * c2) * u + c1);
            let next = if lo < next && next < hi { next } else { 0.5 * lo + 0.5 * hi };
            let done = (next - u).abs() <= 0.5 * f32::EPSILON * u.abs() || !(lo < next && next < hi);
            if done {
                break;
            }
            u = next;
        }
        u
    })
}
