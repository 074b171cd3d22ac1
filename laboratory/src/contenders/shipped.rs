use embedded_lathe::Cubic;
use embedded_lathe::math::Math;
use embedded_lathe::solve::{Cardano, Split};

/// The crate's Split, which `Cubic::first_root` uses.
pub fn split<M: Math>(&c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    Cubic::new(c).first_root_by::<Split<M>>(lo, hi)
}

/// The crate's Cardano.
pub fn cardano<M: Math>(&c: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    Cubic::new(c).first_root_by::<Cardano<M>>(lo, hi)
}
