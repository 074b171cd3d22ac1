//! Lists of roots: how many a cubic may have, in ascending order, within the interval, and the first of them
//! as `first_root` finds it.
//!
//! ```text
//! cargo test -p embedded-lathe-laboratory --test roots                             a share of the double roots
//! cargo test -p embedded-lathe-laboratory --test roots -- --ignored      four million of them, by every solver over every backend
//! ```

use embedded_lathe::solve::{Cardano, DefaultSolver, Solver, Split};
use embedded_lathe::{Bernstein, Cubic};
use laboratory::{ROUNDOFF, over_every_backend};
use rand::rngs::ChaCha8Rng;
use rand::{Rng, RngExt, SeedableRng};

/// As many roots as the degree allows at most, ascending, in [lo, hi], the first of them `first_root_by`'s.
fn check<S: Solver>(c: [f32; 4], lo: f32, hi: f32) -> usize {
    let g = Cubic::new(c);
    let roots = g.roots_by::<S>(lo, hi);
    let said = || format!("{:08x?} in [{lo:e}, {hi:e}]: {roots:?}", c.map(f32::to_bits));
    // Of the zero polynomial's roots the first is returned.
    let degree = (1..4).rev().find(|&j| c[j] != 0.0).unwrap_or(usize::from(c[0] == 0.0));
    assert!(roots.len() <= degree, "{}", said());
    assert!(roots.is_sorted(), "{}", said());
    assert!(roots.iter().all(|root| (lo..=hi).contains(root)), "{}", said());
    let first = g.first_root_by::<S>(lo, hi);
    assert_eq!(roots.first().copied(), first, "{}", said());
    roots.len()
}

/// What once came out as three roots of a parabola, and as a root twice.
fn parabolas_have_two<S: Solver>() {
    assert!(check::<S>([1.0, -2.0, 1.0, 0.0], 0.0, 1.0) <= 2);

    // Its roots are 0.99999396 and 1, 6·10⁻⁶ apart. Four units of each coefficient are 16·2⁻²⁴ of the leading
    // one at u = 1, and so move a double root by up to √(16·2⁻²⁴): both may be found at their middle, or
    // apart.
    let c = [6.6305213, -13.261083, 6.6305614, 0.0];
    assert_eq!(check::<S>(c, 0.0, 1.0), 2);
    let off = |root: &f32| (f64::from(*root) - 0.999_997).abs();
    let roots = Cubic::new(c).roots_by::<S>(0.0, 1.0);
    assert!(roots.iter().all(|root| off(root) <= (16.0 * ROUNDOFF).sqrt()), "{roots:?}");
}

/// A parabola whose two roots, or their lack, are within rounding of each other and near the end of the
/// interval.
fn double_root_near_the_end(rng: &mut ChaCha8Rng) -> [f32; 4] {
    let offset = 10_f64.powf(rng.random_range(-8.0..-2.0));
    let root = 1.0 - if rng.random() { offset } else { -offset };
    let gap = 10_f64.powf(rng.random_range(-9.0..-3.0));
    let lead = rng.random_range(-10.0..10.0);
    let square = root * root - gap * gap * rng.random_range(-1.0..1.0_f64);
    [lead * square, -2.0 * lead * root, lead, 0.0].map(|c| c as f32)
}

fn double_roots<S: Solver>(count: usize) {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut found = [0; 4];
    for _ in 0..count {
        found[check::<S>(double_root_near_the_end(&mut rng), 0.0, 1.0)] += 1;
    }
    assert!(found[..3].iter().all(|&n| 20 * n > count), "{found:?}");
}

fn of_any_bits<S: Solver>() {
    let mut rng = ChaCha8Rng::seed_from_u64(754);
    let any = |rng: &mut ChaCha8Rng| match rng.random_range(0..12) {
        0 => 0.0,
        1 => f32::INFINITY,
        2 => f32::NEG_INFINITY,
        3 => f32::MAX,
        4 => f32::MIN,
        // The ends of the intervals that are solved in one unit.
        5 => (1_u64 << 30) as f32,
        6 => -((1_u64 << 30) as f32).powi(3),
        7 => f32::from_bits(rng.next_u32() & 0x8000_00ff),
        8 => rng.random_range(-1.0..1.0),
        _ => f32::from_bits(rng.next_u32()),
    };
    let mut with_roots = 0;
    for _ in 0..30_000 {
        let c = [(); 4].map(|()| any(&mut rng));
        let (lo, hi) = (any(&mut rng), any(&mut rng));
        with_roots +=
            [[lo, hi], [hi, lo], [lo, lo]].map(|[lo, hi]| check::<S>(c, lo, hi).min(1)).iter().sum::<usize>();
    }
    assert!(with_roots > 3_000, "{with_roots}");
}

