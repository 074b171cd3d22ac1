//! Any cubic on any interval: every shipped solver's answer is within the promised backward error of the exact truth.
#![no_main]

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
    let truth = Truth::promised(&c, lo, hi);
    for method in EVERYWHERE.iter().chain(HOST).filter(|method| method.shipped) {
        let answer = (method.first_root)(&c, lo, hi);
        let units = truth.judge(answer.map(f64::from)).units;
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
    for root in &roots {
        let units = truth.residual(f64::from(*root));
        assert!(units <= f64::from(BACKWARD_ERROR), "{c:?} on [{lo:?}, {hi:?}]: {roots:?}: {units} units off");
    }
});
