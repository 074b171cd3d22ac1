//! What a program that casts its own rays makes of the vase's scene.

use super::{CLAY, VASE, VASE_SCENE};
use embedded_lathe::{Hit, Ray, Rgb};

/// The color that a ray sees by Lambert's law, or `None` if it misses the vase. `nearest` returns the ray's first hit of
/// the vase.
pub fn seen(ray: &Ray, nearest: impl Fn(&Ray) -> Option<Hit>) -> Option<Rgb> {
    let hit = nearest(ray)?;
    let ([nx, ny, nz], [lx, ly, lz]) = (VASE.surface(ray, &hit).normal, VASE_SCENE.light.towards());
    let side = if hit.enters { 1.0 } else { -1.0 };
    let cosine = (side * (nx * lx + ny * ly + nz * lz)).max(0.0);
    let share = VASE_SCENE.light.ambient() + (1.0 - VASE_SCENE.light.ambient()) * cosine;
    Some(Rgb::new(CLAY.r * share, CLAY.g * share, CLAY.b * share))
}
