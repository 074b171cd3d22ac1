//! The same source gives the same bits: every emulated machine computes the pictures that the host computes.
//!
//! ```text
//! cargo test -p embedded-lathe-laboratory --test machines -- --ignored       needs qemu-system-arm, qemu-system-riscv32 and the targets
//! ```

#[path = "../../examples/machines/checksum.rs"]
mod checksum;
#[allow(dead_code)]
#[path = "../../examples/scenes/mod.rs"]
mod scenes;

use laboratory::firmware;
use std::path::Path;
use std::process::Command;

/// What the example prints on an emulated machine: that of its target, unless another one is named.
fn printed(target: &str, machine: Option<&str>) -> String {
    let elf = firmware::build(target, "machines", firmware::RELEASE, &[]);
    let mut runner = Command::new(Path::new(firmware::ROOT).join(".cargo/run-firmware"));
    if let Some(machine) = machine {
        runner.env("MACHINE", machine);
    }
    let output = runner.arg(elf).output().expect("the runner starts");
    assert!(output.status.success(), "{target}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// Asserts that a machine prints the checksums of the host's own pictures.
fn agrees_with_the_host(target: &str, machine: Option<&str>) {
    let expected: Vec<_> =
        scenes::NAMED.iter().map(|(name, scene)| format!("{name},{:016x}", checksum::of(scene))).collect();
    let printed = printed(target, machine);
    assert_eq!(printed.lines().collect::<Vec<_>>(), expected, "{target} {machine:?}");
}

macro_rules! machines {
    ($($(#[$doc:meta])* $name:ident($target:expr, $machine:expr);)*) => {$(
        $(#[$doc])*
        #[test]
        #[ignore = "needs an emulator and a target"]
        fn $name() {
            agrees_with_the_host($target, $machine);
        }
    )*};
}

machines! {
    /// BBC micro:bit: 16 KiB of RAM.
    cortex_m0(firmware::M0, None);
    cortex_m3(firmware::M3, None);
    cortex_m4_with_fpu(firmware::M4F, None);
    /// The code of a Cortex-M4.
    cortex_m7_with_fpu(firmware::M4F, Some("mps2-an500"));
    cortex_m33_without_fpu("thumbv8m.main-none-eabi", None);
    cortex_m33_with_fpu("thumbv8m.main-none-eabihf", None);
    /// The instructions of an ESP32-C3.
    riscv_without_fpu("riscv32imc-unknown-none-elf", None);
    riscv_with_fpu("riscv32imafc-unknown-none-elf", None);
}

/// Two pictures have one checksum only if they are one: of the scenes here no two have.
#[test]
fn checksums_tell_pictures_apart() {
    let mut sums: Vec<_> = scenes::NAMED.iter().map(|(_, scene)| checksum::of(scene)).collect();
    sums.sort();
    sums.dedup();
    assert_eq!(sums.len(), scenes::NAMED.len());
}
