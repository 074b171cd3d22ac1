//! The pixels that one sheet of a solid is painted on.

use super::brush::Brush;
use super::depth::Depths;
use crate::arithmetic::{Pair, Seen};
use crate::camera::Row;
use crate::color::Paint;
use crate::lathe::{Span, Sweep};
use crate::math::cold_path;
use core::mem;
use core::ops::Range;

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
            let (to, is_flat) = match sweep.next(i) {
                Span::Tracked { to } => (to, false),
                Span::Flat { to } => (to, true),
                Span::Empty { to } => {
                    i = to;
                    continue;
                }
                Span::Single => {
                    i = self.single(sweep, i);
                    continue;
                }
            };
            i = if self.brush.sees(sweep.enters()) {
                self.span(sweep, i, to, is_flat)
            } else {
                self.unseen(sweep, i, to, is_flat)
            };
        }
    }

    /// Paints a span of pixels that see a cap or a ring, if `is_flat`, or else the tracked root: see
    /// [`Canvas::flat`] and [`Canvas::tracked`].
    #[inline(always)]
    fn span(&mut self, sweep: &mut Sweep, i: u32, to: u32, is_flat: bool) -> u32 {
        if is_flat { self.flat(sweep, i, to) } else { self.tracked(sweep, i, to) }
    }

    /// Goes through a span as [`Canvas::span`] does, and returns the same, but paints no pixel: where the rays
    /// come to the sheet from the side that the solid never shows.
    #[cold]
    #[inline(never)]
    fn unseen(&mut self, sweep: &mut Sweep, i: u32, to: u32, is_flat: bool) -> u32 {
        // There are no pixels to paint.
        let run = mem::take(&mut self.run);
        let next = self.span(sweep, i, to, is_flat);
        self.run = run;
        next
    }

    /// Paints the pixels from the i-th on, to before `to`, as long as they see the tracked root, and their
    /// mirror images. Returns the first that does not see it, `to` at most.
    ///
    /// This function is not inlined: it saves many registers on the stack, and that memory should be free
    /// while single rays are cast.
    #[inline(never)]
    fn tracked(&mut self, sweep: &mut Sweep, i: u32, to: u32) -> u32 {
        let mut at = (sweep.column(i) - self.brush.x) as usize;
        let onward = if sweep.is_reversed() { usize::MAX } else { 1 };
        // The loop paints pixels that have no highlight, and of which no distances are compared: then it has
        // `run`. Where it has no pixels, it calls `other`.
        let is_plain = self.brush.is_matt();
        let run = if is_plain { mem::take(&mut self.run) } else { &mut [] };
        // This minus the index of a pixel in `run` is the index of its mirror image. Without mirror images
        // the difference lies outside of `run`.
        let both = if self.brush.is_mirrored { run.len().wrapping_sub(1) } else { usize::MAX };
        let other = match (&self.depths, self.brush.is_mirrored) {
            (Some(_), _) => Self::compared,
            (None, true) => Self::shiny_both,
            (None, false) => Self::shiny,
        };
        let next = sweep.track(i, to, |normal, s| {
            if let Some(pixel) = run.get_mut(at) {
                let (brush, seen) = (&self.brush, &normal.seen());
                *pixel = brush.matt(at, seen, brush.to_light());
                let image = both.wrapping_sub(at);
                if let Some(pixel) = run.get_mut(image) {
                    *pixel = brush.matt(image, seen, &brush.mirrored);
                }
            } else {
                cold_path();
                let [p, q] = normal.seen().pairs();
                other(self, at, p, q, s.float());
            }
            at = at.wrapping_add(onward);
        });
        if is_plain {
            self.run = run;
        }
        next
    }

    /// Paints the pixel `at` with its highlight. What it sees are the four numbers of a [`Seen`], as
    /// [`Seen::pairs`] returns them. The last argument is that of [`Canvas::compared`], and is not used.
    #[inline(never)]
    fn shiny(&mut self, at: usize, p: Pair, q: Pair, _: f32) {
        let Self { brush, run, .. } = self;
        if let Some(pixel) = run.get_mut(at) {
            *pixel = brush.shiny(at, at, p, q, brush.to_light());
        }
    }

    /// Does what [`Canvas::shiny`] does, for the pixel `at` and for its mirror image.
    #[inline(never)]
    fn shiny_both(&mut self, at: usize, p: Pair, q: Pair, s: f32) {
        self.shiny(at, p, q, s);
        let Self { brush, run, .. } = self;
        let image = run.len().wrapping_sub(at + 1);
        if let Some(pixel) = run.get_mut(image) {
            *pixel = brush.shiny(image, at, p, q, &brush.mirrored);
        }
    }

    /// Paints the pixel `at`, and its mirror image if there is one, each unless what was painted before hides
    /// the solid there. The pixel's ray meets the surface at s. What it sees is as in [`Canvas::shiny`].
    #[inline(never)]
    fn compared(&mut self, at: usize, p: Pair, q: Pair, s: f32) {
        let Self { brush, depths: Some(depths), .. } = self else { return };
        let (seen, distance) = (&Seen::of_pairs([p, q]), depths.scale.distance(s));
        if let Some(pixel) = depths.shown(brush, at, distance, false) {
            *pixel = brush.color(at, at, seen, brush.to_light());
        }
        if brush.is_mirrored {
            let image = depths.run.len().wrapping_sub(at + 1);
            if let Some(pixel) = depths.shown(brush, image, distance, false) {
                *pixel = brush.color(image, at, seen, &brush.mirrored);
            }
        }
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
                let [p, q] = seen.pairs();
                self.compared((sweep.column(i) - self.brush.x) as usize, p, q, s.float());
            }
            i += 1;
        }
        if !sweep.is_reversed() {
            self.level(sweep.right_columns(start..i), seen);
        }
        if sweep.is_reversed() || self.brush.is_mirrored {
            self.level(sweep.left_columns(start..i), seen);
        }
        i
    }

    /// Paints the pixels of some columns, which all see the same, if every pixel that sees the solid shows
    /// it.
    #[inline(never)]
    fn level(&mut self, columns: Range<u32>, seen: &Seen) {
        let Self { brush, run, .. } = self;
        let at = (columns.start - brush.x) as usize..(columns.end - brush.x) as usize;
        let Some(pixels) = run.get_mut(at.clone()) else { return };
        let is_matt = brush.is_matt();
        for (pixel, at) in pixels.iter_mut().zip(at) {
            *pixel = if is_matt {
                brush.matt(at, seen, brush.to_light())
            } else {
                let [p, q] = seen.pairs();
                brush.shiny(at, at, p, q, brush.to_light())
            };
        }
    }

    /// Casts the i-th pixel's ray and its mirror image's, and paints what they see. Returns the next pixel.
    #[inline(always)]
    fn single(&mut self, sweep: &mut Sweep, i: u32) -> u32 {
        let own = sweep.column(i);
        let mut column = if self.brush.is_mirrored { sweep.mirrored_column(i) } else { own };
        // The pixel's own ray is cast last, because the sweep goes on from the hit that is reported last.
        loop {
            if let Some((seen, t, enters)) = self.brush.rays.cast(sweep, i, column)
                && self.brush.sees(enters)
            {
                self.put(column, &seen, t);
            }
            if column == own {
                return i + 1;
            }
            column = own;
        }
    }

    /// Paints the pixel of a column, unless what was painted before hides the solid there. The pixel's ray
    /// sees the solid at the exact `distance`, which only matters if there are `depths`. The light is not
    /// mirrored: `seen` is what this pixel sees, in whichever half of the row it lies.
    #[inline(never)]
    fn put(&mut self, column: u32, seen: &Seen, distance: f32) {
        let Self { brush, run, depths } = self;
        let at = (column - brush.x) as usize;
        let pixel = match depths {
            None => run.get_mut(at),
            Some(depths) => depths.shown(brush, at, distance, true),
        };
        if let Some(pixel) = pixel {
            *pixel = brush.color(at, at, seen, brush.to_light());
        }
    }
}
