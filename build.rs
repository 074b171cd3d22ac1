//! Tells the crate what stable Rust does not show to `cfg`: that a RISC-V has a floating-point unit, its extension F.
//!
//! The target's name begins with the letters of the extensions: `riscv32imafc-unknown-none-elf` has F, and so has any with
//! D or G. Without this script, or for a target with another kind of name, the crate computes the same by software;
//! `RUSTFLAGS='--cfg embedded_lathe_riscv_f'` says the same by hand.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(embedded_lathe_riscv_f)");
    let target = std::env::var("TARGET").unwrap_or_default();
    let core = target.split(['-', '_', '.']).next().unwrap_or_default();
    let extensions = core.strip_prefix("riscv32").or_else(|| core.strip_prefix("riscv64"));
    if extensions.is_some_and(|letters| letters.contains(['f', 'd', 'g'])) {
        println!("cargo::rustc-cfg=embedded_lathe_riscv_f");
    }
}
