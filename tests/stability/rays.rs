use crate::laboratory::{contenders, forms, hits::Truth, troubles::Trouble};
use embedded_lathe::{math, solve::{Cardano, DefaultSolver}};

#[test]
fn look() {
    let textbook = |c: &[f32; 4]| contenders::textbook_roots::<contenders::Direct<math::Std>>(c);
    let first = contenders::HOST[2].first_root;
    for trouble in Trouble::all() {
        let start = std::time::Instant::now();
        let n = 400;
        let mut bad = [(0, 0f64, 0); 4];
        let mut hits = 0;
        for i in 0..n {
            let case = trouble.case(1, i);
            let truth = Truth::new(&case);
            hits += !truth.crossings.is_empty() as usize;
            let lathe = forms::turned(case.outline);
            let answers = [
                forms::paper(case.outline, &case.cast, textbook),
                forms::sound(case.outline, &case.cast, first),
                forms::shipped::<DefaultSolver>(&lathe, &case.cast),
                forms::shipped::<Cardano<math::Libm>>(&lathe, &case.cast),
            ];
            for (j, (bad, answer)) in bad.iter_mut().zip(answers).enumerate() {
                let units = truth.judge(answer);
                bad.0 += (units > 16.0) as usize;
                bad.1 = bad.1.max(units);
                bad.2 += answer.is_some() as usize;
                if j == 2 && units > 16.0 {
                    println!("{case}\n {answer:?} {units} {:?}", truth.crossings);
                }
            }
        }
        println!("{} hits {hits}/{n} {:?} {bad:?}", trouble.name, start.elapsed());
    }
}
