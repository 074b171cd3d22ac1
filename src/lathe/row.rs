//! The rays of a row of pixels at a lathe, together.

mod cap;
mod certify;
mod normal;
mod ray_row;
mod setup;
mod skip;
mod sweep;
mod track;

pub(crate) use normal::{Seen, Wall};
pub(crate) use ray_row::RayRow;
pub(crate) use sweep::Sweep;
pub(crate) use track::Stop;
