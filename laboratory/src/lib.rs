//! The laboratory: methods side by side on the same f32 inputs, judged by exact arithmetic.
//!
//! ```text
//! contenders ─┐
//! peers ──────┼─► answers ─┐
//! families ───┴─► truth ───┴─► judge ─► table, chart, atlas
//! rays, forms ───► hits ───────► judge ─► table, atlas
//! ```
//!
//! - [`exact`]: dyadic numbers without rounding, polynomials in them, certified signs and roots.
//! - [`families`]: cubics on which methods fail, and rays that make such cubics.
//! - [`judge`]: the backward error of an answer.
//! - [`contenders`] (f32, also for firmware), [`peers`] (f64, by others), [`forms`] (whole intersections).
//!
//! `laboratory/tests/stability` asserts on a share of it, `laboratory/examples/laboratory` writes all of it to `docs/`.

// Firmware has no use for it; a build of the whole workspace for a board finds it empty.
#![cfg_attr(target_os = "none", no_std)]
#![cfg(not(target_os = "none"))]

mod backends;
pub mod bernstein;
pub mod cases;
pub mod contenders;
pub mod exact;
pub mod families;
pub mod firmware;
pub mod forms;
pub mod hits;
pub mod judge;
pub mod judged;
pub mod lathes;
pub mod lists;
pub mod oracle;
pub mod outlines;
pub mod peers;
pub mod readme;
pub mod sextic;
pub mod subdivision;
pub mod tally;
pub mod troubles;
pub mod workload;

#[path = "../../tests/promise/mod.rs"]
mod promise;
pub use promise::{PROMISE, ROUNDOFF, unit};

/// How many units of [`ROUNDOFF`] are in 1.
const UNITS: f64 = 1.0 / ROUNDOFF;

/// An answer is called wrong, whichever solver gives it, if no change of the coefficients by less than this number
/// of units of 2⁻²⁴ explains it.
pub const WRONG: f64 = 64.0;

/// An intersection is called wrong, whichever code computes it, if no displacement by less than this number of units
/// ([`unit()`]) explains it: four times what the crate promises.
pub const DISPLACEMENT: f64 = 4.0 * PROMISE;

/// By how many units of `2⁻²⁴·Σ bⱼ·Bⱼ(u)`, magnitudes, the squared radius may be off where it touches zero
/// inside a segment, one for each of the three interpolations that it is found by
/// (`laboratory/tests/stability/touching.rs`).
pub const TOUCHING: f64 = 3.0;
