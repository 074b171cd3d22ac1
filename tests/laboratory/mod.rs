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
//! `tests/stability` asserts on a share of it, `examples/laboratory` writes all of it to `docs/`.

// Every program that takes this module in uses another part of it.
#![allow(dead_code)]

pub mod contenders;
pub mod exact;
pub mod families;
pub mod forms;
pub mod hits;
pub mod judge;
pub mod peers;
pub mod sextic;
pub mod tally;
pub mod troubles;
pub mod workload;

/// What no change of the coefficients below so many units of 2⁻²⁴ explains is called wrong, whoever says it.
pub const WRONG: f64 = 64.0;

/// What no displacement below so many units of 2⁻²⁴·(size + distance) explains is a wrong intersection.
pub const DISPLACEMENT: f64 = 16.0;

/// What the crate's own intersections promise: a quarter of that.
pub const PROMISE: f64 = 4.0;

/// By how many units of `2⁻²⁴·Σ bⱼ·Bⱼ(u)`, magnitudes, the squared radius may be off where it touches zero
/// inside a segment, one for each of the three interpolations that it is found by
/// (`tests/stability/touching.rs`).
pub const TOUCHING: f64 = 3.0;
