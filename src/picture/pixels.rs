//! The pixels of a rectangle of a picture, one after another, as a display's driver takes them.

use super::raster::Raster;
use crate::color::Paint;
use core::num::NonZeroU32;

/// An iterator over the pixels of a rectangle, row by row from its upper left corner.
///
/// It computes a run of pixels at a time, in memory that the caller lends. `nth` computes no run but that of
/// the pixel it returns.
pub(crate) struct Pixels<'a, C> {
    raster: &'a Raster<'a>,
    left: u32,
    top: u32,
    width: NonZeroU32,
    /// The number of the next pixel, counted row by row from 0, and the number of all pixels.
    next: u32,
    end: u32,
    /// The length of `run`. Rows are cut into runs of this length, from the rectangle's left edge on.
    capacity: NonZeroU32,
    run: &'a mut [C],
    /// The number of the pixel that `run` begins with, and how many pixels of `run` are computed.
    run_start: u32,
    ready: u32,
}

impl<'a, C: Paint> Pixels<'a, C> {
    /// The pixels of the rectangle whose upper left corner is column x of row y. `None` if the rectangle has
    /// no pixel, or 2³² and more, or if `run` is empty.
    pub fn new(
        raster: &'a Raster<'a>,
        (x, y): (u32, u32),
        (width, height): (u32, u32),
        run: &'a mut [C],
    ) -> Option<Self> {
        let end = width.checked_mul(height)?;
        let capacity = NonZeroU32::new(u32::try_from(run.len()).unwrap_or(u32::MAX))?;
        let width = NonZeroU32::new(width)?;
        Some(Self { raster, left: x, top: y, width, next: 0, end, capacity, run, run_start: 0, ready: 0 })
    }

    /// Computes the run that contains the next pixel.
    #[inline]
    fn compute_run(&mut self) {
        let (row, column) = (self.next / self.width, self.next % self.width);
        // One division less where `run` has a whole row.
        let within = if self.capacity >= self.width { column } else { column % self.capacity };
        let begin = column - within;
        self.run_start = self.next - within;
        self.ready = self.capacity.get().min(self.width.get() - begin);
        if let Some(run) = self.run.get_mut(..self.ready as usize) {
            self.raster.part_of_row(self.left + begin, self.top + row, run);
        }
    }
}

impl<C: Paint> Iterator for Pixels<'_, C> {
    type Item = C;

    #[inline]
    fn next(&mut self) -> Option<C> {
        if self.next >= self.end {
            return None;
        }
        if self.next - self.run_start >= self.ready {
            self.compute_run();
        }
        let pixel = self.run.get((self.next - self.run_start) as usize).copied();
        self.next += 1;
        pixel
    }

    fn nth(&mut self, n: usize) -> Option<C> {
        let n = u32::try_from(n).unwrap_or(u32::MAX);
        self.next = self.next.saturating_add(n).min(self.end);
        self.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.end - self.next) as usize;
        (left, Some(left))
    }
}

impl<C: Paint> ExactSizeIterator for Pixels<'_, C> {}
