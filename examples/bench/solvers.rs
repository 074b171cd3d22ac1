//! Solvers alone: the first root in [0, 1] of each cubic of the table.

use crate::{cubics::CUBICS, region::measure, report::line, textbook};
use core::hint::black_box;
use embedded_lathe::{
    Bernstein, Cubic,
    math::{Libm, Micromath, Native},
    solve::{Cardano, Solver, Split},
};

/// What walking the table takes is taken off.
pub fn measured() {
    let alone = solver("table alone", 0, |c| Some(c[0]));
    let line = |name, solve: fn([f32; 4]) -> Option<f32>| {
        solver(name, alone, solve);
    };
    line("split native", first_root::<Split<Native>>);
    line("split libm", first_root::<Split<Libm>>);
    line("split micromath", first_root::<Split<Micromath>>);
    line("cardano native", first_root::<Cardano<Native>>);
    line("cardano libm", first_root::<Cardano<Libm>>);
    line("cardano micromath", first_root::<Cardano<Micromath>>);
    line("ordinates native", |b| Bernstein::new(b).first_root());
    line("textbook libm", |c| textbook::first_root::<textbook::Libm>(c, 0.0, 1.0));
    line("textbook micromath", |c| textbook::first_root::<textbook::Micromath>(c, 0.0, 1.0));
}

fn first_root<S: Solver>(c: [f32; 4]) -> Option<f32> {
    Cubic::new(c).first_root_by::<S>(0.0, 1.0)
}

fn solver(name: &str, alone: u64, solve: fn([f32; 4]) -> Option<f32>) -> u64 {
    let (roots, instructions) = measure(|| {
        let root = |c: &[f32; 4]| black_box(black_box(solve)(black_box(*c))).is_some();
        CUBICS.iter().map(root).fold(0, |roots, root| roots + u64::from(root))
    });
    line(name, CUBICS.len() as u64, roots, instructions.saturating_sub(alone));
    instructions
}
