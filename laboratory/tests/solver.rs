//! The cubic solvers over every backend, where cubics go wrong.
//!
//! An answer's *backward error* is the smallest relative change of the coefficients, in units of 2⁻²⁴, that
//! makes it right: for a root u it is `|g(u)| / Σ |cⱼ·uʲ|`; for a claim that nothing comes before, the largest
//! of the same before u where g has the wrong sign. Evaluated in f64, whose own rounding is 2⁻²⁹ of the unit.

use embedded_lathe::Cubic;
use embedded_lathe::math::{Libm, Math, Micromath, Native, Std};
use embedded_lathe::solve::{BACKWARD_ERROR, Solver};
use laboratory::families::{FAMILIES, Question};
use laboratory::{ROUNDOFF, over_every_backend};
use rand::rngs::ChaCha8Rng;
use rand::{Rng, RngExt, SeedableRng};
use std::sync::LazyLock;

const CUBICS: usize = 20_000;

/// A question of the laboratory's, and the backward error of an answer to it.
#[derive(Clone, Copy, Debug)]
struct Problem(Question);

impl Problem {
    /// g(u) and Σ |cⱼ·uʲ|.
    fn at(&self, u: f64) -> (f64, f64) {
        let terms: [f64; 4] = std::array::from_fn(|j| f64::from(self.0.c[j]) * u.powi(j as i32));
        (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
    }

    fn depth(&self, u: f64) -> f64 {
        let (value, size) = self.at(u);
        if size > 0.0 { value.abs() / size / ROUNDOFF } else { 0.0 }
    }

    /// The backward error of the answer that the first root is here, or nowhere: before it g may have one
    /// sign alone, above zero or below, whichever is less to change.
    fn error(&self, answer: Option<f32>) -> f64 {
        let [lo, hi] = [self.0.lo, self.0.hi].map(f64::from);
        let [_, c1, c2, c3] = self.0.c.map(f64::from);
        let sum = -(c2 + c2.signum() * (c2 * c2 - 3.0 * c3 * c1).sqrt());
        let end = answer.map_or(f64::INFINITY, f64::from);
        let extremes = [lo, sum / (3.0 * c3), c1 / sum, hi];
        let before = extremes.into_iter().filter(|&u| lo <= u && u <= hi && u < end);
        let (above, below) = before.fold((0_f64, 0_f64), |(above, below), u| {
            if self.at(u).0 > 0.0 {
                (above.max(self.depth(u)), below)
            } else {
                (above, below.max(self.depth(u)))
            }
        });
        above.min(below).max(answer.map_or(0.0, |u| self.depth(u.into())))
    }
}

fn even(rng: &mut ChaCha8Rng) -> f64 {
    rng.random_range(-1.0..1.0)
}

/// ±10ˣ, x even in a range.
fn decades(rng: &mut ChaCha8Rng, from: f64, to: f64) -> f64 {
    10_f64.powf(rng.random_range(from..to)) * if rng.random() { 1.0 } else { -1.0 }
}

type Make = fn(&mut ChaCha8Rng) -> Question;

/// What [`FAMILIES`] has not, or not by itself.
const MORE: [(&str, Make); 3] = [
    ("straight lines", |r| Question { c: [even(r) as f32, even(r) as f32, 0.0, 0.0], lo: 0.0, hi: 1.0 }),
    ("a root at zero, where the interval begins", |r| {
        Question::with_roots([0.0, 2.0 * even(r), 2.0 * even(r)], even(r), 0.0, 1.0)
    }),
    ("all of the line", |r| Question { c: [(); 4].map(|()| even(r) as f32), lo: f32::MIN, hi: f32::MAX }),
];

/// The cubics of every family, made once for all solvers.
static PROBLEMS: LazyLock<Vec<(&str, Vec<Problem>)>> = LazyLock::new(|| {
    let listed = FAMILIES.iter().map(|family| {
        (family.name, (0..CUBICS as u64).map(|index| Problem(family.question(1545, index))).collect())
    });
    let more = MORE.iter().map(|(name, make)| {
        let mut rng = ChaCha8Rng::seed_from_u64(1545);
        (*name, (0..CUBICS).map(|_| Problem(make(&mut rng))).collect())
    });
    listed.chain(more).collect()
});

fn is_sound<S: Solver>() {
    let mut worst = 0_f64;
    for (name, problems) in PROBLEMS.iter() {
        let mut found = 0;
        for (i, problem) in problems.iter().enumerate() {
            let Question { c, lo, hi } = problem.0;
            let g = Cubic::new(c);
            let answer = g.first_root_by::<S>(lo, hi);
            let error = problem.error(answer);
            let said = format!("{name}, number {i}: {problem:?} → {answer:?}, off by {error} units");
            assert!(answer.is_none_or(|u| (lo..=hi).contains(&u)), "{said}");
            assert!(error <= f64::from(BACKWARD_ERROR), "{said}");

            let roots = g.roots_by::<S>(lo, hi);
            assert_eq!(roots.first().copied(), answer, "{said}");
            assert!(roots.is_sorted(), "{said}: {roots:?}");
            assert!(
                roots.iter().all(|&u| problem.depth(u.into()) <= f64::from(BACKWARD_ERROR)),
                "{said}: {roots:?}"
            );
            worst = worst.max(error);
            found += usize::from(answer.is_some());
        }
        assert!(found > CUBICS / 10, "{name}: only {found} roots");
    }
    assert!(worst > f64::from(BACKWARD_ERROR) / 4.0, "the bound is slack: {worst}");
}

over_every_backend!(is_sound);

/// Every number of roots is found: three where there are three.
#[test]
fn all_roots_are_found() {
    let mut rng = ChaCha8Rng::seed_from_u64(1591);
    for i in 0..CUBICS {
        let mut roots = [even(&mut rng), even(&mut rng), even(&mut rng)];
        roots.sort_by(f64::total_cmp);
        // Far enough apart that rounding the coefficients, 2⁻²⁴ of 8 at most, cannot make two meet: that
        // needs a gap of √(8·2⁻²⁴) = 7·10⁻⁴.
        if roots[1] - roots[0] < 1e-2 || roots[2] - roots[1] < 1e-2 {
            continue;
        }
        let problem = Question::with_roots(roots, 1.0, -2.0, 2.0);
        let found = Cubic::new(problem.c).roots(problem.lo, problem.hi);
        assert_eq!(found.len(), 3, "number {i}: {problem:?} → {found:?}, should be {roots:?}");
        for (found, root) in found.iter().zip(roots) {
            // Backward error over the slope, which is at least gap² = 10⁻⁴.
            assert!((f64::from(*found) - root).abs() < 4.0 * 8.0 * ROUNDOFF / 1e-4, "{found} is not {root}");
        }
    }
}

#[test]
fn what_is_no_problem_has_no_root() {
    let line = Cubic::new([-0.5, 1.0, 0.0, 0.0]);
    assert_eq!(line.first_root(0.0, 1.0), Some(0.5));
    assert_eq!(line.first_root(0.0, 0.25), None);
    assert_eq!(line.first_root(1.0, 0.0), None, "no interval");
    assert_eq!(line.first_root(f32::NAN, 1.0), None);
    assert_eq!(line.first_root(0.0, f32::NAN), None);
    assert_eq!(line.first_root(f32::NEG_INFINITY, f32::INFINITY), Some(0.5));
    assert_eq!(line.first_root(0.5, 0.5), Some(0.5), "an interval of one point");
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for j in 0..4 {
            let mut c = [1.0, -2.0, 0.5, 0.1];
            c[j] = bad;
            assert_eq!(Cubic::new(c).first_root(0.0, 1.0), None);
            assert!(Cubic::new(c).roots(0.0, 1.0).is_empty());
        }
    }
    assert_eq!(Cubic::new([0.0; 4]).first_root(0.0, 1.0), Some(0.0), "zero everywhere");
    assert_eq!(Cubic::new([1.0, 0.0, 0.0, 0.0]).first_root(0.0, 1.0), None, "zero nowhere");
    let tiny = f32::from_bits(3);
    assert_eq!(Cubic::new([-tiny, 2.0 * tiny, 0.0, 0.0]).first_root(0.0, 1.0), Some(0.5));
    assert_eq!(Cubic::new([-f32::MAX, f32::MAX, 0.0, 0.0]).first_root(0.0, 2.0), Some(1.0));
}

