//! What `RUSTFLAGS='--cfg embedded_lathe_arithmetic="integers"'` says for a whole build, for this package alone.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(embedded_lathe_arithmetic, values(\"floats\", \"integers\"))");
    println!("cargo::rustc-check-cfg=cfg(embedded_lathe_riscv_f)");
    println!("cargo::rustc-cfg=embedded_lathe_arithmetic=\"integers\"");
}
