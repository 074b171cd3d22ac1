//! Cubics: contenders, peers and the crate's own methods, by family.

use embedded_lathe::Cubic;
use embedded_lathe::solve::BACKWARD_ERROR;
use laboratory::WRONG;
use laboratory::contenders::{Contender, EVERYWHERE, HOST, recursive};
use laboratory::families::{FAMILIES, Family, Question};
use laboratory::judge::Truth;
use laboratory::judged::Judged;
use laboratory::peers::PEERS;
use laboratory::sextic;
use laboratory::tally::Tally;
use laboratory::workload;
use std::sync::LazyLock;

const SEED: u64 = 4;
/// Questions a family: to the crate's methods, and to each contender.
const QUESTIONS: u64 = 1000;
const FEW: u64 = 300;

/// Every family's questions, with what exact arithmetic says of them.
static KNOWN: LazyLock<Vec<Vec<(Question, Truth)>>> = LazyLock::new(|| {
    let known = |family: &Family| {
        let questions = (0..QUESTIONS).map(|index| family.question(SEED, index));
        questions.map(|asked| (asked, Truth::new(&asked.c, asked.lo, asked.hi))).collect()
    };
    FAMILIES.iter().map(known).collect()
});

/// The first `count` questions of a family, with the number of each.
fn questions(family: &Family, count: u64) -> impl Iterator<Item = (u64, &'static Question, &'static Truth)> {
    let number = FAMILIES.iter().position(|other| other.name == family.name).expect(family.name);
    (0..count).zip(&KNOWN[number]).map(|(index, (question, truth))| (index, question, truth))
}

fn answer(method: &Contender, question: &Question) -> Option<f64> {
    (method.first_root)(&question.c, question.lo, question.hi).map(f64::from)
}

/// Nine tenths of the questions of every family are what it is called, and each of its kinds comes up, in a fiftieth of them at least.
#[test]
fn families_occur() {
    for family in FAMILIES {
        let mut counts = vec![0; family.kinds];
        for (_, question, truth) in questions(family, FEW) {
            if let Some(kind) = (family.kind)(question, truth) {
                counts[kind] += 1;
            }
        }
        assert!(10 * counts.iter().sum::<u64>() >= 9 * FEW, "{}: {counts:?} of {FEW}", family.name);
        assert!(counts.iter().all(|count| 50 * count >= FEW), "{}: {counts:?} of {FEW}", family.name);
    }
}

/// Every method that ships, over every backend, keeps its promise on every family; and the promise is not four times slack.
#[test]
fn shipped_methods_are_sound() {
    let mut worst = 0f64;
    for family in FAMILIES {
        for (index, question, truth) in questions(family, QUESTIONS) {
            let mut judged = Judged::default();
            for method in EVERYWHERE.iter().chain(HOST).filter(|method| method.shipped) {
                let answer = answer(method, question);
                let units = judged.verdict(answer, |answer| truth.judge(answer).units);
                worst = worst.max(units);
                assert!(
                    units <= f64::from(BACKWARD_ERROR),
                    "{} over {}, {}, seed {SEED}, index {index}: {question:?}: {answer:?} is {units} units off, roots {:?}",
                    method.method,
                    method.backend,
                    family.name,
                    truth.roots,
                );
            }
        }
    }
    assert!(4.0 * worst >= f64::from(BACKWARD_ERROR), "worst {worst}");
}

/// All roots, not the first alone: each within the promise, and as many as there are wherever no turning point is nearer to zero than that.
#[test]
fn all_roots_are_found() {
    let mut counted = 0;
    for family in FAMILIES {
        for (index, question, truth) in questions(family, QUESTIONS) {
            let Question { c, lo, hi } = *question;
            let found = Cubic::new(c).roots(lo, hi);
            let said = || {
                format!(
                    "{}, seed {SEED}, index {index}: {question:?}: {found:?}, roots {:?}",
                    family.name, truth.roots
                )
            };
            assert!(found.is_sorted(), "{}", said());
            for root in &found {
                assert!(truth.residual(f64::from(*root)) <= f64::from(BACKWARD_ERROR), "{}", said());
            }
            if truth.clearance() > f64::from(BACKWARD_ERROR) {
                counted += 1;
                assert_eq!(found.len(), truth.roots.len(), "{}", said());
            }
        }
    }
    assert!(counted as u64 > FAMILIES.len() as u64 * QUESTIONS / 2, "{counted}");
}

