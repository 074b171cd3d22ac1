//! Square roots and other functions that `core` lacks, from three libraries. No other module names those
//! libraries.
//!
//! Each backend is a zero-sized type, so that one program can use several, and a test compare them.
//!
//! | backend | `sqrt` | `cbrt`, `acos`, `cos` |
//! |---|---|---|
//! | [`Native`] | correctly rounded: the hardware's root where there is one | as [`Libm`] |
//! | [`Libm`] | correctly rounded, integer arithmetic | within a unit in the last place |
//! | [`Micromath`] | within 2 units, from micromath's seed | within the bounds of [`Math`] |
//! | `Std` (feature `std`) | correctly rounded | the platform's |
//!
//! Correct rounding leaves one result, so the square roots of [`Native`], [`Libm`] and `Std` have the same
//! bits. The renderer uses no other of these functions.

mod cold_path;
pub(crate) mod const_fn;
mod libm;
mod micromath;
#[cfg_attr(
    any(
        all(target_arch = "arm", not(target_abi = "eabihf")),
        all(target_arch = "riscv32", not(embedded_lathe_riscv_f)),
    ),
    path = "math/minmax_by_bits.rs"
)]
pub(crate) mod minmax;
#[cfg(test)]
mod minmax_by_bits;
mod native;
mod root;
mod rsqrt;
#[cfg(all(feature = "std", not(target_os = "none")))]
mod std;

pub(crate) use self::cold_path::cold_path;
pub use self::libm::Libm;
pub use self::micromath::Micromath;
pub use self::native::Native;
pub(crate) use self::rsqrt::rsqrt_of_double;
#[cfg(all(feature = "std", not(target_os = "none")))]
pub use self::std::Std;

/// The unit roundoff of f32, 2⁻²⁴: an addition, multiplication, division or correctly rounded root is off by
/// at most this, relative to its exact result.
pub(crate) const UNIT_ROUNDOFF: f32 = 0.5 * f32::EPSILON;

/// The functions that solvers take from a mathematics library.
///
/// ```
/// use embedded_lathe::math::{Libm, Math, Micromath};
///
/// fn diagonal<M: Math>(a: f32, b: f32) -> f32 {
///     M::sqrt(a * a + b * b)
/// }
///
/// assert_eq!(diagonal::<Libm>(3.0, 4.0), 5.0);
/// assert!((diagonal::<Micromath>(3.0, 4.0) - 5.0).abs() < 1e-6);
/// ```
pub trait Math {
    /// √x for x ≥ 0, within 2 units of 2⁻²⁴ relative; NaN for x < 0.
    fn sqrt(x: f32) -> f32;
    /// ∛x for every normal x, within 8 %: a seed, not an answer. For zero and subnormal x the magnitude of
    /// the result is below 10⁻¹².
    fn cbrt(x: f32) -> f32;
    /// The angle in [0, π] whose cosine is x, for |x| ≤ 1, within 0.03 rad: a seed, not an answer.
    fn acos(x: f32) -> f32;
    /// The cosine of an angle in [−π, π] rad, within 0.002: a seed, not an answer.
    fn cos(x: f32) -> f32;
}
