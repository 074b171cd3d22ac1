//! The contenders in f32: one file a method, nothing but `core` and the crate, so that firmware can take this directory in
//! (`#[path = "../../laboratory/src/contenders/mod.rs"]`) and count their instructions on the target.
//!
//! Each answers the same question: the smallest root of `c[0] + c[1]·u + c[2]·u² + c[3]·u³` in [lo, hi].

mod blinn;
mod bracketed;
mod functions;
mod kahan;
mod newton;
pub mod recursive;
mod shipped;
mod textbook;

pub use functions::{Direct, Functions, MicromathDirect};
pub use textbook::roots as textbook_roots;

use embedded_lathe::math;

/// The first root in an interval.
pub type FirstRoot = fn(&[f32; 4], f32, f32) -> Option<f32>;

/// A method over a mathematics library.
#[derive(Clone, Copy)]
pub struct Contender {
    pub method: &'static str,
    /// Where its functions come from.
    pub backend: &'static str,
    pub first_root: FirstRoot,
    /// Whether the crate ships it, and so answers for it.
    pub shipped: bool,
}

const fn rival(method: &'static str, backend: &'static str, first_root: FirstRoot) -> Contender {
    Contender { method, backend, first_root, shipped: false }
}

const fn ours(method: &'static str, backend: &'static str, first_root: FirstRoot) -> Contender {
    Contender { method, backend, first_root, shipped: true }
}

type Libm = Direct<math::Libm>;

/// Everything that runs on the target.
pub const EVERYWHERE: &[Contender] = &[
    ours("split", "native", shipped::split::<math::Native>),
    ours("split", "libm", shipped::split::<math::Libm>),
    ours("split", "micromath", shipped::split::<math::Micromath>),
    ours("Cardano", "native", shipped::cardano::<math::Native>),
    ours("Cardano", "libm", shipped::cardano::<math::Libm>),
    ours("Cardano", "micromath", shipped::cardano::<math::Micromath>),
    rival("textbook Cardano", "libm", textbook::first_root::<Libm>),
    rival("textbook Cardano", "micromath", textbook::first_root::<MicromathDirect>),
    rival("textbook + Newton step", "libm", textbook::corrected::<Libm>),
    rival("Blinn", "libm", blinn::first_root::<Libm>),
    rival("Kahan", "libm", kahan::first_root::<Libm>),
    rival("Newton alone", "", newton::first_root),
    rival("bracketed Newton", "libm", bracketed::newton::<Libm>),
    rival("bisection", "libm", bracketed::bisection::<Libm>),
    rival("recursive", "", recursive::first_root_of_cubic),
];

/// The same over the standard library, which a host has.
#[cfg(not(target_os = "none"))]
pub const HOST: &[Contender] = &[
    ours("split", "std", shipped::split::<math::Std>),
    ours("Cardano", "std", shipped::cardano::<math::Std>),
    rival("textbook Cardano", "std", textbook::first_root::<Direct<math::Std>>),
];

/// The smallest of some numbers that lies in [lo, hi]; NaN never does.
fn first_of(roots: &[f32], lo: f32, hi: f32) -> Option<f32> {
    let mut first = None;
    for &root in roots {
        let nearer = match first {
            Some(first) => root < first,
            None => true,
        };
        if lo <= root && root <= hi && nearer {
            first = Some(root);
        }
    }
    first
}
