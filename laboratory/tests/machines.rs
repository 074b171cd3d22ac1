//! The same source gives the same bits: every emulated machine computes the pictures and the roots of cubics
//! that the host computes in the same arithmetic: floats here, integers in `integers/tests/machines.rs`.
//!
//! ```text
//! cargo test --test machines -- --ignored       needs qemu-system-arm, qemu-system-riscv32 and the targets
//! ```

#[path = "../../examples/machines/checksum.rs"]
mod checksum;
#[path = "../../examples/machines/roots.rs"]
mod roots;
#[allow(dead_code)]
#[path = "../../examples/scenes/mod.rs"]
mod scenes;

use embedded_lathe::math::Std;
use embedded_lathe::solve::{BACKWARD_ERROR, Solver, Split};
use laboratory::judge::Truth;
use laboratory::{firmware, over_every_backend};
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

/// Asserts that a machine prints the checksums of the host's own pictures and roots.
fn agrees_with_the_host(target: &str, machine: Option<&str>) {
    let pictures = scenes::NAMED.iter().map(|(name, scene)| (*name, checksum::of(scene)));
    let roots = roots::SOLVERS.iter().map(|(name, checksum)| (*name, checksum()));
    let expected: Vec<_> =
        pictures.chain(roots).map(|(name, checksum)| format!("{name},{checksum:016x}")).collect();
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

#[cfg(not(embedded_lathe_arithmetic = "integers"))]
machines! {
    cortex_m4_with_fpu(firmware::M4F, None);
    /// The code of a Cortex-M4.
    cortex_m7_with_fpu(firmware::M4F, Some("mps2-an500"));
    cortex_m33_with_fpu("thumbv8m.main-none-eabihf", None);
    riscv_with_fpu("riscv32imafc-unknown-none-elf", None);
}

#[cfg(embedded_lathe_arithmetic = "integers")]
machines! {
    /// BBC micro:bit: 16 KiB of RAM.
    cortex_m0(firmware::M0, None);
    cortex_m3(firmware::M3, None);
    cortex_m33_without_fpu("thumbv8m.main-none-eabi", None);
    /// The instructions of an ESP32-C3.
    riscv_without_fpu("riscv32imc-unknown-none-elf", None);
}

/// Two pictures have one checksum only if they are one: of the scenes here no two have.
#[test]
fn checksums_tell_pictures_apart() {
    let mut sums: Vec<_> = scenes::NAMED.iter().map(|(_, scene)| checksum::of(scene)).collect();
    sums.sort();
    sums.dedup();
    assert_eq!(sums.len(), scenes::NAMED.len());
}

/// Correctly rounded square roots are the same by every backend; and so are the roots of cubics made with
/// them, also where an intermediate result is NaN, whose sign differs from machine to machine, and from build
/// to build.
#[test]
fn correctly_rounded_backends_find_the_same_roots() {
    let [native, libm] = ["split native", "split libm"].map(|wanted| {
        let (_, checksum) = roots::SOLVERS.iter().find(|(name, _)| *name == wanted).unwrap();
        checksum()
    });
    assert_eq!(native, roots::of::<Split<Std>>());
    assert_eq!(native, libm);
}

/// What is compared is right, too: each list of roots keeps the promises, by exact arithmetic.
fn keeps_the_promise<S: Solver>() {
    let (mut found, mut promise) = ([0; 4], 0.0_f64);
    for (g, lo, hi) in roots::cubics().step_by(5) {
        let roots = g.roots_by::<S>(lo, hi);
        found[roots.len()] += 1;
        if !g.c.iter().all(|c| c.is_finite()) {
            assert!(roots.is_empty(), "{g:?}: {roots:?}");
            continue;
        }
        let truth = Truth::promised(&g.c, lo.max(f32::MIN), hi.min(f32::MAX));
        let first = truth.judge(roots.first().map(|root| f64::from(*root))).units;
        let units = roots.iter().map(|root| truth.residual(f64::from(*root))).fold(first, f64::max);
        let said = || format!("{g:?} in [{lo}, {hi}]: {roots:?}, off by {units} units, {:?}", truth.roots);
        assert!(units <= f64::from(BACKWARD_ERROR), "{}", said());
        assert!(roots.is_sorted(), "{}", said());
        promise = promise.max(units);
    }
    assert!(promise > 1.0 && found.iter().all(|count| *count > 20), "{promise}, {found:?}");
}

over_every_backend!(keeps_the_promise);
