//! The colors of one sheet of a solid on a part of a row of pixels.

use super::solid_row::SolidRays;
use crate::arithmetic::{Pair, Seen, ToLight};
use crate::color::Paint;
use crate::shade::Finish;

/// What colors a sheet of a solid on a part of a row. The part's pixels are numbered from its left end.
pub(super) struct Brush<'a> {
    pub rays: &'a SolidRays<'a>,
    finish: Finish,
    /// Whether the left half of the row sees the mirror image of what the right half sees. Then a pixel of
    /// the left half gets the color that the pixel opposite, in the right half, would have in the mirrored
    /// light. If not, each half is swept by itself.
    pub is_mirrored: bool,
    /// The mirror image of the direction to the light, if `is_mirrored`.
    pub mirrored: ToLight,
    /// The column of the part's first pixel.
    pub x: u32,
    /// Whether the sheet is one of a *shell*, and no distances are compared: then the shell is seen from
    /// outside.
    is_shell: bool,
}

impl<'a> Brush<'a> {
    /// The brush for a part that begins in column x, given the sheet's material, its rays and, if the left
    /// half of the part is the mirror image of the right half, the mirrored light; and whether the sheet is
    /// one of a shell of which no distances are compared.
    #[inline(always)]
    pub fn new(
        finish: Finish,
        rays: &'a SolidRays<'a>,
        mirrored: Option<ToLight>,
        x: u32,
        is_shell: bool,
    ) -> Self {
        let (is_mirrored, mirrored) = (mirrored.is_some(), mirrored.unwrap_or(finish.to_light));
        Self { rays, finish, is_mirrored, mirrored, x, is_shell }
    }

    /// The direction to the light, in the solid's own space, not mirrored: [`Finish::to_light`].
    #[inline(always)]
    pub fn to_light(&self) -> &ToLight {
        &self.finish.to_light
    }

    /// Whether a pixel may show the sheet where its ray first meets it, and `enters` the lathe there, or
    /// leaves it: any such place, except one on a shell that the ray comes to from within the material.
    #[inline(always)]
    pub fn sees(&self, enters: bool) -> bool {
        !self.is_shell || enters != self.rays.sheet.is_inner()
    }

    /// The column of a pixel.
    #[inline(always)]
    pub fn column(&self, at: usize) -> u32 {
        self.x + at as u32
    }

    /// Whether no pixel has a highlight.
    #[inline(always)]
    pub fn is_matt(&self) -> bool {
        self.rays.solid.gloss().exponent == 0
    }

    /// The color, without a highlight, of the pixel `to`, which sees `seen` in light from the direction
    /// `to_light`.
    // Without a hint: in a build for size flash contains the function only once, and in a build for speed the
    // compiler inlines it.
    pub fn matt<C: Paint>(&self, to: usize, seen: &Seen, to_light: &ToLight) -> C {
        C::shade(self.finish.matt(seen, to_light), self.column(to), self.rays.row.y)
    }

    /// The color of the pixel `to`: that of what the pixel `at` sees in light from the direction `to_light`.
    // Without a hint: see `matt`.
    pub fn color<C: Paint>(&self, to: usize, at: usize, seen: &Seen, to_light: &ToLight) -> C {
        if self.is_matt() {
            self.matt(to, seen, to_light)
        } else {
            let [p, q] = seen.pairs();
            self.shiny(to, at, p, q, to_light)
        }
    }

    /// Does what [`Brush::color`] does, where there may be a highlight. What the pixel `at` sees are the four
    /// numbers of a [`Seen`], as [`Seen::pairs`] returns them.
    #[inline(never)]
    pub fn shiny<C: Paint>(&self, to: usize, at: usize, p: Pair, q: Pair, to_light: &ToLight) -> C {
        let shades = self.finish.shades::<C>(
            self.column(at),
            &Seen::of_pairs([p, q]),
            to_light,
            &self.rays.views,
            self.rays.solid.gloss(),
        );
        C::shade(shades, self.column(to), self.rays.row.y)
    }
}
