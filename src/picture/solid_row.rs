//! A solid along a row of pixels.

use crate::camera::{Projection, Row};
use crate::lathe::{RayRow, Seen, Stop, Sweep, Wall};
use crate::ray::Ray;
use crate::shade::Views;
use crate::solid::Solid;
use crate::solve::Newton;
use crate::vector::{F32x3, Vector, largest, vector};
use core::ptr;

/// A solid along a row of pixels.
pub(super) struct SolidRow<'a> {
    solid: &'a Solid<'a>,
    row: &'a Row<'a>,
    pub views: Views,
    sweep: Sweep<'a>,
}

impl<'a> SolidRow<'a> {
    /// The rays of the pixels from `start` to `end` of a row, at a solid.
    #[inline(never)]
    pub fn new(solid: &'a Solid<'a>, row: &'a Row<'a>, start: u32, end: u32) -> Self {
        let Ray { origin, direction, unit } = solid.ray_into(&row.ray(0));
        let (step, projection) = row.step();
        let (step, none) = (solid.direction_into(step), vector([0.0; 3]));
        let (origin_step, direction_step) = match projection {
            Projection::Perspective => (none, step),
            Projection::Orthographic => (step * unit, none),
        };
        let rays = RayRow { origin, origin_step, direction, direction_step };
        let sweep = solid.lathe().sweep(&rays, unit, row.camera.rough, row.width, (start, end));
        Self { solid, row, views: Views { first: direction, step: direction_step }, sweep }
    }

    /// Whether nothing of it is seen.
    pub fn is_culled(&self) -> bool {
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
    pub fn mirrored(&self, to_light: F32x3) -> Option<F32x3> {
        let across = self.sweep.mirror()?;
        Some(to_light - across * (2.0 * across.dot(to_light) / across.dot(across)))
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
        let hit = solid.lathe().nearest_by::<Newton>(&ray, 0.0)?;
        if ptr::eq(solid, self.solid) {
            self.sweep.found(&hit);
        }
        let gradient = solid.lathe().gradient_at(ray.point(hit.t), &hit);
        // Very flat or very tall profiles have gradients whose squares are not numbers.
        let side = if hit.enters { 1.0 } else { -1.0 };
        Some((hit.t, Seen::new(gradient * (side / largest(gradient)))))
    }
}
