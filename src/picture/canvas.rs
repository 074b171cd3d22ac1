//! The pixels that one sheet of a solid is painted on.

use super::brush::Brush;
use super::depth::Depths;
use crate::arithmetic::Seen;
use crate::camera::Row;
use crate::color::Paint;
use crate::lathe::{Span, Sweep};
use crate::math::cold_path;
use core::ops::Range;
use core::slice;

/// A part of a row of pixels, on which solids are painted one after another.
pub(super) struct Part<'a, 'b, C> {
    pub row: &'a Row<'a>,
    /// The column of the first pixel.
    pub x: u32,
    /// The pixels, if every one of them that sees a solid shows it. Empty if distances decide which of them
    /// show it: then `depths` has the pixels.
    pub run: &'a mut [C],
    pub depths: Option<&'a mut Depths<'b, C>>,
}

impl<C> Part<'_, '_, C> {
    /// Its first column, and the one after its last.
    pub fn columns(&self) -> (u32, u32) {
        let len = self.depths.as_ref().map_or(self.run.len(), |depths| depths.run.len());
        (self.x, self.x + len as u32)
    }
}

/// The pixels of a [`Part`], and what colors a sheet of a solid on them.
pub(super) struct Canvas<'a, 'b, C> {
    pub brush: Brush<'a>,
    pub run: &'a mut [C],
    pub depths: Option<&'a mut Depths<'b, C>>,
}

impl<C: Paint> Canvas<'_, '_, C> {
    /// Paints the half of the row that is being swept, from the middle outwards. If the other half is its
    /// mirror image, this paints it as well.
    #[inline(always)]
    pub fn half_row(&mut self, sweep: &mut Sweep) {
        let mut i = 0;
        while i < sweep.len() {
            i = match sweep.next(i) {
                Span::Tracked { to } => self.tracked(sweep, i, to),
                Span::Flat { to } => self.flat(sweep, i, to),
                Span::Empty { to } => to,
                Span::Single => self.single(sweep, i),
            };
        }
    }

    /// Paints the pixels from the i-th on, to before `to`, as long as they see the tracked root, and their
    /// mirror images. Returns the first that does not see it, `to` at most.
    ///
    /// This function is not inlined: it saves many registers on the stack, and that memory should be free
    /// while single rays are cast.
    #[inline(never)]
    fn tracked(&mut self, sweep: &mut Sweep, i: u32, to: u32) -> u32 {
        let Self { brush, run, depths } = self;
        let mut at = (sweep.column(i) - brush.x) as usize;
        let onward = if sweep.is_reversed() { usize::MAX } else { 1 };
        // This minus the index of a pixel in `run` is the index of its mirror image. Without mirror images the
        // difference lies outside of `run`.
        let both = if brush.mirrored.is_some() { run.len().wrapping_sub(1) } else { usize::MAX };
        let mirrored = brush.mirrored.as_ref().unwrap_or(brush.to_light());
        sweep.track(i, to, |seen, s| {
            if let Some(pixel) = run.get_mut(at) {
                *pixel = brush.color(at, seen);
                let image = both.wrapping_sub(at);
                if let Some(pixel) = run.get_mut(image) {
                    *pixel = brush.image_color(image, at, seen, mirrored);
                }
            } else if let Some(depths) = depths {
                // The pixels are those of `depths`, and `run` is empty: so where no distances are compared, the
                // loop does not ask for them.
                cold_path();
                depths.both(brush, at, seen.pairs(), s.float());
            }
            at = at.wrapping_add(onward);
        })
    }

    /// Paints the pixels from the i-th on, to before `to`, as long as they see a cap or a ring, and their
    /// mirror images. Returns the first that does not see it, `to` at most.
    #[inline(never)]
    fn flat(&mut self, sweep: &Sweep, mut i: u32, to: u32) -> u32 {
        let (seen, start) = (&sweep.flat(), i);
        while i < to
            && let Some(s) = sweep.passes(i)
        {
            if self.depths.is_some() {
                let distance = sweep.scale().distance(s);
                if self.brush.mirrored.is_some() {
                    self.put(sweep.mirrored_column(i), seen, distance);
                }
                self.put(sweep.column(i), seen, distance);
            }
            i += 1;
        }
        if !sweep.is_reversed() {
            self.level(sweep.right_columns(start..i), seen);
        }
        if sweep.is_reversed() || self.brush.mirrored.is_some() {
            self.level(sweep.left_columns(start..i), seen);
        }
        i
    }

    /// Paints the pixels of some columns, which all see the same, if every pixel that sees the solid shows it.
    fn level(&mut self, columns: Range<u32>, seen: &Seen) {
        let Self { brush, run, .. } = self;
        let at = (columns.start - brush.x) as usize..(columns.end - brush.x) as usize;
        if let Some(pixels) = run.get_mut(at) {
            brush.level(pixels, columns.start, seen);
        }
    }

    /// Casts the i-th pixel's ray and its mirror image's, and paints what they see. Returns the next pixel.
    #[inline(always)]
    fn single(&mut self, sweep: &mut Sweep, i: u32) -> u32 {
        let own = sweep.column(i);
        let mut column = if self.brush.mirrored.is_some() { sweep.mirrored_column(i) } else { own };
        // The pixel's own ray is cast last, because the sweep goes on from the hit that is reported last.
        loop {
            if let Some((seen, t)) = self.brush.rays.cast(sweep, i, column) {
                self.put(column, &seen, -t);
            }
            if column == own {
                return i + 1;
            }
            column = own;
        }
    }

    /// Paints the pixel of a column, unless what was painted before hides the solid there. The pixel's ray
    /// sees the solid at `distance`, which only matters if there are `depths`. The light is not mirrored:
    /// `seen` is what this pixel sees, in whichever half of the row it lies.
    #[inline(never)]
    fn put(&mut self, column: u32, seen: &Seen, distance: f32) {
        let Self { brush, run, depths } = self;
        let at = (column - brush.x) as usize;
        let pixel = match depths {
            None => run.get_mut(at),
            Some(depths) => depths.shown(brush, at, distance),
        };
        if let Some(pixel) = pixel {
            brush.level(slice::from_mut(pixel), column, seen);
        }
    }
}