/// Where rounding is most of a value: a cubic with a root of any multiplicity, over an interval about that
/// root.
fn about_a_root<S: Solver>() {
    let mut rng = ChaCha8Rng::seed_from_u64(1591);
    for _ in 0..100_000 {
        let root = rng.random_range(-2.0..2.0_f64);
        let [p, q] =
            [(); 2].map(|()| root + 10_f64.powf(rng.random_range(-9.0..0.5)) * rng.random_range(-1.0..1.0));
        let lead = if rng.random() { 1.0 } else { rng.random_range(-1e-6..1e-6) };
        let c = match rng.random_range(0..2) {
            0 => {
                [-root * p * q, root * p + root * q + p * q, -(root + p + q), 1.0].map(|c| (lead * c) as f32)
            }
            _ => [root * p, -(root + p), 1.0, 1e-3 * lead].map(|c| c as f32),
        };
        let [lo, hi] =
            [(); 2].map(|()| root + 10_f64.powf(rng.random_range(-8.0..0.5)) * rng.random_range(-1.0..1.0));
        check::<S>(c, lo.min(hi) as f32, lo.max(hi) as f32);
        check::<S>(c, root as f32, lo.max(hi) as f32);
    }
}

/// Every point is a root of the zero cubic: of an interval the first one is returned, alone.
fn zero_has_one<S: Solver>() {
    let ends = [f32::NEG_INFINITY, f32::MIN, -1e30, -1.0, 0.0, 1e-40, 1.0, 1e30, f32::MAX, f32::INFINITY];
    for lo in ends {
        for hi in ends {
            let first = (lo <= hi && lo <= f32::MAX && hi >= f32::MIN).then_some(lo.max(f32::MIN));
            for c in [[0.0; 4], [-0.0, 0.0, -0.0, 0.0]] {
                let g = Cubic::new(c);
                assert_eq!(g.first_root_by::<S>(lo, hi), first, "[{lo}, {hi}]");
                assert_eq!(g.roots_by::<S>(lo, hi), first.as_slice(), "[{lo}, {hi}]");
            }
        }
    }
    for b in [[0.0; 4], [-0.0, 0.0, 0.0, -0.0]] {
        let g = Bernstein::new(b);
        assert_eq!(g.first_root_by::<S>(), Some(0.0));
        assert_eq!(g.roots_by::<S>(), [0.0]);
    }
    assert_eq!(Bernstein::new([0.0, 1.0, 1.0, 0.0]).roots_by::<S>(), [0.0, 1.0]);
}

fn lists<S: Solver>() {
    zero_has_one::<S>();
    parabolas_have_two::<S>();
    double_roots::<S>(20_000);
    of_any_bits::<S>();
    about_a_root::<S>();
}

over_every_backend!(lists);

#[test]
#[ignore = "takes a minute"]
fn four_million_double_roots() {
    const COUNT: usize = 4_000_000;
    use embedded_lathe::math::{Libm, Micromath, Native, Std};
    double_roots::<Split<Native>>(COUNT);
    double_roots::<Split<Std>>(COUNT);
    double_roots::<Split<Libm>>(COUNT);
    double_roots::<Split<Micromath>>(COUNT);
    double_roots::<Cardano<Native>>(COUNT);
    double_roots::<Cardano<Std>>(COUNT);
    double_roots::<Cardano<Libm>>(COUNT);
    double_roots::<Cardano<Micromath>>(COUNT);
}

/// An interval that ends at the smallest number, where the cubic vanishes.
#[test]
fn a_root_at_the_end_of_all_numbers() {
    let c = [0x3f00_b015, 0xbff2_a02d, 0xff7f_ffff, 0xbf80_0000].map(f32::from_bits);
    assert_eq!(check::<DefaultSolver>(c, f32::NEG_INFINITY, f32::MIN), 1);
    assert_eq!(Cubic::new(c).first_root(f32::NEG_INFINITY, f32::MIN), Some(f32::MIN));
}
