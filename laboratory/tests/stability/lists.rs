//! All roots of a cubic, judged as one answer: each is a root, the signs between them alternate, and one
//! cubic within the promise has as many.

use embedded_lathe::Cubic;
use embedded_lathe::solve::{BACKWARD_ERROR, Solver};
use laboratory::exact::{Exact, Polynomial, exact};
use laboratory::families::{FAMILIES, Question};
use laboratory::lists::{is_certain, judge_list};
use laboratory::over_every_backend;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

const SEED: u64 = 7;
/// Questions a family.
const QUESTIONS: u64 = 100;

/// Cubics with up to three roots that are nearly one, nearly at the ends of the interval.
const TRIPLE: &str = "cubics about a root";

/// The largest change that makes a list true, in units.
#[derive(Default)]
struct Worst(f64);

impl Worst {
    fn check<S: Solver>(&mut self, question: &Question, name: &str) -> usize {
        let Question { c, lo, hi } = *question;
        let roots = Cubic::new(c).roots_by::<S>(lo, hi);
        let (g, lo, hi) = (Polynomial::new(&c), exact(lo), exact(hi));
        let exactly: Vec<Exact> = roots.iter().map(|&root| exact(root)).collect();
        let verdict = judge_list(&g, [&lo, &hi], &exactly);
        let promise = f64::from(BACKWARD_ERROR);
        let said = || format!("{name}: {question:?}: {roots:?}, {verdict:?}");
        assert!(verdict.alone <= promise && verdict.double <= promise, "{}", said());
        // Beside a triple root at an end of the interval each sign may be rounding's, and then no one cubic
        // has them all.
        let is_certain =
            name == TRIPLE || is_certain(&g, [&lo, &hi], roots.len(), promise) || verdict.joint <= promise;
        assert!(is_certain, "{}: no cubic so near has as many roots", said());
        self.0 = self.0.max(verdict.alone).max(verdict.double);
        roots.len()
    }
}

fn lists_are_sound<S: Solver>() {
    let mut worst = Worst::default();
    let mut found = [0; 4];
    for family in FAMILIES {
        for index in 0..QUESTIONS {
            found[worst.check::<S>(&family.question(SEED, index), family.name)] += 1;
        }
    }
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    for _ in 0..700 {
        let mut small = |low: f64| 10_f64.powf(rng.random_range(low..=0.0)) * rng.random_range(-1.0..1.0_f64);
        let [root, other, third, lead, near] = [0.0, -8.0, -8.0, -3.0, -7.0].map(&mut small);
        let [p, q, r] = [root, root + other, root + third];
        let cubic = [-p * q * r, p * q + q * r + r * p, -(p + q + r), 1.0];
        let parabola = [p * q, -(p + q), 1.0, 0.0];
        for (c, name) in [(cubic, TRIPLE), (parabola, "parabolas about a root")] {
            let question = Question {
                c: c.map(|c| (c * lead) as f32),
                lo: (root - near.abs()) as f32,
                hi: (root + small(-7.0).abs()) as f32,
            };
            found[worst.check::<S>(&question, name)] += 1;
        }
    }
    assert!(4.0 * worst.0 >= f64::from(BACKWARD_ERROR), "{}", worst.0);
    assert!(found.iter().all(|&count| count > 50), "{found:?}");
}

over_every_backend!(lists_are_sound);
