//! A lathe in the world, with a color.

use crate::camera::{Projection, Row};
use crate::color::{Paint, Rgb, Shades, Share};
use crate::hit::Hit;
use crate::lathe::{Lathe, RayRow, Seen, Stop, Sweep, Wall};
use crate::light::Light;
use crate::math::rsqrt;
use crate::pose::Pose;
use crate::ray::{Ray, RayError};
use crate::solve::Newton;
use crate::surface::Surface;
use crate::vector::{F32x3, Vector, array, difference, largest, one_norm, vector};
use core::ptr;

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid<'a> {
    lathe: &'a Lathe,
    pose: Pose,
    color: Rgb,
    shininess: u8,
}

impl<'a> Solid<'a> {
    /// A matt solid in its own space.
    pub const fn new(lathe: &'a Lathe, color: Rgb) -> Self {
        Self { lathe, pose: Pose::IDENTITY, color, shininess: 0 }
    }

    /// The same in another pose.
    #[must_use]
    pub const fn posed(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// The same in another color.
    #[must_use]
    pub const fn colored(self, color: Rgb) -> Self {
        Self { color, ..self }
    }

    /// The same with a highlight: the exponent of Phong's model, wide at 5, narrow at 100. Zero is matt.
    #[must_use]
    pub const fn shiny(self, exponent: u8) -> Self {
        Self { shininess: exponent, ..self }
    }

    /// What is turned.
    #[must_use]
    pub const fn lathe(&self) -> &'a Lathe {
        self.lathe
    }

    /// Where it stands, how it is turned, and how large it is.
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
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        self.lathe.nearest(&self.ray_into(ray), t_min)
    }

    /// Whether a ray of the world crosses the solid beyond `t_min`, as [`Lathe::is_hit`].
    pub fn is_hit(&self, ray: &Ray, t_min: f32) -> bool {
        self.lathe.is_hit(&self.ray_into(ray), t_min)
    }

    /// The point and the normal of a hit, in the world, as [`Lathe::surface`].
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let normal = self.lathe.normal(&self.ray_into(ray), hit);
        Surface { point: ray.at(hit.t), normal: array(self.pose.rotation.turn(normal)) }
    }

    /// A ray of the world that goes on from a hit of this solid, as [`Lathe::spawn`]: the offset is
    /// `16·2⁻²⁴·(4·R + distance + |origin| + |point|)`, all in the world, `distance` to where the solid's own space has its
    /// origin, plus its middle's height in there.
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Pose, Profile, Ray, Rgb, Rotation, Segment, Solid, valid};
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// let at = |x| Pose::new([x, 0.0, 0.0], Rotation::IDENTITY, 1.0).map(|pose| Solid::new(&BALL, Rgb::WHITE).posed(pose));
    /// let solids = [at(0.0)?, at(3.0)?];
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
    /// As [`Ray::new`]: of the direction, and of a place beyond f32's range.
    pub fn spawn(&self, ray: &Ray, hit: &Hit, direction: [f32; 3]) -> Result<Ray, RayError> {
        let Pose { position, scale, .. } = self.pose;
        let own = scale * (4.0 * self.lathe.ball() + self.lathe.middle().abs());
        let lengths = own + one_norm(difference(ray.origin, position)) + one_norm(ray.origin);
        self.surface(ray, hit).spawn(direction, lengths)
    }

    /// A ray of the world in object space, with the same t.
    #[inline]
    fn ray_into(&self, ray: &Ray) -> Ray {
        Ray {
            origin: self.pose.point_into(ray.origin),
            direction: self.pose.rotation.back(ray.direction),
            unit: ray.unit / self.pose.scale,
        }
    }

    /// Where its own space has its origin.
    pub(crate) fn position(&self) -> F32x3 {
        self.pose.position
    }

    /// From a point to its centre. Positions first: beside a large one rounding would hide the rest.
    pub(crate) fn centre_from(&self, point: F32x3) -> F32x3 {
        self.pose.position - point + self.axis() * (self.lathe.middle() * self.pose.scale)
    }

    /// The direction of its axis, of unit length.
    pub(crate) fn axis(&self) -> F32x3 {
        self.pose.rotation.axis()
    }

    /// Half the height of the cylinder around it, in the world.
    pub(crate) fn half_height(&self) -> f32 {
        self.lathe.half_height() * self.pose.scale
    }

    /// The radius of that, infinite around a sheet.
    pub(crate) fn radius(&self) -> f32 {
        self.lathe.radius() * self.pose.scale
    }

    /// The solid as the pixels from `start` to `end` of a row see it.
    #[inline(never)]
    pub(crate) fn along<'s>(&'s self, row: &'s Row, start: u32, end: u32) -> SolidRow<'s> {
        let Ray { origin, direction, unit } = self.ray_into(&row.ray(0));
        let (step, projection) = row.step();
        let (step, none) = (self.pose.rotation.back(step), vector([0.0; 3]));
        let (origin_step, direction_step) = match projection {
            Projection::Perspective => (none, step),
            Projection::Orthographic => (step * unit, none),
        };
        let rays = RayRow { origin, origin_step, direction, direction_step };
        let sweep = self.lathe.sweep(&rays, unit, row.camera.rough, row.width, (start, end));
        SolidRow { solid: self, row, views: Views { first: direction, step: direction_step }, sweep }
    }

    /// How its surface looks in that light, in colors C.
    #[inline(always)]
    pub(crate) fn finish<C: Paint>(&self, light: &Light) -> Finish {
        let color = self.color.shades(C::SHADES);
        let ambient = color.dimmed(Share::of_one(light.ambient));
        Finish {
            shininess: self.shininess,
            towards: self.pose.rotation.back(light.towards) * Share::UNITS,
            ambient: ambient.rounded(),
            direct: color.without(ambient),
        }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Solid<'_> {
    fn format(&self, f: defmt::Formatter) {
        let Self { pose, color, shininess, .. } = self;
        defmt::write!(f, "Solid {{ pose: {}, color: {}, shininess: {} }}", pose, color, shininess);
    }
}

