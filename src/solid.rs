//! A lathe in the world, with a colour.

use crate::camera::Row;
use crate::color::Rgb;
use crate::hit::Hit;
use crate::lathe::{Lathe, Look, Seen, Sweep};
use crate::light::Light;
use crate::math::{Math, Native};
use crate::pose::Pose;
use crate::ray::Ray;
use crate::rays::Rays;
use crate::solve::DefaultSolver;
use crate::surface::{Surface, unit};
use crate::vector::Vector;

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

    /// The solid as the pixels from `start` to `end` of a row see it.
    #[inline(always)]
    pub(crate) fn along<'s>(&'s self, row: &'s Row, light: &Light, start: u32, end: u32) -> SolidRow<'s> {
        let (pose, back) = (&self.pose, |v| self.pose.rotation.back(v));
        let (rays, per_scale) = (row.rays(), 1.0 / pose.scale);
        let own = Rays {
            origin: pose.point_into(rays.origin),
            origin_step: back(rays.origin_step) * per_scale,
            direction: back(rays.direction),
            direction_step: back(rays.direction_step),
        };
        SolidRow {
            solid: self,
            row,
            light: Light { towards: back(light.towards), ..*light },
            sweep: self.lathe.sweep(&own, per_scale, start, end),
        }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Solid<'_> {
    fn format(&self, f: defmt::Formatter) {
        defmt::write!(f, "Solid {{ pose: {}, colour: {} }}", self.pose, self.colour);
    }
}

/// A solid along a row of pixels, with the light in the solid's own space.
pub(crate) struct SolidRow<'a> {
    solid: &'a Solid<'a>,
    row: &'a Row<'a>,
    light: Light,
    sweep: Sweep<'a>,
}

impl SolidRow<'_> {
    /// What the i-th ray sees, or the next one to ask for: it again, or the first that may see something.
    #[inline(always)]
    pub fn see(&mut self, i: u32) -> Result<Seen, u32> {
        if let Some(seen) = self.sweep.follow(i) {
            return Ok(seen);
        }
        match self.look(i) {
            Look::Follow => Err(i),
            Look::Clear(next) => Err(next),
            Look::Unknown => self.alone(i).ok_or(i + 1),
        }
    }

    /// With nothing to follow, what is to be done. Apart, as `alone` is: their stacks are not both needed.
    #[inline(never)]
    fn look(&mut self, i: u32) -> Look {
        self.sweep.look(i)
    }

    /// What the i-th ray sees, found as that of any ray: what the sweep leaves in doubt is decided as
    /// everywhere.
    #[inline(never)]
    fn alone(&mut self, i: u32) -> Option<Seen> {
        let (ray, lathe) = (self.solid.ray_into(&self.row.ray(i)), self.solid.lathe);
        let hit = lathe.nearest_by::<DefaultSolver>(&ray, 0.0)?;
        self.sweep.found(&hit);
        let gradient = unit(lathe.gradient_at(ray.at(hit.t), &hit));
        Some(Seen { t: hit.t, gradient, sign: if hit.enters { 1.0 } else { -1.0 } })
    }

    /// The colour of what the i-th ray sees. The wall seen from within turns its other side.
    #[inline(always)]
    pub fn colour(&self, i: u32, seen: &Seen) -> Rgb {
        let Solid { pose, colour, shininess, .. } = self.solid;
        let Seen { gradient, sign, .. } = *seen;
        let per_length = sign / Native::sqrt(gradient.dot(gradient));
        let nl = per_length * gradient.dot(self.light.towards);
        if *shininess == 0 {
            return self.light.shade(*colour, 0, nl, 0.0, 0.0);
        }
        let view = unit(pose.rotation.back(self.row.ray(i).direction));
        let (nv, lv) = (-per_length * gradient.dot(view), -self.light.towards.dot(view));
        self.light.shade(*colour, *shininess, nl, nv, lv)
    }
}
