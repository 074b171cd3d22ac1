//! Matt pixels where registers hold several numbers: what they see is gathered first, and then lit and colored several at
//! a time, by the same operations as one by one.

use super::Canvas;
use crate::color::{Paint, Share};
use crate::lathe::{FRESH, Seen, Stop, Wall};
use crate::solid::{Finish, SolidRow};
use crate::vector::{F32x3, vector};

/// Whether they do.
pub(super) const IS_WIDE: bool = cfg!(any(target_feature = "sse2", target_feature = "neon"));

/// How many are gathered at most: as many as are followed in one go.
const ROOM: usize = FRESH as usize;

/// What pixels see that follow one another, component by component.
struct Gathered {
    x: [f32; ROOM],
    y: [f32; ROOM],
    z: [f32; ROOM],
    per_length: [f32; ROOM],
}

impl Gathered {
    const NONE: Self = Self { x: [0.0; ROOM], y: [0.0; ROOM], z: [0.0; ROOM], per_length: [0.0; ROOM] };

    /// The n-th one's place on the wall, if there is room.
    #[inline(always)]
    fn put(&mut self, n: usize, place: F32x3) {
        if n < ROOM {
            (self.x[n], self.y[n], self.z[n]) = (place.x, place.y, place.z);
        }
    }

    /// In place of so many places, or a few more, what is seen there.
    #[inline(always)]
    fn see(&mut self, len: usize, wall: &Wall) {
        let Self { x, y, z, per_length } = self;
        let places = x.iter_mut().zip(y).zip(z).zip(per_length);
        // Where four are reckoned at once, none is left over.
        for (((x, y), z), per_length) in places.take(len.next_multiple_of(4)) {
            let seen = wall.seen(vector([*x, *y, *z]));
            (F32x3 { x: *x, y: *y, z: *z }, *per_length) = (seen.gradient, seen.per_length);
        }
    }

    /// What was seen, and a few more.
    fn seen(&self) -> impl Iterator<Item = Seen> {
        let Self { x, y, z, per_length } = self;
        let seen = x.iter().zip(y).zip(z).zip(per_length);
        seen.map(|(((&x, &y), &z), &per_length)| Seen { gradient: vector([x, y, z]), per_length })
    }

    /// What they see, in light from there, on pixels of row y that begin in column x: in that order, or, to the left, from
    /// the last one on.
    #[inline(never)]
    fn paint<C: Paint>(
        &self,
        finish: &Finish,
        towards: &F32x3,
        to_left: bool,
        pixels: &mut [C],
        (x, y): (u32, u32),
    ) {
        let color = |seen: Seen, column| C::shade(finish.matt(Share::wide(seen.light(towards))), column, y);
        let end = x + pixels.len() as u32;
        if to_left {
            for ((pixel, seen), n) in pixels.iter_mut().rev().zip(self.seen()).zip(1..) {
                *pixel = color(seen, end - n);
            }
        } else {
            for ((pixel, seen), n) in pixels.iter_mut().zip(self.seen()).zip(0..) {
                *pixel = color(seen, x + n);
            }
        }
    }
}

impl<C: Paint> Canvas<'_, C> {
    /// As `follow_each`, if the solid is matt.
    #[inline(never)]
    pub(super) fn follow_several(&mut self, along: &mut SolidRow, i: u32, to: u32) -> (u32, Stop) {
        let mut gathered = Gathered::NONE;
        let wall = along.wall();
        let mut n = 0;
        let (next, stop) = along.follow(i, to, |place, _| {
            gathered.put(n, place);
            n += 1;
        });
        let len = (next - i) as usize;
        gathered.see(len, &wall);
        let Self { x, y, ref finish, mirrored, ref mut run, .. } = *self;
        let at = (along.column(i) - x) as usize;
        let opposite = run.len() - 1 - at;
        let mut paint = |towards: &F32x3, to_left: bool, first: usize| {
            let begin = if to_left { first + 1 - len } else { first };
            if let Some(pixels) = run.get_mut(begin..begin + len) {
                gathered.paint(finish, towards, to_left, pixels, (x + begin as u32, y));
            }
        };
        paint(&finish.towards, along.is_turned(), at);
        if let Some(mirrored) = mirrored {
            paint(&mirrored, true, opposite);
        }
        (next, stop)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Row;
    use crate::color::{Rgb, Shades};
    use crate::{Background, Camera, Lathe, Light, Profile, Scene, Segment, Solid, valid};

    const SIDE: u32 = 201;

    /// All that a pixel is painted by.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Kept(Option<Shades>, u32, u32);

    impl Paint for Kept {
        const SHADES: Rgb = Rgb::gray(255.0);

        fn shade(shades: Shades, x: u32, y: u32) -> Self {
            Self(Some(shades), x, y)
        }
    }

    type Follow = fn(&mut Canvas<Kept>, &mut SolidRow, u32, u32) -> (u32, Stop);

    /// What of a row is followed, and how many pixels that are.
    fn followed(scene: &Scene, y: u32, follow: Follow) -> ([Kept; SIDE as usize], usize) {
        let mut run = [Kept(None, 0, 0); SIDE as usize];
        let row = Row { camera: &scene.camera, y, width: SIDE, height: SIDE };
        let mut along = scene.solids[0].along(&row, 0, SIDE);
        if along.is_far() {
            return (run, 0);
        }
        let finish = scene.solids[0].finish::<Kept>(&scene.light);
        let mirrored = along.mirrored(finish.towards);
        let mut canvas = Canvas { finish, mirrored, x: 0, y, run: &mut run, among: scene.solids };
        loop {
            let mut i = 0;
            while i < along.end() {
                i = if let Some(to) = along.followed(i) {
                    let (next, stop) =
                        if to > i { follow(&mut canvas, &mut along, i, to) } else { (i, Stop::End) };
                    along.stopped(next, stop);
                    next
                } else {
                    along.look(i).unwrap_or(i + 1)
                };
            }
            if !along.turn() {
                break;
            }
        }
        (run, run.iter().filter(|pixel| pixel.0.is_some()).count())
    }

    #[test]
    fn several_are_painted_as_each_by_itself() {
        static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
        let up = valid!(Camera::perspective([0.3, -5.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], 0.25));
        let leaning = valid!(Camera::perspective([0.3, -5.0, 1.0], [0.0; 3], [0.4, 0.0, 1.0], 0.25));
        for camera in [up, leaning] {
            let scene = Scene {
                solids: &[Solid::new(&BALL, Rgb::new(0.9, 0.5, 0.2))],
                camera,
                light: valid!(Light::new([-1.0, -0.5, 0.7], 0.1)),
                background: Background::Plain(Rgb::BLACK),
            };
            let mut count = 0;
            for y in 0..SIDE {
                let (several, pixels) =
                    followed(&scene, y, |canvas, along, i, to| canvas.follow_several(along, i, to));
                assert_eq!(
                    several,
                    followed(&scene, y, |canvas, along, i, to| canvas.follow_each(along, i, to)).0
                );
                count += pixels;
            }
            assert!(count > 20_000, "{count}");
        }
    }
}
