//! Firmware for the tests that look at it from outside.

use std::{env, path::PathBuf, process::Command};

/// The folder of `Cargo.toml`, `examples/` and `.cargo/`.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

pub const M0: &str = "thumbv6m-none-eabi";
pub const M3: &str = "thumbv7m-none-eabi";
pub const M4F: &str = "thumbv7em-none-eabihf";

/// For speed, and for flash.
pub const RELEASE: &str = "release";
pub const SMALL: &str = "small";

/// Builds a firmware example as `cargo run --profile …` would, and says where it lies.
///
/// `FIRMWARE_CARGO` names another cargo, for a machine whose own has no such targets.
pub fn build(target: &str, example: &str, profile: &str, options: &[&str]) -> PathBuf {
    let cargo = env::var("FIRMWARE_CARGO").unwrap_or(env!("CARGO").into());
    let output = Command::new(cargo)
        .current_dir(ROOT)
        .args([
            "build",
            "--quiet",
            "--profile",
            profile,
            "--target",
            target,
            "--package",
            "embedded-lathe",
            "--example",
            example,
        ])
        .args(["--message-format", "json-render-diagnostics"])
        .args(options)
        .output()
        .expect("cargo starts");
    let messages = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{example} for {target}:\n{}", String::from_utf8_lossy(&output.stderr));

    let elf = messages.rsplit("\"executable\":\"").next().and_then(|rest| rest.split('"').next());
    elf.expect("cargo names the executable").into()
}
