//! Roots of Bézier ordinates, judged exactly.
//!
//! ```text
//! cargo test -p embedded-lathe-laboratory --test stability many_ordinates -- --ignored      half a million, two minutes
//! ```

use embedded_lathe::Bernstein;
use embedded_lathe::solve::Solver;
use laboratory::bernstein::Ordinates;
use laboratory::{ROUNDOFF, over_every_backend};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

const SEED: u64 = 1912;
/// Cubics a family and solver; with `--ignored` 50 000, by the default.
const CUBICS: usize = 600;
const MANY: usize = 50_000;

fn even(rng: &mut ChaCha8Rng) -> f64 {
    rng.random_range(-1.0..1.0)
}

/// ±10ˣ, x even in a range.
fn decades(rng: &mut ChaCha8Rng, from: f64) -> f64 {
    10_f64.powf(rng.random_range(from..0.0)) * if rng.random() { 1.0 } else { -1.0 }
}

/// The ordinates of `lead·(u − p)·(u − q)·(u − r)`, each by `(1 − u)` and `u` as they are known best: a root
/// is given as the two of them.
fn with_roots(roots: [[f64; 2]; 3], lead: f64) -> [f32; 4] {
    // (u·v₀ − u₀·v)(…)(…), v = 1 − u: products of [−u₀, v₀] in powers of v and u.
    let mut powers = vec![lead];
    for [u, v] in roots {
        let mut next = vec![0.0; powers.len() + 1];
        for (j, c) in powers.iter().enumerate() {
            next[j] -= c * u;
            next[j + 1] += c * v;
        }
        powers = next;
    }
    [powers[0], powers[1] / 3.0, powers[2] / 3.0, powers[3]].map(|b| b as f32)
}

/// A root at u, and one at 1 − u.
fn low(u: f64) -> [f64; 2] {
    [u, 1.0 - u]
}

fn high(v: f64) -> [f64; 2] {
    [1.0 - v, v]
}

type Make = fn(&mut ChaCha8Rng) -> [f32; 4];

const FAMILIES: &[(&str, Make)] = &[
    ("any", |rng| [(); 4].map(|()| even(rng) as f32)),
    ("ordinates over 30 decades", |rng| [(); 4].map(|()| decades(rng, -30.0) as f32)),
    ("tiny at 1", |rng| {
        let tiny = decades(rng, -9.0);
        [even(rng), even(rng), tiny, tiny * (1.0 + decades(rng, -7.0))].map(|b| b as f32)
    }),
    ("tiny at 0", |rng| {
        let tiny = decades(rng, -9.0);
        [tiny * (1.0 + decades(rng, -7.0)), tiny, even(rng), even(rng)].map(|b| b as f32)
    }),
    ("roots near 1", |rng| {
        let roots = [(); 3].map(|()| high(decades(rng, -9.0)));
        with_roots(roots, even(rng))
    }),
    ("roots near both ends", |rng| {
        let roots = [low(decades(rng, -9.0)), high(decades(rng, -9.0)), low(even(rng))];
        with_roots(roots, even(rng))
    }),
    ("roots at the ends", |rng| {
        let root = if rng.random() { low(0.0) } else { high(0.0) };
        with_roots([root, low(even(rng)), if rng.random() { root } else { high(even(rng)) }], even(rng))
    }),
    ("nearly double", |rng| {
        let root = rng.random_range(0.0..1.0);
        with_roots([low(root), low(root + decades(rng, -8.0)), low(3.0 * even(rng))], even(rng))
    }),
    ("nearly double near 1", |rng| {
        let root = decades(rng, -6.0);
        with_roots([high(root), high(root * (1.0 + decades(rng, -8.0))), low(3.0 * even(rng))], even(rng))
    }),
    ("nearly triple", |rng| {
        let root = rng.random_range(0.0..1.0);
        with_roots([low(root), low(root + decades(rng, -8.0)), low(root + decades(rng, -8.0))], even(rng))
    }),
    ("large and small", |rng| {
        let power = rng.random_range(-120.0_f64..126.0).exp2();
        [(); 4].map(|()| (power * even(rng)) as f32)
    }),
];

fn are_sound<S: Solver>(count: usize) {
    let [promise, rounding] = [Bernstein::BACKWARD_ERROR, Bernstein::ROUNDING].map(f64::from);
    let (mut worst, mut found) = (0_f64, [0; 4]);
    for (name, make) in FAMILIES {
        let mut rng = ChaCha8Rng::seed_from_u64(SEED);
        for index in 0..count {
            let curve = Bernstein::new(make(&mut rng));
            let (first, roots) = (curve.first_root_by::<S>(), curve.roots_by::<S>());
            let said = || format!("{name}, {index}: {curve:?}: {roots:?}");
            assert_eq!(first, roots.first().copied(), "{}", said());
            assert!(roots.is_sorted() && roots.iter().all(|u| (0.0..=1.0).contains(u)), "{}", said());
            let verdict = Ordinates::new(curve.b).judge(&roots, true, rounding);
            let units = verdict.residual.max(verdict.skipped);
            assert!(units <= promise, "{}: {verdict:?}", said());
            worst = worst.max(units);
            found[roots.len()] += 1;
        }
    }
    assert!(4.0 * worst >= promise, "{worst}");
    assert!(found.iter().all(|&n| 50 * n > count), "{found:?}");
}

fn ordinates_are_solved<S: Solver>() {
    are_sound::<S>(CUBICS);
}

over_every_backend!(ordinates_are_solved);

/// Half a million, by the default.
#[test]
#[ignore = "takes minutes"]
fn many_ordinates_are_solved() {
    are_sound::<embedded_lathe::solve::DefaultSolver>(MANY);
}

/// Whatever the bits, an answer in [0, 1], and at most three.
#[test]
fn ordinates_of_any_bits() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    for _ in 0..200_000 {
        let curve = Bernstein::new([(); 4].map(|()| f32::from_bits(rng.random())));
        let roots = curve.roots();
        assert!(roots.is_sorted() && roots.iter().all(|u| (0.0..=1.0).contains(u)), "{curve:?}: {roots:?}");
        assert_eq!(curve.first_root(), roots.first().copied(), "{curve:?}");
    }
}

/// The value, too, is as exact as its doc says.
#[test]
fn values_are_as_exact_as_they_say() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let mut worst = 0_f64;
    for _ in 0..20_000 {
        let curve = Bernstein::new([(); 4].map(|()| even(&mut rng) as f32));
        let u = rng.random_range(0.0..=1.0_f32);
        worst = worst.max(Ordinates::new(curve.b).error(u, curve.at(u)));
    }
    assert!((2.5..=10.0).contains(&worst), "{worst}");
}

/// A well-conditioned root near 1 that is lost when the ordinates are made coefficients.
#[test]
fn a_root_that_conversion_loses() {
    let curve = Bernstein::new([117.11707, 39.039914, -2.3525217e-6, -2.3526636e-6]);
    let root = curve.first_root().expect("the signs differ");
    assert!((f64::from(root) - 0.999_858_269).abs() <= 2.0 * ROUNDOFF, "{root}");
    assert_eq!(curve.roots().len(), 1);
}
