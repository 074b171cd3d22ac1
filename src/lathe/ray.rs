//! One ray at a lathe.

mod chord;
mod fast_path;
mod local_ray;
mod query;
mod traverse;

pub(super) use local_ray::LocalRay;

/// A distance too large for a number is none.
fn is_beyond(t: f32, t_min: f32) -> bool {
    t > t_min && t <= f32::MAX
}
