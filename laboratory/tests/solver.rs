//! The cubic solvers over every backend, where cubics go wrong.
//!
//! An answer's *backward error* is the smallest relative change of the coefficients, in units of 2⁻²⁴, that
//! makes it right: for a root u it is `|g(u)| / Σ |cⱼ·uʲ|`; for a claim that nothing comes before, the same
//! at the deepest point where g has the other sign. Evaluated in f64, whose own rounding is 2⁻²⁹ of the unit.

use embedded_lathe::Cubic;
use embedded_lathe::math::{Libm, Math, Micromath, Native, Std};
use embedded_lathe::solve::{BACKWARD_ERROR, Solver};
use laboratory::over_every_backend;
use rand::rngs::ChaCha8Rng;
use rand::{Rng, RngExt, SeedableRng};

const CUBICS: usize = 20_000;
const UNIT: f64 = 1.0 / 16_777_216.0;

/// A cubic in f32 and an interval.
#[derive(Clone, Copy, Debug)]
struct Problem {
    c: [f32; 4],
    lo: f32,
    hi: f32,
}

impl Problem {
    /// `lead·(u − r₀)(u − r₁)(u − r₂)`, rounded.
    fn with_roots([p, q, r]: [f64; 3], lead: f64, lo: f32, hi: f32) -> Self {
        let c = [-p * q * r, p * q + q * r + r * p, -(p + q + r), 1.0];
        Self { c: c.map(|c| (lead * c) as f32), lo, hi }
    }

