//! The vase's whole frame by single rays, as a program would draw it that knows no rows: by each solver and backend.

use crate::frames::{Panel, Usual, frame};
use crate::scenes::{VASE, VASE_SCENE, lambert};
use core::hint::black_box;
use embedded_lathe::math::{Libm, Micromath, Native};
use embedded_lathe::solve::{Cardano, Solver, Split};
use embedded_lathe::{Background, Hit, Paint, Ray, Scene};

pub fn measured() {
    line("vase by rays default", |ray| VASE.nearest(ray, 0.0));
    line("vase by rays split native", by::<Split<Native>>);
    line("vase by rays split libm", by::<Split<Libm>>);
    line("vase by rays split micromath", by::<Split<Micromath>>);
    line("vase by rays cardano native", by::<Cardano<Native>>);
    line("vase by rays cardano libm", by::<Cardano<Libm>>);
    line("vase by rays cardano micromath", by::<Cardano<Micromath>>);
}

type Nearest = fn(&Ray) -> Option<Hit>;

fn by<S: Solver>(ray: &Ray) -> Option<Hit> {
    VASE.nearest_by::<S>(ray, 0.0)
}

fn line(name: &str, nearest: Nearest) {
    let mut row = [Usual::BLANK; 240];
    frame::<Usual>(name, &VASE_SCENE, || rows(black_box(&VASE_SCENE), black_box(nearest), &mut row));
}

type Row = [<Usual as Panel>::Color; 240];

#[inline(never)]
fn rows(scene: &Scene, nearest: Nearest, row: &mut Row) {
    let Background::Plain(background) = scene.background else { return };
    for y in 0..Usual::HEIGHT {
        for (pixel, x) in row.iter_mut().zip(0..Usual::WIDTH) {
            let ray = scene.camera.ray(x, y, Usual::WIDTH, Usual::HEIGHT);
            *pixel = Paint::paint(lambert::seen(&ray, nearest).unwrap_or(background), x, y);
        }
        black_box(&row[..]);
    }
}
