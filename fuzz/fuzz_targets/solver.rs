//! Any cubic on any interval: every shipped solver's answer is within the promised backward error of the exact truth.
#![no_main]

#[path = "../../tests/cases/mod.rs"]
mod cases;
#[path = "../../tests/laboratory/mod.rs"]
mod laboratory;
#[path = "../../tests/oracle/mod.rs"]
mod oracle;

use embedded_lathe::{Cubic, solve::BACKWARD_ERROR};
use laboratory::contenders::{EVERYWHERE, HOST};
use laboratory::judge::Truth;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|input: ([f32; 4], f32, f32)| {
    let (c, one, other) = input;
    let (lo, hi) = (one.min(other), one.max(other));
    if !(c.iter().all(|c| c.is_finite()) && lo.is_finite() && hi.is_finite()) {
        assert!(Cubic::new(c).first_root(lo, hi).is_none_or(|root| lo <= root && root <= hi));
        return;
    }
    // Known: farther out powers overflow, and coefficients that matter there underflow.
    if lo.abs().max(hi.abs()) > 1e12 {
        return;
    }
    let truth = Truth::new(&c, lo, hi);
    for method in EVERYWHERE.iter().chain(HOST).filter(|method| method.shipped) {
        let answer = (method.first_root)(&c, lo, hi);
        let units = truth.judge(answer.map(f64::from)).units;
        // What the promise leaves out: terms that underflow beside the largest coefficient.
        let [c0, c1, c2, c3] = c.map(|c| f64::from(c.abs()));
        let u = answer.map_or(f64::from(lo.abs().max(hi.abs())), |u| f64::from(u.abs()));
        if ((c3 * u + c2) * u + c1) * u + c0 < 1e-30 * c0.max(c1).max(c2).max(c3) {
            continue;
        }
        assert!(
            units <= f64::from(BACKWARD_ERROR),
            "{} over {}: {c:?} on [{lo:?}, {hi:?}]: {answer:?} is {units} units off; truth {:?}",
            method.method,
            method.backend,
            truth.roots
        );
    }
    let roots = Cubic::new(c).roots(lo, hi);
    assert!(roots.is_sorted() && roots.iter().all(|root| lo <= *root && *root <= hi), "{roots:?}");
});
