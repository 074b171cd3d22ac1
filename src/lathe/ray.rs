//! One ray and a lathe: the *fast path* decides most rays, the *traversal* all others, *chord* by chord.
//!
//! ```text
//! query ─┬─ fast_path     bounds of the whole profile at one or two places: miss, hit or undecided
//!        └─ traverse      all else: the slabs along the ray, one after another
//!             └─ chord    the part of the ray in one slab, and its roots
//! ```
//!
//! Points of a ray have three parameters. The t of a [`Ray`](crate::Ray) counts in units of the direction
//! that the ray was made of. The other two count in units of the ray's field `direction`, which is that
//! direction divided by `unit`:
//!
//! | name | counts from | in units of | used for |
//! |---|---|---|---|
//! | t of a [`Ray`](crate::Ray) | the ray's origin | the direction given | `t_min`, the t of a hit |
//! | t of a [`LocalRay`] | the ray's point nearest to the frame's origin | the field `direction`, x scaled by √k | planes, the state of the traversal |
//! | s | the point that g is formed about: a chord's `origin`, a place of the fast path | the field `direction`, x scaled by √k | the argument of g |

mod chord;
mod fast_path;
mod local_ray;
mod query;
mod traverse;

pub(super) use local_ray::LocalRay;

/// Whether a hit at t counts: t > `t_min`, and t is finite. False if t is NaN.
fn is_beyond(t: f32, t_min: f32) -> bool {
    t > t_min && t <= f32::MAX
}
