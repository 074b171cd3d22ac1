//! Cubic solvers that others wrote, in f64. Nothing here shares a line with the crate.

/// The first root in an interval, in f64.
pub type FirstRoot = fn([f64; 4], f64, f64) -> Option<f64>;

pub struct Peer {
    pub name: &'static str,
    pub first_root: FirstRoot,
}

pub const PEERS: &[Peer] = &[
    Peer { name: "kurbo", first_root: kurbo },
    Peer { name: "polycool", first_root: polycool },
    Peer { name: "roots", first_root: roots },
];

/// Blinn's method with Yuksel's guidance on a normalised cubic.
fn kurbo([c0, c1, c2, c3]: [f64; 4], lo: f64, hi: f64) -> Option<f64> {
    first_of(&kurbo::common::solve_cubic(c0, c1, c2, c3), lo, hi)
}

/// Brackets and Newton's method. It asks for an absolute error: as small as can be.
fn polycool(c: [f64; 4], lo: f64, hi: f64) -> Option<f64> {
    first_of(&polycool::Cubic::new(c).roots_between(lo, hi, f64::MIN_POSITIVE), lo, hi)
}

/// Cardano's and Viète's formulas.
fn roots([c0, c1, c2, c3]: [f64; 4], lo: f64, hi: f64) -> Option<f64> {
    first_of(::roots::find_roots_cubic(c3, c2, c1, c0).as_ref(), lo, hi)
}

fn first_of(roots: &[f64], lo: f64, hi: f64) -> Option<f64> {
    let inside = roots.iter().copied().filter(|root| lo <= *root && *root <= hi);
    inside.reduce(f64::min)
}