/// Where each contender fails: method, backend, family. The table of docs/ACCURACY.md in short; if one is mended, it must go.
const FAILURES: &[(&str, &str, &str)] = &[
    ("textbook Cardano", "libm", "c3/c2 from 1e-1 to 1e-12"),
    ("textbook Cardano", "libm", "c3 and c2 vanishing"),
    ("textbook Cardano", "libm", "roots over six decades"),
    ("textbook Cardano", "libm", "silhouette rays"),
    ("textbook Cardano", "std", "c3/c2 from 1e-1 to 1e-12"),
    ("textbook Cardano", "std", "rays of every kind"),
    ("textbook Cardano", "micromath", "well separated"),
    ("textbook Cardano", "micromath", "near-double, gaps 1e-1 to 1e-7"),
    ("textbook + Newton step", "libm", "near-double, gaps 1e-1 to 1e-7"),
    ("textbook + Newton step", "libm", "silhouette rays"),
    ("Blinn", "libm", "scaled by 2^-110 to 2^110"),
    ("Kahan", "libm", "near-triple, gaps 1e-1 to 1e-7"),
    ("Kahan", "libm", "scaled by 2^-110 to 2^110"),
    ("Newton alone", "", "near-double, gaps 1e-1 to 1e-7"),
    ("Newton alone", "", "silhouette rays"),
    ("kurbo", "f64", "c3/c2 from 1e-1 to 1e-12"),
    ("roots", "f64", "c3/c2 from 1e-1 to 1e-12"),
];

#[test]
fn contenders_fail_where_the_table_says() {
    for &(method, backend, family) in FAILURES {
        let tally = tally(method, backend, family);
        assert!(tally.beyond(WRONG) > 0, "{method} over {backend} on {family}: worst {}", tally.worst());
    }
}

/// Brackets at the critical points are as sound as the crate's methods: what the crate saves is their cost.
#[test]
fn brackets_do_not_fail() {
    for method in ["bracketed Newton", "bisection", "recursive"] {
        let backend = if method == "recursive" { "" } else { "libm" };
        for family in FAMILIES {
            let tally = tally(method, backend, family.name);
            assert_eq!(tally.beyond(WRONG), 0, "{method} on {}: {}", family.name, tally.worst());
        }
    }
}

fn tally(method: &str, backend: &str, family: &str) -> Tally {
    let family = FAMILIES.iter().find(|f| f.name == family).expect(family);
    let single = EVERYWHERE.iter().chain(HOST).find(|c| c.method == method && c.backend == backend);
    let double = PEERS.iter().find(|peer| peer.name == method);
    assert!(single.is_some() || double.is_some(), "{method} over {backend}");
    let mut tally = Tally::default();
    for (_, question, truth) in questions(family, FEW) {
        let answer = match (single, double) {
            (Some(method), _) => answer(method, question),
            (_, Some(peer)) => {
                (peer.first_root)(question.c.map(f64::from), question.lo.into(), question.hi.into())
            }
            _ => None,
        };
        tally.add(truth.judge(answer).units, None);
    }
    tally
}

/// The classical sextic and the paper's cubic, both by the one recursive method, are both solved soundly: what is compared is the cost.
#[test]
fn sextics_are_solved_soundly() {
    let mut with_roots = 0;
    for index in 0..QUESTIONS / 5 {
        let pair = sextic::pair(SEED, index);
        for c in [&pair.cubic.c[..], &pair.sextic[..]] {
            let truth = Truth::new(c, 0.0, 1.0);
            let units = truth.judge(recursive::first_root(c, 0.0, 1.0).map(f64::from)).units;
            with_roots += usize::from(!truth.roots.is_empty());
            assert!(units <= WRONG, "index {index}: {c:?}: {units} units, roots {:?}", truth.roots);
        }
    }
    assert!(with_roots as u64 > QUESTIONS / 5, "{with_roots}");
}

/// What instructions are counted on: most have a root, the well separated all, the rays not.
#[test]
fn the_workload_is_what_it_says() {
    for (name, make) in workload::FAMILIES {
        let items = (0..workload::COUNT).map(make);
        let roots = items.map(|item| Truth::new(&item.c, item.lo, item.hi).roots.len());
        let with_root = roots.filter(|count| *count > 0).count() as u32;
        assert!(2 * with_root > workload::COUNT, "{name}: {with_root}");
        assert!((with_root == workload::COUNT) == (name == "separated"), "{name}: {with_root}");
    }
}
