//! Tells the crate what stable Rust does not show to `cfg`: that a RISC-V has a floating-point unit, its extension F.
//!
//! The target's name begins with the letters of the extensions: `riscv32imafc-unknown-none-elf` has F, and so has any with
//! D or G. A nightly compiler lists F among the target's features, which cargo hands on. Without this script, or for a
//! target with another kind of name, the crate computes the same by software; `RUSTFLAGS='--cfg embedded_lathe_riscv_f'`
//! says the same by hand.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(embedded_lathe_riscv_f)");
    let target = std::env::var("TARGET").unwrap_or_default();
    let core = target.split(['-', '_', '.']).next().unwrap_or_default();
    let extensions = core.strip_prefix("riscv32").or_else(|| core.strip_prefix("riscv64"));
    let features = std::env::var("CARGO_CFG_TARGET_FEATURE").unwrap_or_default();
    let is_listed = extensions.is_some() && features.split(',').any(|feature| feature == "f");
    if is_listed || extensions.is_some_and(|letters| letters.contains(['f', 'd', 'g'])) {
        println!("cargo::rustc-cfg=embedded_lathe_riscv_f");
    }
}
