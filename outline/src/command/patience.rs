//! A sign of life where something takes longer than a second.

use indicatif::ProgressBar;
use std::{sync::mpsc, thread, time::Duration};

const SECOND: Duration = Duration::from_secs(1);

/// Does some work, and returns what it returns. A spinner with a message turns on the terminal from the first second
/// until it is done.
pub(super) fn with<T>(message: String, work: impl FnOnce() -> T) -> T {
    thread::scope(|scope| {
        let (done, waiting) = mpsc::channel::<()>();
        scope.spawn(move || {
            if waiting.recv_timeout(SECOND) == Err(mpsc::RecvTimeoutError::Timeout) {
                let spinner = ProgressBar::new_spinner().with_message(message);
                spinner.enable_steady_tick(SECOND / 10);
                // Until the other end is dropped, also by a panic.
                let _ = waiting.recv();
                spinner.finish_and_clear();
            }
        });
        let result = work();
        drop(done);
        result
    })
}
