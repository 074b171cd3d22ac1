//! The pixels that one solid is painted on.
//!
//! The type `D` decides which of the pixels that see the solid show it: all, or those where it is the
//! nearest.

use super::depth::{Depth, Distance};
use super::solid_row::SolidRow;
use crate::color::Paint;
use crate::lathe::{Seen, Span};
use crate::shade::Finish;
use crate::vector::{F32x3, Vector};

/// A part of a row of pixels, and what colors a solid on it.
pub(super) struct Canvas<'a, C, D> {
    finish: Finish,
    /// The mirror image of the direction to the light, if the left half of the row sees the mirror image of
    /// what the right half sees. Then a pixel of the left half gets the color that the pixel opposite, in the
    /// right half, would have in the mirrored light. `None` if each half is swept by itself.
    mirrored: Option<F32x3>,
    /// The column that `run` begins with, and the row.
    x: u32,
    y: u32,
    run: &'a mut [C],
    depth: &'a mut D,
}

impl<'a, C: Paint, D: Depth> Canvas<'a, C, D> {
    /// The pixels `run`, the first of which is in column x of row y, to paint a solid on: `finish` is its
    /// material, `along` the solid along these pixels.
    #[inline(always)]
    pub fn new(
        finish: Finish,
        along: &SolidRow,
        (x, y): (u32, u32),
        run: &'a mut [C],
        depth: &'a mut D,
    ) -> Self {
        let to_light = finish.to_light;
        let mirrored = along.sweep.mirror();
        let mirrored = mirrored.map(|n| to_light - n * (2.0 * n.dot(to_light) / n.dot(n)));
        Self { finish, mirrored, x, y, run, depth }
    }

    /// Paints the half of the row that is being swept, from the middle outwards. If the other half is its
    /// mirror image, this paints it as well.
    #[inline(never)]
    pub fn half_row(&mut self, along: &mut SolidRow) {
        let mut i = 0;
        while i < along.sweep.len() {
            i = match along.sweep.next(i) {
                Span::Tracked { to } => self.tracked(along, i, to),
                Span::Cap { to, up } => self.cap(along, i, to, up),
                Span::Empty { to } => to,
                Span::Single => self.single(along, i),
            };
        }
    }

    /// Paints the pixels from the i-th on, to before `to`, as long as they see the tracked root, and their
    /// mirror images. Returns the first that does not see it, `to` at most.
    ///
    /// This function is not inlined: it saves many registers on the stack, and while single rays are cast
    /// that memory is to be free.
    #[inline(never)]
    fn tracked(&mut self, along: &mut SolidRow, i: u32, to: u32) -> u32 {
        let Self { x, y, ref finish, mirrored, ref mut run, ref mut depth } = *self;
        let SolidRow { sweep, views, rays } = along;
        let scale = sweep.scale();
        let mut at = (sweep.column(i) - x) as usize;
        let step = if sweep.is_reversed() { usize::MAX } else { 1 };
        // The index in `run` of a pixel's mirror image is this less the pixel's own index. Without a mirror
        // image that difference lies outside of `run`.
        let both = if mirrored.is_some() { run.len() - 1 } else { usize::MAX };
        let mirrored = mirrored.unwrap_or(finish.to_light);
        sweep.track(i, to, |seen, s| {
            let column = x + at as u32;
            let distance = Distance::Swept(if D::COUNTS { scale.distance(s) } else { 0.0 });
            if let Some(pixel) = run.get_mut(at)
                && depth.shows(rays, at, column, distance)
            {
                *pixel = C::shade(finish.shades::<C>(column, seen, &finish.to_light, views), column, y);
            }
            let mirrored_at = both.wrapping_sub(at);
            if let Some(pixel) = run.get_mut(mirrored_at) {
                let image = x + mirrored_at as u32;
                if depth.shows(rays, mirrored_at, image, distance) {
                    *pixel = C::shade(finish.shades::<C>(column, seen, &mirrored, views), image, y);
                }
            }
            at = at.wrapping_add(step);
        })
    }

    /// Paints the pixels from the i-th to before `to`, and their mirror images, which all see the upper cap
    /// (`up` is 1) or the lower one (−1). Returns `to`.
    #[inline(never)]
    fn cap(&mut self, along: &SolidRow, i: u32, to: u32, up: f32) -> u32 {
        let seen = &Seen::cap(up);
        for i in i..to {
            let distance = Distance::Swept(if D::COUNTS { along.sweep.end_distance(i, up) } else { 0.0 });
            if self.mirrored.is_some() {
                self.put(along, along.sweep.mirrored_column(i), seen, distance);
            }
            self.put(along, along.sweep.column(i), seen, distance);
        }
        to
    }

    /// Casts the i-th pixel's ray and its mirror image's, and paints what they see. Returns the next pixel.
    #[inline(always)]
    fn single(&mut self, along: &mut SolidRow, i: u32) -> u32 {
        let own = along.sweep.column(i);
        let mut column = if self.mirrored.is_some() { along.sweep.mirrored_column(i) } else { own };
        // The pixel's own ray is cast last, because the sweep goes on from the hit that is reported last.
        loop {
            if let Some((seen, t)) = along.cast(i, column) {
                self.put(along, column, &seen, Distance::Cast(t));
            }
            if column == own {
                return i + 1;
            }
            column = own;
        }
    }

    /// Paints the pixel of a column, whose ray sees the solid at `distance`, unless what was painted before
    /// hides the solid there. The light is that of the scene, for pixels of either half.
    #[inline(never)]
    fn put(&mut self, along: &SolidRow, column: u32, seen: &Seen, distance: Distance) {
        let Self { x, y, ref finish, ref mut run, ref mut depth, .. } = *self;
        let at = (column - x) as usize;
        if let Some(pixel) = run.get_mut(at)
            && depth.shows(&along.rays, at, column, distance)
        {
            *pixel = C::shade(finish.shades::<C>(column, seen, &finish.to_light, &along.views), column, y);
        }
    }
}
