//! The programs behind fitted constants of the crate: each constant that stands in the source is computed
//! here, or shown to be the best.

/// The source with `_` taken out of its numbers.
fn source(file: &str) -> String {
    let path = format!("{}/../src/{file}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("the crate's source").replace('_', "")
}

/// Φ(b), the first positive root of `y²·(1 − b·y) = 1`.
fn phi(b: f64) -> f64 {
    let mut y = 1.0;
    for _ in 0..60 {
        y -= (y * y * (1.0 - b * y) - 1.0) / (y * (2.0 - 3.0 * b * y));
    }
    y
}

/// The polynomial of degree 4 with the least largest relative error on [−3/4, √6/9], by Remez's exchange: the
/// error is made equal, with alternating sign, at six places, and those are moved to where it is largest,
/// until they stay.
#[test]
fn the_polynomial_of_split() {
    const TERMS: usize = 5;
    const GRID: usize = 20_000;
    let (lo, hi) = (-0.75, 6_f64.sqrt() / 9.0);
    let grid: Vec<f64> = (0..=GRID).map(|i| lo + (hi - lo) * i as f64 / GRID as f64).collect();
    let chebyshev = |i: usize| (std::f64::consts::PI * i as f64 / TERMS as f64).cos();
    let mut places: Vec<f64> =
        (0..=TERMS).map(|i| 0.5 * (lo + hi) - 0.5 * (hi - lo) * chebyshev(i)).collect();
    let mut c = Vec::new();
    for _ in 0..20 {
        // Σ cⱼ·bʲ/Φ(b) ± error = 1.
        let rows = places.iter().enumerate().map(|(i, &b)| {
            let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
            let terms = (0..TERMS).map(|j| b.powi(j as i32) / phi(b));
            terms.chain([sign, 1.0]).collect()
        });
        c = solved(rows.collect());
        let error = |b: f64| (0..TERMS).map(|j| c[j] * b.powi(j as i32)).sum::<f64>() / phi(b) - 1.0;
        // The largest error of each stretch of one sign.
        let mut peaks: Vec<f64> = Vec::new();
        for &b in &grid {
            match peaks.last_mut() {
                Some(last) if (error(*last) > 0.0) == (error(b) > 0.0) => {
                    if error(b).abs() > error(*last).abs() {
                        *last = b;
                    }
                }
                _ => peaks.push(b),
            }
        }
        assert_eq!(peaks.len(), TERMS + 1);
        places = peaks;
    }
    let error = c[TERMS].abs();
    assert!((2.6e-3..=2.7e-3).contains(&error), "{error}");
    let source = source("solve/library/split.rs");
    for c in &c[..TERMS] {
        assert!(source.contains(&format!("{}", *c as f32)), "{c} is not in split.rs");
    }
}

/// Gauss's elimination of a matrix with its right side as last column.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs())).unwrap();
        rows.swap(i, pivot);
        for k in 0..n {
            if k != i {
                let factor = rows[k][i] / rows[i][i];
                let pivot = rows[i].clone();
                rows[k].iter_mut().zip(&pivot).for_each(|(a, b)| *a -= factor * b);
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

/// The first step of the inverse root splits the error that it leaves evenly, but for rounding.
#[test]
fn the_first_step_of_the_inverse_root() {
    let seed = |x: f32| f64::from(f32::from_bits(0x5f37_6800_u32.wrapping_sub(x.to_bits() >> 1)));
    let off = |y: f64, x: f32| y * f64::from(x).sqrt() - 1.0;
    let octaves = || (1_f32.to_bits()..4_f32.to_bits()).step_by(17).map(f32::from_bits);
    let left = octaves().fold([0.0, 0.0], |[least, most], x| {
        let y = seed(x);
        let off = off(y * (1.500_879_8 - 0.5 * f64::from(x) * y * y), x);
        [f64::min(least, off), f64::max(most, off)]
    });
    // To a unit in the last place of the constant.
    assert!((left[0] + left[1]).abs() <= f64::from(f32::EPSILON), "{left:?}");
    assert!((8.7e-4..=8.8e-4).contains(&left[1]), "{left:?}");
    assert!(source("math/rsqrt.rs").contains("1.5008798"));
}
