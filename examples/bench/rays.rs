//! Rays one by one, as if each were the only one: all those of the vase's frame.

use crate::{
    frames::{Panel, Usual, pixels},
    region::measure,
    report::line,
    scenes::{self, VASE_SCENE},
};
use core::hint::black_box;
use embedded_lathe::{Hit, Lathe, Ray};

/// What making the rays takes is taken off.
pub fn measured() {
    let alone = rays("rays alone", 0, |_| None);
    let lathes: [(_, &Lathe); 2] =
        [("ray at the vase", &scenes::VASE), ("ray at 64 segments", &scenes::fine::VASE)];
    for (name, lathe) in lathes {
        rays(name, alone, |ray| black_box(lathe).nearest(ray, 0.0));
    }
}

fn rays(name: &str, alone: u64, meet: impl Fn(&Ray) -> Option<Hit>) -> u64 {
    const WIDTH: u32 = Usual::WIDTH;
    const HEIGHT: u32 = Usual::HEIGHT;
    let camera = &VASE_SCENE.camera;
    let (hits, instructions) = measure(|| {
        let hit = |(x, y)| black_box(meet(black_box(&camera.ray(x, y, WIDTH, HEIGHT)))).is_some();
        pixels::<Usual>().map(hit).fold(0, |hits, hit| hits + u64::from(hit))
    });
    line(name, (WIDTH * HEIGHT).into(), hits, instructions.saturating_sub(alone));
    instructions
}
