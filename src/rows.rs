//! From a scene to rows of pixels: as many as the caller asks for, where the caller wants them. Nothing else
//! is kept.

use crate::camera::Row;
use crate::color::Paint;
use crate::lathe::{Seen, Stop};
use crate::scene::Scene;
use crate::solid::{Finish, Solid, SolidRow, Views};
use crate::vector::F32x3;
use core::num::NonZeroU32;

/// How many pixels are reckoned at once on the way to a display that lends no memory.
pub(crate) const RUN: usize = 40;

/// A scene as a picture of so many pixels: reckoned row by row, or pixel by pixel, when asked.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static SCENE: Scene = Scene::new(
///     &[Solid::new(&BALL, Rgb::WHITE)],
///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
/// );
///
/// let picture = SCENE.picture(240, 240);
/// let mut row = [Rgb565::default(); 240];
/// for y in 0..240 {
///     picture.row(y, &mut row);
///     // … hand the row to the display, by DMA for example.
/// }
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Picture<'a> {
    pub(crate) scene: &'a Scene<'a>,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Scene<'_> {
    /// The scene as a picture of so many pixels, none of them reckoned yet.
    pub const fn picture(&self, width: u32, height: u32) -> Picture<'_> {
        Picture { scene: self, width, height }
    }
}

impl Picture<'_> {
    /// How many pixels a row has.
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// How many rows there are.
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// The pixels of row y, counted from the top, into `row` from its start: as many as the picture is wide,
    /// or as `row` is long. A row below the last one goes on where the picture ends.
    pub fn row<C: Paint>(&self, y: u32, row: &mut [C]) {
        self.part_of_row(0, y, row);
    }

    /// The pixels of row y from column x on, into `part`: as many as the row still has, or as `part` is long.
    ///
    /// A long part is cheaper than as many short ones: neighbours share what they can. The picture is the same, but for
    /// pixels where rounding decides between two shades, or between the two sides of a crease. Seen from up to 200 sizes of the
    /// solids away those are fewer than one of 10 000 in `Rgb565` and one of 5 000 in `Rgb888`. From parts of a single pixel,
    /// more of which are cast as rays of their own, they are one of 1 000 at most.
    #[inline(never)]
    pub fn part_of_row<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let left = self.width.saturating_sub(x) as usize;
        let len = part.len().min(left);
        let Some(part) = part.get_mut(..len) else {
            return;
        };
        self.background(x, y, part);
        let row = Row { camera: &self.scene.camera, y, width: self.width, height: self.height };
        self.solids(&row, x, part);
    }

    /// The solids, the farthest first: each over those behind it. Of two as far away the first one goes first.
    fn solids<C: Paint>(&self, row: &Row, x: u32, part: &mut [C]) {
        let solids = self.scene.solids;
        let mut last = u64::MAX;
        for _ in 0..solids.len() {
            let mut next = 0;
            for (index, solid) in (0u32..).zip(solids) {
                let order = u64::from(row.camera.distance(solid)) << 32 | u64::from(!index);
                if order < last && order > next {
                    next = order;
                }
            }
            let Some(solid) = solids.get(!(next as u32) as usize) else {
                return;
            };
            self.solid(solid, (next >> 32) as u32, row, x, part);
            last = next;
        }
    }

    /// What there is before any solid is seen.
    #[inline(never)]
    fn background<C: Paint>(&self, x: u32, y: u32, part: &mut [C]) {
        let shades = self.scene.background.row(y, self.height).shades(C::SHADES).rounded();
        for (pixel, x) in part.iter_mut().zip(x..) {
            *pixel = C::shade(shades, x, y);
        }
    }

    /// A solid, over what is there.
    #[inline(never)]
    fn solid<C: Paint>(&self, solid: &Solid, distance: u32, row: &Row, x: u32, run: &mut [C]) {
        let mut along = solid.along(row, x, x + run.len() as u32);
        if along.is_far() {
            return;
        }
        let among = self.scene.among(solid, distance);
        if among.len() > 1 {
            along.share();
        }
        let finish = solid.finish::<C>(&self.scene.light);
        let mirrored = along.mirrored(finish.towards);
        let mut canvas = Canvas { finish, mirrored, x, y: row.y, run, among };
        canvas.outwards(&mut along);
        if along.turn() {
            canvas.outwards(&mut along);
        }
    }

    /// The pixels of a rectangle, row by row from its upper left corner, reckoned as they are asked for: a run at a
    /// time, as long as there is room for.
    pub(crate) fn pixels<'p, C: Paint>(
        &'p self,
        (x, y): (u32, u32),
        (width, height): (u32, u32),
        run: &'p mut [C],
    ) -> Option<Pixels<'p, C>> {
        Some(Pixels {
            picture: self,
            left: x,
            top: y,
            width: NonZeroU32::new(width)?,
            next: 0,
            end: width.checked_mul(height)?,
            room: NonZeroU32::new(u32::try_from(run.len()).unwrap_or(u32::MAX))?,
            run,
            run_at: 0,
            ready: 0,
        })
    }
}

