use super::{Libm, Math};

/// The machine's own correctly rounded square root where it has one, and [`Libm`] for the rest. The renderer
/// uses this backend.
///
/// | machine | root |
/// |---|---|
/// | hard-float Arm without an operating system | `vsqrt.f32` |
/// | any with an operating system, feature `std` | the standard library's |
/// | any other | [`Libm`]'s |
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
    // core register and `s0`, both declared.
    unsafe {
        core::arch::asm!(
            "vmov s0, {x}",
            "vsqrt.f32 s0, s0",
            "vmov {x}, s0",
            x = inlateout(reg) x.to_bits() => root,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    f32::from_bits(root)
}

#[cfg(all(feature = "std", not(target_os = "none")))]
use super::Std as Root;
#[cfg(any(not(feature = "std"), target_os = "none"))]
#[cfg(not(all(target_arch = "arm", target_os = "none", target_abi = "eabihf")))]
use Libm as Root;

/// √x by the standard library, or by [`Libm`] without it.
#[cfg(not(all(target_arch = "arm", target_os = "none", target_abi = "eabihf")))]
#[inline(always)]
fn sqrt(x: f32) -> f32 {
    Root::sqrt(x)
}
