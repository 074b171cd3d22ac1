//! A lathe in the world, with a colour.

use crate::color::Rgb;
use crate::hit::Hit;
use crate::lathe::Lathe;
use crate::light::Light;
use crate::pose::Pose;
use crate::ray::Ray;
use crate::surface::{Surface, unit};
use crate::vector::{F32x3, Vector};

/// A turned solid at its place in the world: what it is, where it is, what it looks like.
///
/// ```
/// use embedded_lathe::{Lathe, Pose, Profile, Rgb, Rotation, Segment, Solid, valid};
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static RED_BALL: Solid = Solid::new(&BALL, Rgb::new(0.9, 0.2, 0.1))
///     .posed(valid!(Pose::new([0.0, 0.0, 1.0], Rotation::IDENTITY, 0.5)))
///     .shiny(20);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Solid<'a> {
    lathe: &'a Lathe,
    pose: Pose,
    colour: Rgb,
    shininess: u8,
}

impl<'a> Solid<'a> {
    /// A matt solid in its own space.
    pub const fn new(lathe: &'a Lathe, colour: Rgb) -> Self {
        Self { lathe, pose: Pose::IDENTITY, colour, shininess: 0 }
    }

    /// The same in another pose.
    pub const fn posed(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// The same with a highlight: the exponent of Phong's model, wide at 5, narrow at 100. Zero is matt.
    pub const fn shiny(self, exponent: u8) -> Self {
        Self { shininess: exponent, ..self }
    }

    /// The nearest crossing of a ray of the world beyond `t_min`, as [`Lathe::nearest`].
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        self.lathe.nearest(&self.ray_into(ray), t_min)
    }

    /// Whether a ray of the world crosses the solid beyond `t_min`, as [`Lathe::is_hit`].
    pub fn is_hit(&self, ray: &Ray, t_min: f32) -> bool {
        self.lathe.is_hit(&self.ray_into(ray), t_min)
    }

    /// The point and the normal of a hit, in the world, as [`Lathe::surface`].
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let seen = self.lathe.surface(&self.ray_into(ray), hit);
        Surface { point: ray.at(hit.t), normal: self.pose.rotation.apply(seen.normal.to_array()) }
    }

    /// A ray of the world in object space, with the same t.
    fn ray_into(&self, ray: &Ray) -> Ray {
        Ray {
            origin: self.pose.point_into(ray.origin),
            direction: self.pose.rotation.back(ray.direction),
            unit: ray.unit / self.pose.scale,
        }
    }

    /// The solid as seen along rays that change evenly: the first and the change from one to the next,
    /// brought into object space once for all of them.
    pub(crate) fn seen_along(&self, rays: &Rays, light: &Light) -> Seen<'_> {
        let (pose, back) = (&self.pose, |v| self.pose.rotation.back(v));
        Seen {
            solid: self,
            rays: Rays {
                origin: pose.point_into(rays.origin),
                origin_step: back(rays.origin_step) * (1.0 / pose.scale),
                direction: back(rays.direction),
                direction_step: back(rays.direction_step),
            },
            unit: 1.0 / pose.scale,
            light: Light { towards: back(light.towards), ..*light },
        }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Solid<'_> {
    fn format(&self, f: defmt::Formatter) {
        defmt::write!(f, "Solid {{ pose: {}, colour: {} }}", self.pose, self.colour);
    }
}

/// The rays of neighbouring pixels: origin and direction are linear in the pixel's number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    pub origin: F32x3,
    pub origin_step: F32x3,
    pub direction: F32x3,
    pub direction_step: F32x3,
}

/// A solid, some rays and the light, all in the solid's own space.
pub(crate) struct Seen<'a> {
    solid: &'a Solid<'a>,
    rays: Rays,
    unit: f32,
    light: Light,
}

impl Seen<'_> {
    /// The distance and the colour of what the i-th ray sees of the solid, nearer than `nearest`.
    #[inline(always)]
    pub fn pixel(&self, i: u32, nearest: f32) -> Option<(f32, Rgb)> {
        let i = i as f32;
        let ray = Ray {
            origin: self.rays.origin + self.rays.origin_step * i,
            direction: self.rays.direction + self.rays.direction_step * i,
            unit: self.unit,
        };
        let lathe = self.solid.lathe;
        let hit = lathe.nearest(&ray, 0.0)?;
        (hit.t < nearest).then(|| (hit.t, self.colour(&ray, &hit)))
    }

    /// The wall seen from within turns its other side.
    #[inline(always)]
    fn colour(&self, ray: &Ray, hit: &Hit) -> Rgb {
        let Solid { lathe, colour, shininess, .. } = *self.solid;
        let normal = unit(lathe.gradient(ray.at(hit.t), hit));
        let side = if hit.enters { 1.0 } else { -1.0 };
        let nl = side * normal.dot(self.light.towards);
        if shininess == 0 {
            return self.light.shade(colour, 0, nl, 0.0, 0.0);
        }
        let view = unit(ray.direction);
        let (nv, lv) = (-side * normal.dot(view), -self.light.towards.dot(view));
        self.light.shade(colour, shininess, nl, nv, lv)
    }
}
