//! The rays of a row of pixels, traversed together.
//!
//! ```text
//! setup ── bounds of the row, set once
//!   │
//! sweep ── what the next pixels see: a Span, from pixel to pixel
//!   ├── track ──── Tracked  the last pixel's root, moved on by Newton's method
//!   │     └── certify       whether it is its ray's nearest
//!   ├── cap ────── Cap      pixels whose rays come in through a cap
//!   ├── skip ───── Empty    pixels whose rays miss, certified by one of them
//!   └───────────── Single   undecided: a ray of its own, as `ray/` casts it
//! ```

mod cap;
mod certify;
mod normal;
mod ray_row;
mod setup;
mod skip;
mod sweep;
mod track;

pub(crate) use normal::Seen;
pub(crate) use ray_row::RayRow;
pub(crate) use setup::RowPart;
pub(crate) use sweep::{Span, Sweep};
