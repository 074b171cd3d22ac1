//! Where methods fail, and that the crate's do not: a fixed, seeded share of the laboratory.
//!
//! ```text
//! cargo test --release --test stability                          this share, with its tables on failure
//! cargo run --release --example laboratory -- tables             the tables of docs/ACCURACY.md
//! cargo run --release --example laboratory -- soak 60            as much as fits into 60 minutes
//! ```

mod bernstein;
mod cubics;
mod found;
mod lists;
mod rays;
mod touching;