/// A solid along a row of pixels.
pub(crate) struct SolidRow<'a> {
    solid: &'a Solid<'a>,
    row: &'a Row<'a>,
    pub views: Views,
    sweep: Sweep<'a>,
}

/// The directions of a row's rays, in a solid's own space: that of column 0, and by how much the next one's
/// differs.
#[derive(Clone, Copy)]
pub(crate) struct Views {
    first: F32x3,
    step: F32x3,
}

impl SolidRow<'_> {
    /// Whether nothing of it is seen.
    pub fn is_far(&self) -> bool {
        self.sweep.is_far
    }

    /// Another solid may be nearer.
    pub fn share(&mut self) {
        self.sweep.share();
    }

    /// How many pixels there are: from the middle of what is seen to the right, or, turned, to the left.
    pub fn end(&self) -> u32 {
        self.sweep.end
    }

    /// Goes on with the left half, if that is not seen yet.
    pub fn turn(&mut self) -> bool {
        self.sweep.turn()
    }

    /// Whether pixels are counted to the left.
    pub fn is_turned(&self) -> bool {
        self.sweep.is_turned
    }

    /// The column of the i-th pixel.
    #[inline(always)]
    pub fn column(&self, i: u32) -> u32 {
        let middle = self.sweep.middle;
        if self.sweep.is_turned { middle - 1 - i } else { middle + i }
    }

    /// The column of the i-th pixel's mirror image.
    pub fn opposite(&self, i: u32) -> u32 {
        self.sweep.middle - 1 - i
    }

    /// The mirror image of the light's direction, if the left half is the right one's: what it sees looks as what the
    /// right one sees does in that light.
    pub fn mirrored(&self, towards: F32x3) -> Option<F32x3> {
        let across = self.sweep.mirror()?;
        Some(towards - across * (2.0 * across.dot(towards) / across.dot(across)))
    }

    /// The pixel as far as which the root, if there is one, can be followed from the i-th.
    #[inline(always)]
    pub fn followed(&self, i: u32) -> Option<u32> {
        self.sweep.followed(i)
    }

    /// As [`Sweep::wall`].
    #[inline(always)]
    pub fn wall(&self) -> Wall {
        self.sweep.wall()
    }

    /// Follows it from the i-th pixel up to another. The first pixel that it is not certain of, if any, is the one
    /// returned.
    #[inline(always)]
    pub fn follow(&mut self, i: u32, to: u32, mut see: impl FnMut(F32x3, &Views)) -> (u32, Stop) {
        let Self { views, sweep, .. } = self;
        sweep.follow(i, to, |at| see(at, views))
    }

    /// The root was followed up to the i-th pixel, and why no farther: there may be another way to go on.
    pub fn stopped(&mut self, i: u32, stop: Stop) {
        self.sweep.stopped(i, stop);
    }

    /// As [`Sweep::cap_ahead`].
    #[inline(always)]
    pub fn cap_ahead(&self) -> Option<f32> {
        self.sweep.cap_ahead()
    }

    /// As [`Sweep::cap`].
    #[inline(always)]
    pub fn cap(&self, i: u32, cap: f32, see: impl FnMut(u32, &Seen)) -> u32 {
        self.sweep.cap(i, cap, see)
    }

    /// As [`Sweep::look`]. Apart, as `alone` is: their stacks are not both needed.
    #[inline(never)]
    pub fn look(&mut self, i: u32) -> Option<u32> {
        self.sweep.look(i)
    }

    /// What a column's ray sees of this solid, if it is the first of the nearest of these.
    #[inline(never)]
    pub fn alone(&mut self, column: u32, solids: &[Solid]) -> Option<Seen> {
        let (mut nearest, mut seen_of_this) = (f32::INFINITY, None);
        for solid in solids {
            if let Some((t, seen)) = self.met(solid, column)
                && t < nearest
            {
                nearest = t;
                seen_of_this = ptr::eq(solid, self.solid).then_some(seen);
            }
        }
        seen_of_this
    }

    /// How far along a column's ray it meets a solid, and what it sees of it, found by a walk along it: what a sweep
    /// leaves in doubt is decided as what a glance leaves.
    #[inline(never)]
    fn met(&mut self, solid: &Solid, column: u32) -> Option<(f32, Seen)> {
        let ray = solid.ray_into(&self.row.ray(column));
        let hit = solid.lathe.nearest_by::<Newton>(&ray, 0.0)?;
        if ptr::eq(solid, self.solid) {
            self.sweep.found(&hit);
        }
        let gradient = solid.lathe.gradient_at(ray.point(hit.t), &hit);
        // Very flat or very tall profiles have gradients whose squares are not numbers.
        let side = if hit.enters { 1.0 } else { -1.0 };
        Some((hit.t, Seen::new(gradient * (side / largest(gradient)))))
    }
}

