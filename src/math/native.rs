use super::{Libm, Math};

/// The machine's own correctly rounded square root where it has one, else a small one in integers; [`Libm`]
/// for the other functions. The renderer uses this backend.
///
/// | machine | root |
/// |---|---|
/// | hard-float Arm without an operating system | `vsqrt.f32` |
/// | RISC-V with the extension F | `fsqrt.s` |
/// | any other with an operating system, feature `std` | the standard library's |
/// | any other | in integers |
///
/// Whether a RISC-V has F, stable Rust does not show to `cfg`. The crate's build script knows it by the
/// target's name, such as `riscv32imafc-unknown-none-elf`. For a RISC-V whose name does not say it,
/// `RUSTFLAGS='--cfg embedded_lathe_riscv_f'` does; without that the root is computed by software, with the
/// same bits, and pictures in integers.
///
/// ```
/// use embedded_lathe::math::{Libm, Math, Native};
/// assert_eq!(Native::sqrt(2.0).to_bits(), Libm::sqrt(2.0).to_bits());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Native;

impl Math for Native {
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        sqrt(x)
    }

    fn cbrt(x: f32) -> f32 {
        Libm::cbrt(x)
    }

    fn acos(x: f32) -> f32 {
        Libm::acos(x)
    }

    fn cos(x: f32) -> f32 {
        Libm::cos(x)
    }
}

/// √x by the instruction `vsqrt.f32`.
#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
#[inline(always)]
#[allow(unsafe_code)]
fn sqrt(x: f32) -> f32 {
    let root: u32;
    // SAFETY: the target's ABI, `eabihf`, guarantees a floating-point unit. The three instructions change one
    // core register, `s0`, and the exception flags of FPSCR; so `preserves_flags` is not promised.
    unsafe {
        core::arch::asm!(
            "vmov s0, {x}",
            "vsqrt.f32 s0, s0",
            "vmov {x}, s0",
            x = inlateout(reg) x.to_bits() => root,
            out("s0") _,
            options(pure, nomem, nostack),
        );
    }
    f32::from_bits(root)
}

/// √x by the instruction `fsqrt.s`.
#[cfg(embedded_lathe_riscv_f)]
#[inline(always)]
#[allow(unsafe_code)]
fn sqrt(x: f32) -> f32 {
    let root: f32;
    // SAFETY: the instruction belongs to F, and changes one register and the exception flags of `fcsr`; so
    // `preserves_flags` is not promised. Without F there are no registers of the class `freg`, and this
    // does not compile.
    unsafe {
        core::arch::asm!(
            "fsqrt.s {root}, {x}",
            x = in(freg) x,
            root = lateout(freg) root,
            options(pure, nomem, nostack),
        );
    }
    root
}

/// √x by the standard library, or without it in integers.
#[cfg(not(any(
    all(target_arch = "arm", target_os = "none", target_abi = "eabihf"),
    embedded_lathe_riscv_f
)))]
#[inline(always)]
fn sqrt(x: f32) -> f32 {
    #[cfg(all(feature = "std", not(target_os = "none")))]
    use super::Std;
    #[cfg(not(all(feature = "std", not(target_os = "none"))))]
    use super::root::root;
    #[cfg(all(feature = "std", not(target_os = "none")))]
    let root = Std::sqrt;
    root(x)
}