/// Random bits: no panic, nothing outside the interval, nothing NaN.
#[test]
fn any_bits_will_do() {
    let mut rng = ChaCha8Rng::seed_from_u64(754);
    for _ in 0..200_000 {
        let [c0, c1, c2, c3, lo, hi] = [(); 6].map(|()| f32::from_bits(rng.next_u32()));
        let roots = Cubic::new([c0, c1, c2, c3]).roots(lo, hi);
        assert!(roots.iter().all(|&u| lo <= u && u <= hi), "{c0} {c1} {c2} {c3} in [{lo}, {hi}]: {roots:?}");
    }
}

/// The promises of [`Math`], which name no more than these bounds.
fn keeps_its_promises<M: Math>(exact_root: bool) {
    let mut rng = ChaCha8Rng::seed_from_u64(1685);
    for _ in 0..200_000 {
        let x = f32::from_bits(rng.next_u32() & 0x7fff_ffff);
        let root = M::sqrt(x);
        if exact_root || !x.is_finite() || x == 0.0 {
            assert!(root == x.sqrt() || x.is_nan() && root.is_nan(), "√{x:e} = {root:e}");
        } else {
            let truth = f64::from(x).sqrt();
            assert!((f64::from(root) - truth).abs() <= 2.0 * ROUNDOFF * truth, "√{x:e} = {root:e}");
        }
        let x = decades(&mut rng, -37.9, 38.5) as f32;
        assert!((M::cbrt(x) / x.cbrt() - 1.0).abs() < 0.08, "∛{x:e} = {:e}", M::cbrt(x));
        let x = even(&mut rng) as f32;
        assert!((M::acos(x) - x.acos()).abs() < 0.03, "acos {x} = {}", M::acos(x));
        let x = x * core::f32::consts::PI;
        assert!((M::cos(x) - x.cos()).abs() < 0.002, "cos {x} = {}", M::cos(x));
    }
    for x in [0.0, 1e-45, 1e-40, f32::MIN_POSITIVE] {
        assert!(M::cbrt(x).abs() < 1e-12 && M::cbrt(-x).abs() < 1e-12, "∛{x:e} = {:e}", M::cbrt(x));
    }
    assert!(M::sqrt(-1.0).is_nan());
    assert!((M::acos(1.0)).abs() < 0.03 && (M::acos(-1.0) - core::f32::consts::PI).abs() < 0.03);
}

#[test]
fn the_backends_keep_their_promises() {
    keeps_its_promises::<Native>(true);
    keeps_its_promises::<Std>(true);
    keeps_its_promises::<Libm>(true);
    keeps_its_promises::<Micromath>(false);
}