/// How a solid's surface looks along a row.
pub(crate) struct Finish {
    shininess: u8,
    /// Towards the light, in the solid's own space: as long as a share of 1 has units.
    pub towards: F32x3,
    /// What is seen in the shade, in shades and half of one, and what the light adds where it falls straight.
    ambient: Shades,
    direct: Shades,
}

impl Finish {
    /// The color of what a column's ray sees, in shades, in light from there.
    // Not always in line: where flash counts, it stands once. Where speed does, the record of instructions tells if the
    // compiler decides otherwise.
    #[inline]
    pub fn shades<C: Paint>(&self, column: u32, seen: &Seen, towards: &F32x3, views: &Views) -> Shades {
        let matt = self.matt(Share::new(seen.light(towards)));
        if self.is_matt() {
            return matt;
        }
        let full = const { Shades::of(C::SHADES) };
        let share = self.gloss(seen.gradient * seen.per_length, towards, views, column);
        matt.with_up_to(full.dimmed(share), const { Shades::of(C::SHADES).rounded() })
    }

    /// Whether there is no highlight.
    #[inline(always)]
    pub fn is_matt(&self) -> bool {
        self.shininess == 0
    }

    /// The color without a highlight, in shades, where such a share of the light falls.
    #[inline(always)]
    pub fn matt(&self, share: Share) -> Shades {
        self.ambient.with(self.direct.dimmed(share))
    }

    /// The share of white that a column's ray sees, given the normal and the light.
    #[cold]
    fn gloss(&self, normal: F32x3, towards: &F32x3, views: &Views, column: u32) -> Share {
        let view = views.first + views.step * column as f32;
        let nl = normal.dot(*towards);
        // r·v, r the light's direction mirrored and v against the view.
        let mirrored = towards.dot(view) - 2.0 * nl * normal.dot(view);
        let mirrored = mirrored * (rsqrt(view.dot(view)) * (1.0 / Share::UNITS));
        Share::of_one(Light::highlight(self.shininess, nl, mirrored))
    }
}
