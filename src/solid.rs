//! A lathe with a place in the world and a color.

use crate::color::Rgb;
use crate::hit::Hit;
use crate::lathe::Lathe;
use crate::pose::Pose;
use crate::ray::{Ray, RayError};
use crate::surface::Surface;
use crate::vector::{F32x3, array, difference, one_norm, scale, sum};

/// A turned solid in the world: its shape, its pose, its color and how shiny it is.
///
/// ```
/// use embedded_lathe::{Lathe, Pose, Profile, Rgb, Rotation, Segment, Solid, valid};
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static RED_BALL: Solid = Solid::new(&BALL, Rgb::new(0.9, 0.2, 0.1))
///     .posed(valid!(Pose::new([0.0, 0.0, 1.0], Rotation::IDENTITY, 0.5)))
///     .shiny(20);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid<'a> {
    lathe: &'a Lathe,
    pose: Pose,
    color: Rgb,
    shininess: u8,
}

impl<'a> Solid<'a> {
    /// A matt solid in the pose [`Pose::IDENTITY`].
    #[must_use]
    pub const fn new(lathe: &'a Lathe, color: Rgb) -> Self {
        Self { lathe, pose: Pose::IDENTITY, color, shininess: 0 }
    }

    /// This solid in another pose.
    #[must_use]
    pub const fn posed(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// This solid in another color.
    #[must_use]
    pub const fn colored(self, color: Rgb) -> Self {
        Self { color, ..self }
    }

    /// This solid with a highlight, given the exponent of Phong's model: the highlight is wide at 5, narrow
    /// at 100. Zero is matt.
    #[must_use]
    pub const fn shiny(self, exponent: u8) -> Self {
        Self { shininess: exponent, ..self }
    }

    /// Its shape.
    #[must_use]
    pub const fn lathe(&self) -> &'a Lathe {
        self.lathe
    }

    /// Its position, rotation and scale.
    #[must_use]
    pub const fn pose(&self) -> Pose {
        self.pose
    }

    /// Its color.
    #[must_use]
    pub const fn color(&self) -> Rgb {
        self.color
    }

    /// The exponent of its highlight, or zero if it is matt.
    #[must_use]
    pub const fn shininess(&self) -> u8 {
        self.shininess
    }

    /// The nearest crossing of a ray of the world beyond `t_min`, as [`Lathe::nearest`].
    #[must_use]
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        self.lathe.nearest(&self.ray_into(ray), t_min)
    }

    /// Whether a ray of the world crosses the solid beyond `t_min`, as [`Lathe::is_hit`].
    #[must_use]
    pub fn is_hit(&self, ray: &Ray, t_min: f32) -> bool {
        self.lathe.is_hit(&self.ray_into(ray), t_min)
    }

    /// The point and the normal of a hit, in the world, as [`Lathe::surface`].
    #[must_use]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let normal = self.lathe.normal(&self.ray_into(ray), hit);
        Surface { point: ray.at(hit.t), normal: array(self.pose.rotation.turn(normal)) }
    }

    /// A ray of the world that goes on from a hit of this solid, as [`Lathe::spawn`]. The offset is
    /// `16·2⁻²⁴·(4·R + distance + |origin| + |point|)`, all measured in the world. R is the radius of the
    /// smallest ball around the solid, and `|origin|` and `|point|` are the sums of the coordinates of the
    /// ray's origin and of the hit. `distance` is the same sum for the vector from the pose's position to the
    /// ray's origin, plus the distance of the position from the middle of the solid's axis.
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Pose, Profile, Ray, Rgb, Rotation, Segment, Solid, valid};
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0))); let at = |x|
    /// Pose::new([x, 0.0, 0.0], Rotation::IDENTITY, 1.0).map(|pose| Solid::new(&BALL,
    /// Rgb::WHITE).posed(pose)); let solids = [at(0.0)?, at(3.0)?];
    ///
    /// let ray = Ray::new([0.9, -4.0, 0.0], [0.0, 1.0, 0.0])?;
    /// let hit = solids[0].nearest(&ray, 0.0).unwrap();
    /// let to_light = solids[0].spawn(&ray, &hit, [1.0, 0.0, 0.0])?;
    /// assert!(solids.iter().any(|solid| solid.is_hit(&to_light, 0.0))); // in the second one's shadow
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Ray::new`]: for `direction`, and for a starting point beyond f32's range.
    pub fn spawn(&self, ray: &Ray, hit: &Hit, direction: [f32; 3]) -> Result<Ray, RayError> {
        let Pose { position, scale, .. } = self.pose;
        let own = scale * (4.0 * self.lathe.ball() + self.lathe.middle().abs());
        let lengths = own + one_norm(difference(ray.origin, position)) + one_norm(ray.origin);
        self.surface(ray, hit).spawn(direction, lengths)
    }

    /// A ray of the world in object space, with the same t.
    #[inline]
    pub(crate) fn ray_into(&self, ray: &Ray) -> Ray {
        Ray {
            origin: self.pose.point_into(ray.origin),
            direction: self.direction_into(ray.direction),
            unit: ray.unit / self.pose.scale,
        }
    }

    /// A direction of the world in object space. Its length does not change.
    #[inline(always)]
    pub(crate) const fn direction_into(&self, direction: F32x3) -> F32x3 {
        self.pose.rotation.back(direction)
    }

    /// The point of the world where object space has its origin.
    pub(crate) const fn position(&self) -> F32x3 {
        self.pose.position
    }

    /// The vector from a point to the center of the cylinder around the solid, in the world.
    pub(crate) const fn center_from(&self, point: F32x3) -> F32x3 {
        // The positions are subtracted first: if the smaller vector were added to a large position before, it
        // would be lost to rounding.
        let to_position = difference(self.pose.position, point);
        sum(to_position, scale(self.axis(), self.lathe.middle() * self.pose.scale))
    }

    /// The unit vector along the solid's axis, in the world.
    pub(crate) const fn axis(&self) -> F32x3 {
        self.pose.rotation.axis()
    }

    /// Half the height of the cylinder around the solid, in the world.
    pub(crate) const fn half_height(&self) -> f32 {
        self.lathe.half_height() * self.pose.scale
    }

    /// The radius of the cylinder around the solid, in the world. Infinite if the squash k is zero: then the
    /// solid is endless along x.
    pub(crate) const fn radius(&self) -> f32 {
        self.lathe.radius() * self.pose.scale
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Solid<'_> {
    fn format(&self, f: defmt::Formatter) {
        let Self { pose, color, shininess, .. } = self;
        defmt::write!(f, "Solid {{ pose: {}, color: {}, shininess: {} }}", pose, color, shininess);
    }
}
