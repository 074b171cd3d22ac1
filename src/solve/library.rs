//! The public solver library: the roots of a cubic in an interval, by solvers over mathematics libraries.
//! Rays and pictures use nothing of it.

mod bernstein;
mod cardano;
mod collect;
mod cubic;
mod inflection;
mod refine;
mod rescale;
mod split;

pub use cardano::Cardano;
pub use cubic::DefaultSolver;
pub use refine::refine;
pub use split::Split;
