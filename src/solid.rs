//! A lathe in the world, with a colour.

use crate::color::Rgb;
use crate::hit::{Hit, Part};
use crate::lathe::{Glimpse, Lathe, Said, Sweep};
use crate::light::Light;
use crate::pose::Pose;
use crate::ray::{Ray, Rays};
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

    /// The solid as seen along the rays of neighbouring pixels: all brought into object space, once.
    pub(crate) fn seen_along(&self, rays: &Rays, len: usize, light: &Light) -> Seen<'a> {
        let (pose, back) = (&self.pose, |v| self.pose.rotation.back(v));
        let rays = Rays {
            origin: pose.point_into(rays.origin),
            origin_step: back(rays.origin_step) * (1.0 / pose.scale),
            direction: back(rays.direction),
            direction_step: back(rays.direction_step),
            unit: rays.unit / pose.scale,
        };
        Seen {
            solid: *self,
            rays,
            len,
            sweep: Sweep::new(self.lathe, &rays, len),
            stride: 8,
            has_hit: false,
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

/// A solid, some rays and the light, all in the solid's own space.
pub(crate) struct Seen<'a> {
    solid: Solid<'a>,
    rays: Rays,
    len: usize,
    sweep: Sweep<'a>,
    /// How many rays at once were passed over last: as many, or fewer, may be again.
    stride: usize,
    /// Whether the last ray has hit.
    has_hit: bool,
    light: Light,
}

impl Seen<'_> {
    /// The first ray from the i-th on that sees the solid nearer than `depths` has it, the distance, and the colour.
    #[inline(always)]
    pub fn next(&mut self, from: usize, depths: &[f32]) -> Option<(usize, f32, Rgb)> {
        let mut i = from;
        // If all of them miss, nothing else need be asked.
        if i == 0 && self.sweep.clears(0, self.len) {
            return None;
        }
        while i < self.len {
            let glimpse = match self.sweep.look(i as f32) {
                Said::Hit(glimpse) => Some(glimpse),
                Said::Unsure => {
                    let passed = self.pass(i);
                    if passed > i {
                        i = passed;
                        continue;
                    }
                    self.shoot(i)
                }
                Said::Miss(clear) => {
                    let stride = (clear as usize).min(self.len - i - 1);
                    if stride >= 4 && self.sweep.clears(i + 1, stride) {
                        i += stride;
                    }
                    None
                }
            };
            self.has_hit = glimpse.is_some();
            if let Some(Glimpse { t, gradient, enters }) = glimpse
                && t < *depths.get(i)?
            {
                return Some((i, t, self.colour(i, gradient, enters)));
            }
            i += 1;
        }
        None
    }

    /// Passes over rays that certainly miss.
    #[inline(never)]
    fn pass(&mut self, from: usize) -> usize {
        if self.has_hit {
            return from;
        }
        let mut i = from;
        while i < self.len {
            let stride = self.stride.min(self.len - i);
            if self.sweep.clears(i, stride) {
                i += stride;
                self.stride = 2 * stride;
            } else if stride < 4 {
                break;
            } else {
                self.stride = stride / 2;
            }
        }
        i
    }

    /// One ray by itself.
    fn shoot(&mut self, i: usize) -> Option<Glimpse> {
        let ray = self.rays.ray(i);
        let lathe = self.solid.lathe;
        let Some(hit) = lathe.nearest(&ray, 0.0) else {
            self.sweep.end();
            return None;
        };
        match hit.part {
            Part::Wall => self.sweep.begin(&hit),
            _ => self.sweep.end(),
        }
        Some(Glimpse { t: hit.t, gradient: lathe.gradient(ray.at(hit.t), &hit), enters: hit.enters })
    }

    /// The wall seen from within turns its other side.
    #[inline(always)]
    fn colour(&self, i: usize, gradient: F32x3, enters: bool) -> Rgb {
        let Solid { colour, shininess, .. } = self.solid;
        let normal = unit(gradient);
        let side = if enters { 1.0 } else { -1.0 };
        let nl = side * normal.dot(self.light.towards);
        if shininess == 0 {
            return self.light.shade(colour, 0, nl, 0.0, 0.0);
        }
        let view = unit(self.rays.ray(i).direction);
        let (nv, lv) = (-side * normal.dot(view), -self.light.towards.dot(view));
        self.light.shade(colour, shininess, nl, nv, lv)
    }
}
