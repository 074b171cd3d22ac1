//! The pixels that one solid is painted on.

use super::solid_row::SolidRow;
use crate::color::Paint;
use crate::lathe::{Seen, Stop};
use crate::shade::{Finish, Views};
use crate::solid::Solid;
use crate::vector::F32x3;

/// Pixels that a solid is painted on, from column x of row y on.
pub(super) struct Canvas<'a, C> {
    pub finish: Finish,
    /// If the left half sees the right one's mirror image: that of the light.
    pub mirrored: Option<F32x3>,
    pub x: u32,
    pub y: u32,
    pub run: &'a mut [C],
    /// The solid, or, if another may be nearer, all of them.
    pub candidates: &'a [Solid<'a>],
}

impl<C: Paint> Canvas<'_, C> {
    /// From the middle on outwards.
    #[inline(never)]
    pub fn outwards(&mut self, along: &mut SolidRow) {
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
                let seen = along.alone(column, self.candidates);
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
                C::shade(self.finish.shades::<C>(column, seen, &self.finish.to_light, views), column, self.y);
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
        let opposite = mirrored.unwrap_or(finish.to_light);
        let wall = along.wall();
        along.follow(i, to, |place, views| {
            let seen = &wall.seen(place);
            let column = x + at as u32;
            if let Some(pixel) = run.get_mut(at) {
                *pixel = C::shade(finish.shades::<C>(column, seen, &finish.to_light, views), column, y);
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
