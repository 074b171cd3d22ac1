extern crate std;

use super::Math;

/// The standard library's functions. Not on bare-metal targets, which have no standard library.
///
/// ```
/// use embedded_lathe::math::{Math, Std};
/// assert_eq!(Std::sqrt(2.0), 2_f32.sqrt());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Std;

impl Math for Std {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }

    fn cbrt(x: f32) -> f32 {
        x.cbrt()
    }

    fn acos(x: f32) -> f32 {
        x.acos()
    }

    fn cos(x: f32) -> f32 {
        x.cos()
    }
}
