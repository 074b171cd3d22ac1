//! Draws `docs/row.svg`: the rays of a row of pixels in their own plane, and what they meet of the reference vase.
//!
//! ```text
//! cargo run --release --example row
//! ```

#[cfg(not(target_os = "none"))]
mod picture;
#[cfg(not(target_os = "none"))]
mod plane;
#[cfg(not(target_os = "none"))]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;
#[cfg(not(target_os = "none"))]
mod svg;

#[cfg(not(target_os = "none"))]
fn main() -> std::io::Result<()> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/row.svg");
    std::fs::write(path, picture::picture())?;
    println!("{path}");
    Ok(())
}

/// A program for hosts: there is nothing for firmware to do here.
#[cfg(target_os = "none")]
fn main() {}
