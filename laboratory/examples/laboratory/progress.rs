//! How far a long run is.

use indicatif::{ProgressBar, ProgressStyle};

/// A progress bar of `steps` steps, with the time that is left.
pub fn bar(steps: u64, what: &str) -> ProgressBar {
    let style = ProgressStyle::with_template("{prefix:>14} [{bar:40}] {pos}/{len} {msg} {eta}");
    let bar = ProgressBar::new(steps).with_prefix(what.to_owned());
    match style {
        Ok(style) => bar.with_style(style.progress_chars("=> ")),
        Err(_) => bar,
    }
}
