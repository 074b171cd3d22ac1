//! One ray at a lathe: the *fast path* answers most, the *traversal* all, *chord* by chord.
//!
//! The same ray is parametrised three ways:
//!
//! | where | from | in units of | used for |
//! |---|---|---|---|
//! | [`Ray`](crate::Ray) | its origin | the direction given | `t_min`, a hit's t |
//! | [`LocalRay`], of the lathe's frame | its point nearest to the frame's origin | `Ray::direction`, of length 1 to 43 | planes, the traversal's `t` |
//! | a chord, and the fast path | where g is formed | the same | `s`, the argument of g |

mod chord;
mod fast_path;
mod local_ray;
mod query;
mod traverse;

pub(super) use local_ray::LocalRay;

/// Whether a hit at t counts: beyond `t_min`, and at a finite distance.
fn is_beyond(t: f32, t_min: f32) -> bool {
    t > t_min && t <= f32::MAX
}
