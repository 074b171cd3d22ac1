//! The colors of one sheet of a solid on a part of a row of pixels.

use super::solid_row::SolidRays;
use crate::arithmetic::{Seen, ToLight};
use crate::color::Paint;
use crate::lathe::Sweep;
use crate::shade::Finish;

/// What colors a sheet of a solid on a part of a row. The part's pixels are numbered from its left end.
pub(super) struct Brush<'a> {
    pub rays: &'a SolidRays<'a>,
    finish: Finish,
    /// The mirror image of the direction to the light, if the left half of the row sees the mirror image of
    /// what the right half sees. Then a pixel of the left half gets the color that the pixel opposite, in the
    /// right half, would have in the mirrored light. `None` if each half is swept by itself.
    pub mirrored: Option<ToLight>,
    /// The column of the part's first pixel.
    pub x: u32,
}

impl<'a> Brush<'a> {
    /// The brush for a part that begins in column x, given the sheet's material, its rays and its
    /// sweep along the part.
    #[inline(always)]
    pub fn new(finish: Finish, rays: &'a SolidRays<'a>, sweep: &Sweep, x: u32) -> Self {
        let to_light = finish.to_light;
        let mirrored = sweep.mirror().map(|n| to_light.mirrored(n));
        Self { rays, finish, mirrored, x }
    }

    /// The direction to the light, in the solid's own space, not mirrored: [`Finish::to_light`].
    #[inline(always)]
    pub fn to_light(&self) -> &ToLight {
        &self.finish.to_light
    }

    /// The column of a pixel.
    #[inline(always)]
    pub fn column(&self, at: usize) -> u32 {
        self.x + at as u32
    }

    /// The color of the pixel `at`, which sees `seen`.
    #[inline(always)]
    pub fn color<C: Paint>(&self, at: usize, seen: &Seen) -> C {
        self.shade(at, at, seen, &self.finish.to_light)
    }

    /// The color of the pixel `image`, which sees the mirror image of `seen`, what the pixel `at` sees.
    /// `mirrored` is the brush's [`mirrored`](Brush::mirrored) direction; a brush without one has no mirror
    /// images, and the result is of no use.
    #[inline(always)]
    pub fn image_color<C: Paint>(&self, image: usize, at: usize, seen: &Seen, mirrored: &ToLight) -> C {
        self.shade(image, at, seen, mirrored)
    }

    /// Paints neighbouring pixels that all see the same `seen`; the first is in the given column.
    #[inline(never)]
    pub fn level<C: Paint>(&self, pixels: &mut [C], column: u32, seen: &Seen) {
        let at = (column - self.x) as usize;
        for (pixel, at) in pixels.iter_mut().zip(at..) {
            *pixel = self.color(at, seen);
        }
    }

    /// The color of the pixel `to`: that of what the pixel `at` sees in light from the direction `to_light`.
    #[inline(always)]
    fn shade<C: Paint>(&self, to: usize, at: usize, seen: &Seen, to_light: &ToLight) -> C {
        let shades = self.finish.shades::<C>(self.column(at), seen, to_light, &self.rays.views);
        C::shade(shades, self.column(to), self.rays.row.y)
    }
}
