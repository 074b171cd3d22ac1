//! Cubics on [0, 1] by their Bernstein ordinates.

pub type Cubic = [f64; 4];

/// Halvings after which a cluster of roots is taken for one place.
const DEEPEST: u32 = 45;

/// Exact at both ends, which is what lets neighbours share an end.
pub fn lerp(a: f64, b: f64, w: f64) -> f64 {
    a * (1.0 - w) + b * w
}

pub fn value([a, b, c, d]: Cubic, w: f64) -> f64 {
    let (ab, bc, cd) = (lerp(a, b, w), lerp(b, c, w), lerp(c, d, w));
    lerp(lerp(ab, bc, w), lerp(bc, cd, w), w)
}

/// The derivative: `3·Σ (b[j+1] − b[j])·B²(w)`.
pub fn slope([a, b, c, d]: Cubic, w: f64) -> f64 {
    let (p, q, r) = (b - a, c - b, d - c);
    3.0 * lerp(lerp(p, q, w), lerp(q, r, w), w)
}

/// Largest |derivative| on [lo, hi]: at an end, or where the second derivative vanishes.
pub fn steepest(b: Cubic, lo: f64, hi: f64) -> f64 {
    let bend = [b[2] - 2.0 * b[1] + b[0], b[3] - 2.0 * b[2] + b[1]];
    let still = (bend[0] / (bend[0] - bend[1])).clamp(lo, hi);
    let still = if still.is_nan() { lo } else { still };
    [lo, hi, still].into_iter().map(|w| slope(b, w).abs()).fold(0.0, f64::max)
}

/// The cubic with these values at 0, 1/3, 2/3 and 1.
pub fn through(v: Cubic) -> Cubic {
    [
        v[0],
        (-5.0 * v[0] + 18.0 * v[1] - 9.0 * v[2] + 2.0 * v[3]) / 6.0,
        (2.0 * v[0] - 9.0 * v[1] + 18.0 * v[2] - 5.0 * v[3]) / 6.0,
        v[3],
    ]
}

pub fn halves([a, b, c, d]: Cubic) -> [Cubic; 2] {
    let (ab, bc, cd) = ((a + b) / 2.0, (b + c) / 2.0, (c + d) / 2.0);
    let (abc, bcd) = ((ab + bc) / 2.0, (bc + cd) / 2.0);
    let mid = (abc + bcd) / 2.0;
    [[a, ab, abc, mid], [mid, bcd, cd, d]]
}

/// Sign changes of the cubic on [0, 1], ascending, each with whether it rises. Zero counts as below, everywhere alike,
/// so a double root is none or two, and a root at an end shared by two cubics is found by one of them.
pub fn sign_changes(b: Cubic) -> Vec<(f64, bool)> {
    let mut found = Vec::new();
    isolate(b, 0.0, 1.0, DEEPEST, &mut found);
    found
}

fn isolate(b: Cubic, lo: f64, hi: f64, depth: u32, found: &mut Vec<(f64, bool)>) {
    let changes = b.windows(2).filter(|p| (p[0] > 0.0) != (p[1] > 0.0)).count();
    let rises = b[3] > 0.0;
    let flips = rises != (b[0] > 0.0);
    match changes {
        0 => {}
        1 => found.push((lerp(lo, hi, bisect(b)), rises)),
        _ if depth == 0 => found.extend(flips.then(|| (lerp(lo, hi, 0.5), rises))),
        _ => {
            let (mid, [left, right]) = (lerp(lo, hi, 0.5), halves(b));
            isolate(left, lo, mid, depth - 1, found);
            isolate(right, mid, hi, depth - 1, found);
        }
    }
}

fn bisect(b: Cubic) -> f64 {
    let (mut lo, mut hi) = (0.0, 1.0);
    for _ in 0..60 {
        let mid = (lo + hi) / 2.0;
        if (value(b, mid) > 0.0) == (b[0] > 0.0) {
            lo = mid;
        } else {
            hi = mid;
        }
    }
    (lo + hi) / 2.0
}
