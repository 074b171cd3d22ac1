use super::Math;

/// The [libm](https://docs.rs/libm) crate: pure Rust, the same bits on every machine.
///
/// Its `cbrt` and `cos` compute in f64 internally: more than a thousand instructions each on a Cortex-M4F.
///
/// ```
/// use embedded_lathe::math::{Libm, Math};
/// assert_eq!(Libm::cbrt(27.0), 3.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Libm;

impl Math for Libm {
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }

    fn cbrt(x: f32) -> f32 {
        libm::cbrtf(x)
    }

    fn acos(x: f32) -> f32 {
        libm::acosf(x)
    }

    fn cos(x: f32) -> f32 {
        libm::cosf(x)
    }
}
