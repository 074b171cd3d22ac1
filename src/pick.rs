//! What lies under a point of a picture.

use crate::hit::Hit;
use crate::ray::Ray;
use crate::scene::Scene;

/// The solid that a ray hits first, and where it hits it.
///
/// Made by [`Scene::nearest`] and by [`Scene::pick`], where there is an example.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Pick {
    /// The index of the solid in [`Scene::solids`].
    pub solid: usize,
    /// The number of the solid's sheet, as [`Solid::sheets`](crate::Solid::sheets) lists them; 0 if it is no
    /// body.
    pub sheet: usize,
    /// Where the ray hits it. The point and the normal are [`Solid::surface`](crate::Solid::surface)'s.
    pub hit: Hit,
}

impl Scene<'_> {
    /// The solid that a ray of the world hits first beyond `t_min`, or `None` if it hits none: see
    /// [`Solid::nearest`](crate::Solid::nearest). Of two solids at the same distance it is the first in the
    /// slice.
    ///
    /// ```
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// static SCENE: Scene = Scene::new(
    ///     &[
    ///         Solid::new(&BALL, Rgb::WHITE).posed(valid!(Pose::new([0.0, 3.0, 0.0], Rotation::IDENTITY, 1.0))),
    ///         Solid::new(&BALL, Rgb::WHITE),
    ///     ],
    ///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let along_y = Ray::new([0.0, -5.0, 0.0], [0.0, 1.0, 0.0])?;
    /// let pick = SCENE.nearest(&along_y, 0.0).unwrap();
    /// assert_eq!((pick.solid, pick.sheet, pick.hit.t), (1, 0, 4.0));
    /// # Ok::<(), RayError>(())
    /// ```
    #[must_use]
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Pick> {
        let mut nearest: Option<Pick> = None;
        for (index, solid) in self.solids.iter().enumerate() {
            if let Some(hit) = solid.nearest(ray, t_min)
                && nearest.is_none_or(|nearest| hit.t < nearest.hit.t)
            {
                nearest = Some(Pick { solid: index, sheet: solid.sheet_number(&hit), hit });
            }
        }
        nearest
    }
}
