//! A stretch of the program that is measured: by valgrind, from outside, in an earlier run of the same.

use std::{cell::RefCell, hint::black_box, vec::IntoIter};

thread_local! {
    static COUNTS: RefCell<IntoIter<u64>> = RefCell::default();
}

/// What `measure` is to give out, in order.
pub fn foresee(counts: Vec<u64>) {
    COUNTS.set(counts.into_iter());
}

/// Runs `work` where valgrind counts; with its result, the instructions foreseen for it, 0 if none are.
pub fn measure<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let (mut work, mut result) = (Some(work), None);
    counted(&mut || result = work.take().map(|work| black_box(black_box(work)())));
    let instructions = COUNTS.with_borrow_mut(Iterator::next).unwrap_or(0);
    (result.expect("`counted` calls"), instructions)
}

/// The function that `host.rs` names to valgrind.
#[inline(never)]
fn counted(work: &mut dyn FnMut()) {
    work();
}