/// Pixels that a solid is painted on, from column x of row y on.
struct Canvas<'a, C> {
    finish: Finish,
    /// If the left half sees the right one's mirror image: that of the light.
    mirrored: Option<F32x3>,
    x: u32,
    y: u32,
    run: &'a mut [C],
    /// The solid, or, if another may be nearer, all of them.
    among: &'a [Solid<'a>],
}

impl<C: Paint> Canvas<'_, C> {
    /// From the middle on outwards.
    #[inline(never)]
    fn outwards(&mut self, along: &mut SolidRow) {
        let (mut i, mut saw) = (0, false);
        while i < along.end() {
            if let Some(to) = along.followed(i) {
                let (next, stop) = if to > i { self.follow(along, i, to) } else { (i, Stop::End) };
                along.stopped(next, stop);
                (i, saw) = (next, false);
                continue;
            }
            if let Some(cap) = along.cap_ahead() {
                let next = self.cap(along, i, cap);
                if next > i {
                    i = next;
                    continue;
                }
            }
            // Beside a ray gone alone that met it a look would be in vain.
            if !saw && let Some(next) = along.look(i) {
                i = next;
                continue;
            }
            // The mirror image's own ray, too. This one goes last: where it meets the solid the next one's root is
            // looked for.
            let own = along.column(i);
            let mut column = if self.mirrored.is_some() { along.opposite(i) } else { own };
            loop {
                let seen = along.alone(column, self.among);
                saw = seen.is_some();
                if let Some(seen) = seen {
                    self.put(column, &seen, &along.views);
                }
                if column == own {
                    break;
                }
                column = own;
            }
            i += 1;
        }
    }

    /// What the rays from i on see that come in through a cap. The first that does not is the one returned.
    #[inline(never)]
    fn cap(&mut self, along: &SolidRow, i: u32, cap: f32) -> u32 {
        along.cap(i, cap, |i, seen| {
            if self.mirrored.is_some() {
                self.put(along.opposite(i), seen, &along.views);
            }
            self.put(along.column(i), seen, &along.views);
        })
    }

    /// What a column's ray sees.
    #[inline(never)]
    fn put(&mut self, column: u32, seen: &Seen, views: &Views) {
        let at = (column - self.x) as usize;
        if let Some(pixel) = self.run.get_mut(at) {
            *pixel =
                C::shade(self.finish.shades::<C>(column, seen, &self.finish.towards, views), column, self.y);
        }
    }

    /// What the rays from i up to `to` see that meet the root followed. Not in line: the registers that it keeps on the
    /// stack are not needed where rays go alone.
    #[inline(never)]
    fn follow(&mut self, along: &mut SolidRow, i: u32, to: u32) -> (u32, Stop) {
        let Self { x, y, ref finish, mirrored, ref mut run, .. } = *self;
        let mut at = (along.column(i) - x) as usize;
        let step = if along.is_turned() { usize::MAX } else { 1 };
        // A pixel and its mirror image, which is nowhere if there is none.
        let both = if mirrored.is_some() { run.len() - 1 } else { usize::MAX };
        let opposite = mirrored.unwrap_or(finish.towards);
        let wall = along.wall();
        along.follow(i, to, |place, views| {
            let seen = &wall.seen(place);
            let column = x + at as u32;
            if let Some(pixel) = run.get_mut(at) {
                *pixel = C::shade(finish.shades::<C>(column, seen, &finish.towards, views), column, y);
            }
            let at_opposite = both.wrapping_sub(at);
            if let Some(pixel) = run.get_mut(at_opposite) {
                *pixel =
                    C::shade(finish.shades::<C>(column, seen, &opposite, views), x + at_opposite as u32, y);
            }
            at = at.wrapping_add(step);
        })
    }
}

/// The pixels of a rectangle of a picture, in the order a display takes them. One run is kept; skipping costs
/// what one run costs.
pub(crate) struct Pixels<'a, C> {
    picture: &'a Picture<'a>,
    left: u32,
    top: u32,
    width: NonZeroU32,
    /// The number of the next pixel, row by row, and how many there are.
    next: u32,
    end: u32,
    /// Rows are cut in runs of so many pixels, from their left end on.
    room: NonZeroU32,
    run: &'a mut [C],
    /// The number of the pixel that the run begins with, and how many it has.
    run_at: u32,
    ready: u32,
}

impl<C: Paint> Pixels<'_, C> {
    /// The run that the next pixel is in.
    #[inline]
    fn reckon(&mut self) {
        let (row, column) = (self.next / self.width, self.next % self.width);
        let within = column % self.room;
        let begin = column - within;
        self.run_at = self.next - within;
        self.ready = self.room.get().min(self.width.get() - begin);
        if let Some(run) = self.run.get_mut(..self.ready as usize) {
            self.picture.part_of_row(self.left + begin, self.top + row, run);
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
        if self.next - self.run_at >= self.ready {
            self.reckon();
        }
        let pixel = self.run.get((self.next - self.run_at) as usize).copied();
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
