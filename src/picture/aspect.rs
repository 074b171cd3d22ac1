//! How a sheet of a solid is seen in a picture: what is the same for all of the picture's rows.

use crate::arithmetic::{KEPT, ToLight};
use crate::camera::Row;
use crate::lathe::{CameraRays, Lathe, RayGrid};
use crate::ray::Ray;
use crate::scene::Scene;
use crate::shade::to_light;
use crate::solid::Solid;
use crate::vector::vector;

/// The rays of a picture's pixels at a sheet of a solid, and the light that falls on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aspect {
    pub grid: RayGrid,
    /// The direction to the light, in the solid's own space, and its mirror image where the left half of a
    /// row sees the mirror image of what its right half sees.
    pub to_light: ToLight,
    pub mirrored: ToLight,
}

impl Aspect {
    /// The aspect of the first sheet of a solid in a scene's picture of `width` columns and `height` rows.
    const fn new(solid: &Solid, scene: &Scene, width: u32, height: u32) -> Self {
        let row = Row { camera: &scene.camera, y: 0, width, height };
        let half_rows = 0.5 * height as f32;
        let grid = grid(solid, solid.lathe(), &row, half_rows - 0.5, half_rows);
        let to_light = to_light(solid, &scene.light);
        let mirrored = if grid.is_mirrored { to_light.mirrored(grid.mirror()) } else { to_light };
        Self { grid, to_light, mirrored }
    }
}

/// The rays, at a sheet of a solid, of the rows up to `half_rows` above and below the row y, which may be a
/// fraction. The [bound](Row::origin_bound) of `row` must hold for the origins of all these rays.
// Without a hint: in a build for size flash contains it only once.
pub(super) const fn grid(solid: &Solid, lathe: &Lathe, row: &Row, y: f32, half_rows: f32) -> RayGrid {
    let (camera, half_columns) = (row.camera, 0.5 * row.width as f32);
    let Ray { origin, direction, unit } = ray(solid, row, half_columns - 0.5, y);
    lathe.grid(&CameraRays {
        eye: origin,
        forward: direction,
        right: solid.direction_into(camera.right),
        up: if half_rows > 0.0 { solid.direction_into(camera.up) } else { vector([0.0; 3]) },
        pitch: 2.0 / row.width as f32,
        unit,
        is_perspective: camera.is_perspective(),
        rough: row.origin_bound(),
        half_columns,
        half_rows,
    })
}

/// The ray of a column of row y of a picture in a solid's own space; both may be fractions. Not inline:
/// what the function computes would stay on the stack of its callers.
#[inline(never)]
pub(super) const fn ray(solid: &Solid, row: &Row, column: f32, y: f32) -> Ray {
    solid.ray_into(&row.ray(column, y))
}

/// The aspects of the first solids of a picture, as many as the arithmetic keeps. For a body it is the aspect
/// of its first sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aspects([Aspect; KEPT]);

impl Aspects {
    /// The aspects in a scene's picture of `width` columns and `height` rows.
    #[inline(always)]
    pub const fn of(scene: &Scene, width: u32, height: u32) -> Self {
        // All bits of `none` are zero: else flash would hold a copy of the array.
        let none = Aspect { grid: RayGrid::NONE, to_light: ToLight::NONE, mirrored: ToLight::NONE };
        let mut aspects = Self([none; KEPT]);
        let mut i = 0;
        while i < aspects.0.len() && i < scene.solids.len() {
            aspects.0[i] = Aspect::new(&scene.solids[i], scene, width, height);
            i += 1;
        }
        aspects
    }

    /// The aspect of the scene's solid with this index. `None` if it is not kept, or if the bounds of its
    /// rays are of no use for the picture as a whole; those of one row may still be.
    #[inline(always)]
    pub(super) fn get(&self, index: usize) -> Option<&Aspect> {
        self.0.get(index).filter(|aspect| aspect.grid.is_usable)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Aspects {
    fn format(&self, _: defmt::Formatter) {
        // The aspects follow from the scene, so that they are not written.
    }
}
