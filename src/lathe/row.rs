//! The rays of a row of pixels, traversed together: the *sweep*. It divides the row into *spans*, pixels that
//! are computed in the same way: by a *tracked root* with a *certificate*, by a *probe*, by a cap or a ring,
//! or, one pixel at a time, by a *single ray*.
//!
//! ```text
//! grid ───── the rays of a picture, and what is known of all of them
//!   │
//! bounds ─── what is known of the rays of a row
//!   │
//! sweep ──── the state: bounds, direction, the root that is tracked; setup makes one
//!   │
//!   ├── skip ───── Empty    pixels whose rays miss, certified by one of them
//!   │    │
//!   ├── certify             whether a tracked root is its ray's nearest
//!   ├── track ──── Tracked  the last pixel's root, moved on by Newton's method
//!   ├── flat ───── Flat     pixels that see a cap or a ring
//!   │
//! spans ──── what the next pixels see: one of these, or
//!                  Single   undecided: a ray of its own, as `ray/` casts it
//! ```

mod bounds;
mod certify;
mod flat;
mod grid;
mod ray_row;
mod setup;
mod skip;
mod spans;
mod sweep;
mod track;

pub(crate) use bounds::RowPart;
pub(crate) use grid::{CameraRays, RayGrid};
pub(crate) use sweep::{Scale, Span, Sweep};
