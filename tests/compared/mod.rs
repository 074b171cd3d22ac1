//! Two pictures that should be the same, compared pixel by pixel.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};

/// Pixels compared, and those that differ: by one shade of a channel, where rounding decides.
#[derive(Default)]
pub struct Compared {
    pub pixels: usize,
    pub differ: usize,
}

impl Compared {
    pub fn add(&mut self, found: Rgb565, truth: Rgb565, what: &str) {
        self.pixels += 1;
        self.differ += usize::from(found != truth);
        for (a, b) in [(found.r(), truth.r()), (found.g(), truth.g()), (found.b(), truth.b())] {
            assert!(a.abs_diff(b) <= 1, "{what}: {found:?}, not {truth:?}");
        }
    }
}
