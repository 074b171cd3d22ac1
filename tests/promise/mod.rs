//! What the crate's page promises of hits, in numbers: for the tests here and for the laboratory.

/// The unit roundoff of f32, ε = 2⁻²⁴.
pub const ROUNDOFF: f64 = 1.0 / 16_777_216.0;

/// How many units a hit may be off, and a ray has to clear what it should miss.
pub const PROMISE: f64 = 4.0;

/// The unit. The size of a solid is its height or its largest diameter, whichever is more; the distance is
/// that of the ray's origin from the middle of the solid's axis.
pub fn unit(size: f64, distance: f64) -> f64 {
    ROUNDOFF * (size + distance)
}