    /// g(u) and Σ |cⱼ·uʲ|.
    fn at(&self, u: f64) -> (f64, f64) {
        let terms: [f64; 4] = std::array::from_fn(|j| f64::from(self.c[j]) * u.powi(j as i32));
        (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
    }

    fn depth(&self, u: f64) -> f64 {
        let (value, size) = self.at(u);
        if size > 0.0 { value.abs() / size / UNIT } else { 0.0 }
    }

    /// The deepest that g goes to the other side of zero before `end`, which is in [lo, hi].
    fn skipped(&self, end: f64) -> f64 {
        let [_, c1, c2, c3] = self.c.map(f64::from);
        let sum = -(c2 + c2.signum() * (c2 * c2 - 3.0 * c3 * c1).sqrt());
        let start = self.at(self.lo.into()).0;
        [sum / (3.0 * c3), c1 / sum, end]
            .into_iter()
            .filter(|&u| f64::from(self.lo) < u && u <= end && self.at(u).0 * start < 0.0)
            .map(|u| if u == end { 0.0 } else { self.depth(u) })
            .fold(0.0, f64::max)
    }

    /// The backward error of the answer that the first root is here, or nowhere.
    fn error(&self, answer: Option<f32>) -> f64 {
        let hi = f64::from(self.hi);
        match answer {
            Some(u) => self.depth(u.into()).max(self.skipped(u.into())),
            None if self.at(hi).0 * self.at(self.lo.into()).0 < 0.0 => self.depth(hi),
            None => self.skipped(hi),
        }
    }
}

struct Family {
    name: &'static str,
    make: fn(&mut ChaCha8Rng) -> Problem,
}

fn even(rng: &mut ChaCha8Rng) -> f64 {
    rng.random_range(-1.0..1.0)
}

/// ±10ˣ, x even in a range.
fn decades(rng: &mut ChaCha8Rng, from: f64, to: f64) -> f64 {
    10_f64.powf(rng.random_range(from..to)) * if rng.random() { 1.0 } else { -1.0 }
}

fn power_form(rng: &mut ChaCha8Rng, scales: [f64; 4]) -> Problem {
    Problem { c: scales.map(|scale| (scale * even(rng)) as f32), lo: 0.0, hi: 1.0 }
}

const FAMILIES: &[Family] = &[
    Family {
        name: "separate roots",
        make: |r| Problem::with_roots([even(r), even(r), even(r)], 1.0, -1.0, 1.0),
    },
    Family {
        name: "double roots but for 1e-1 to 1e-7",
        make: |r| {
            let root = r.random_range(0.0..1.0);
            let gap = decades(r, -7.0, -1.0);
            Problem::with_roots([root, root + gap, 3.0 * even(r)], even(r), 0.0, 1.0)
        },
    },
    Family {
        name: "triple roots but for 1e-1 to 1e-7",
        make: |r| {
            let root = r.random_range(0.0..1.0);
            let gap = decades(r, -7.0, -1.0);
            Problem::with_roots([root, root + gap, root + gap * even(r)], 1.0, 0.0, 1.0)
        },
    },
    Family {
        name: "leading coefficient 1e-1 to 1e-12",
        make: |r| {
            let lead = decades(r, -12.0, -1.0);
            power_form(r, [1.0, 1.0, 1.0, lead])
        },
    },
    Family { name: "quadratics", make: |r| power_form(r, [1.0, 1.0, 1.0, 0.0]) },
    Family {
        name: "both leading coefficients 1e-1 to 1e-12",
        make: |r| {
            let (second, lead) = (decades(r, -12.0, -1.0), decades(r, -12.0, -1.0));
            power_form(r, [1.0, 1.0, second, lead])
        },
    },
    Family { name: "straight lines", make: |r| power_form(r, [1.0, 1.0, 0.0, 0.0]) },
    Family {
        name: "roots from 1e-3 to 1e3",
        make: |r| {
            let roots = [decades(r, -3.0, 3.0), decades(r, -3.0, 3.0), decades(r, -3.0, 3.0)];
            Problem::with_roots(roots, 1.0, -1100.0, 1100.0)
        },
    },
    Family {
        name: "scales from 2^-110 to 2^110",
        make: |r| {
            let scale = r.random_range(-110.0_f64..110.0).exp2();
            Problem::with_roots([even(r), even(r), even(r)], scale, -1.0, 1.0)
        },
    },
    Family {
        name: "a root on the lower end",
        make: |r| Problem::with_roots([0.0, 2.0 * even(r), 2.0 * even(r)], even(r), 0.0, 1.0),
    },
    Family {
        name: "a root on the upper end",
        make: |r| Problem::with_roots([1.0, 2.0 * even(r), 2.0 * even(r)], even(r), 0.0, 1.0),
    },
    Family {
        name: "coefficients over 30 decades",
        make: |r| Problem { c: [(); 4].map(|()| decades(r, -20.0, 10.0) as f32), lo: -1e6, hi: 1e6 },
    },
    Family {
        name: "all of the line",
        make: |r| Problem { lo: f32::MIN, hi: f32::MAX, ..power_form(r, [1.0; 4]) },
    },
    Family { name: "no square", make: |r| Problem { lo: -1.0, ..power_form(r, [1.0, 1.0, 0.0, 1.0]) } },
    Family {
        name: "silhouettes",
        make: |r| {
            // A ray's g = c − a·(u − v)², v where it is nearest and c a graze, and a little of u³.
            let (v, c) = (r.random_range(0.1..0.9), decades(r, -9.0, -1.0));
            let bend = 0.1 * even(r);
            Problem { c: [c - v * v, 2.0 * v, -1.0, bend].map(|c| c as f32), lo: 0.0, hi: 1.0 }
        },
    },
];

fn is_sound<S: Solver>() {
    let mut worst = 0_f64;
    for family in FAMILIES {
        let mut rng = ChaCha8Rng::seed_from_u64(1545);
        let mut found = 0;
        for i in 0..CUBICS {
            let problem = (family.make)(&mut rng);
            let g = Cubic::new(problem.c);
            let answer = g.first_root_by::<S>(problem.lo, problem.hi);
            let error = problem.error(answer);
            let said = format!("{}, number {i}: {problem:?} → {answer:?}, off by {error} units", family.name);
            assert!(answer.is_none_or(|u| (problem.lo..=problem.hi).contains(&u)), "{said}");
            assert!(error <= f64::from(BACKWARD_ERROR), "{said}");

            let roots = g.roots_by::<S>(problem.lo, problem.hi);
            assert_eq!(roots.first().copied(), answer, "{said}");
            assert!(roots.is_sorted(), "{said}: {roots:?}");
            assert!(
                roots.iter().all(|&u| problem.depth(u.into()) <= f64::from(BACKWARD_ERROR)),
                "{said}: {roots:?}"
            );
            worst = worst.max(error);
            found += usize::from(answer.is_some());
        }
        assert!(found > CUBICS / 10, "{}: only {found} roots", family.name);
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
        let problem = Problem::with_roots(roots, 1.0, -2.0, 2.0);
        let found = Cubic::new(problem.c).roots(problem.lo, problem.hi);
        assert_eq!(found.len(), 3, "number {i}: {problem:?} → {found:?}, should be {roots:?}");
        for (found, root) in found.iter().zip(roots) {
            // Backward error over the slope, which is at least gap² = 10⁻⁴.
            assert!((f64::from(*found) - root).abs() < 4.0 * 8.0 * UNIT / 1e-4, "{found} is not {root}");
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
            assert!((f64::from(root) - truth).abs() <= 2.0 * UNIT * truth, "√{x:e} = {root:e}");
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
