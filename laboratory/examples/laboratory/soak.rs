//! Fresh questions for as long as there is time; what the crate's methods get wrong is printed with its inputs.

use crate::progress::bar;
use embedded_lathe::solve::BACKWARD_ERROR;
use laboratory::contenders::{EVERYWHERE, HOST};
use laboratory::families::FAMILIES;
use laboratory::hits;
use laboratory::judge::Truth;
use laboratory::troubles::Trouble;
use laboratory::{PROMISE, forms};
use std::error::Error;
use std::time::Instant;

/// One family's worth of questions before the clock is looked at.
const ROUND: u64 = 200;

pub fn run(minutes: u64) -> Result<(), Box<dyn Error>> {
    let (start, seconds) = (Instant::now(), 60 * minutes);
    let bar = bar(seconds, "soak, seconds");
    let (mut questions, mut wrong, mut worst) = (0u64, 0u64, (0f64, 0f64));
    let mut seed = 1_000_000;
    while start.elapsed().as_secs() < seconds {
        seed += 1;
        for family in FAMILIES {
            for index in 0..ROUND {
                let question = family.question(seed, index);
                let truth = Truth::new(&question.c, question.lo, question.hi);
                for method in EVERYWHERE.iter().chain(HOST).filter(|method| method.shipped) {
                    let answer = (method.first_root)(&question.c, question.lo, question.hi);
                    let units = truth.judge(answer.map(f64::from)).units;
                    worst.0 = worst.0.max(units);
                    questions += 1;
                    if !(units <= f64::from(BACKWARD_ERROR)) {
                        wrong += 1;
                        let (method, backend) = (method.method, method.backend);
                        bar.suspend(|| {
                            println!("{method} over {backend}: {question:?}: {answer:?}, {units} units")
                        });
                    }
                }
            }
        }
        for trouble in Trouble::all() {
            for index in 0..ROUND {
                let case = trouble.case(seed, index);
                let answer = forms::asked(&forms::turned(case.outline), &case.cast);
                let units = hits::Truth::new(&case).judge_unsure(answer, trouble.doubt);
                worst.1 = worst.1.max(units);
                questions += 1;
                if !(units <= PROMISE) {
                    wrong += 1;
                    bar.suspend(|| println!("{}: {case}\n  {answer:?}, {units} units", trouble.name));
                }
            }
        }
        bar.set_position(start.elapsed().as_secs().min(seconds));
        bar.set_message(format!("{questions} questions, {wrong} wrong"));
    }
    bar.finish();
    let (solver, hit) = worst;
    println!(
        "{questions} answers, {wrong} wrong; worst backward error {solver:.2} units, worst displacement {hit:.2}"
    );
    Ok(())
}
