//! Which pixels show the vase: by the oracle, and by every solver over every backend.

#[allow(dead_code)]
#[path = "../../examples/scenes/mod.rs"]
mod scenes;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::SimulatorDisplay;
use embedded_lathe::solve::Solver;
use embedded_lathe::{Background, Paint, Rgb, Scene};
use laboratory::cases::outline;
use laboratory::{PROMISE, ROUNDOFF, oracle, over_every_backend, unit};

const BLACK: Background = Background::Plain(Rgb::BLACK);

fn drawn(scene: &Scene, side: u32) -> SimulatorDisplay<Rgb888> {
    let mut display = SimulatorDisplay::new(Size::new(side, side));
    scene.draw(&mut display).unwrap();
    display
}

/// Whether each pixel shows a solid, where the oracle is sure of it: no hole, no speck.
#[test]
fn the_oracle_sees_the_same_vase() {
    let vase = outline("vase");
    let (side, mut sure) = (240, 0);
    let shape = vase.shape();
    for (scene, back) in
        [(&scenes::VASE_SCENE, 0.0_f64), (&scenes::TILTED_SCENE, -core::f64::consts::FRAC_PI_6)]
    {
        let display = drawn(scene, side);
        let Background::Plain(behind) = scene.background else { panic!("a plain background") };
        let behind = Rgb888::paint(behind, 0, 0);
        let mut covered = 0;
        for (x, y) in (0..side).flat_map(|x| (0..side).map(move |y| (x, y))) {
            let seen = display.get_pixel(Point::new(x as i32, y as i32)) != behind;
            covered += u32::from(seen);
            let ray = scene.camera.ray(x, y, side, side);
            let turn = |v: [f64; 3]| {
                [v[0], v[1] * back.cos() - v[2] * back.sin(), v[1] * back.sin() + v[2] * back.cos()]
            };
            let origin = ray.origin().map(f64::from);
            let towards = ray.at(1.0).map(f64::from);
            let direction = std::array::from_fn(|i| towards[i] - origin[i]);
            let ray = oracle::Ray { origin: turn(origin), direction: turn(direction), t_min: 0.0 };
            // The direction is what is left of a sum of about 3, and is 3 long before it meets the vase; and the
            // kernel's own units, as for every hit.
            let bands = oracle::bands(&shape, &ray, 3.0 * 3.0 * ROUNDOFF + PROMISE * unit(1.0, 3.0));
            if bands.complete {
                sure += 1;
                assert_eq!(seen, !bands.sure.is_empty(), "column {x}, row {y}");
            }
        }
        println!("{covered} of {} pixels covered", side * side);
        assert!(covered > side * side / 3);
    }
    assert!(sure > 2 * 240 * 240 - 100, "{sure}");
}

/// Which pixels show the vase: the picture's, and those of single rays by the solver S.
fn shows_the_vase<S: Solver>() {
    let side = 240;
    let scene = scenes::VASE_SCENE.with_background(BLACK);
    let picture = scene.picture(side, side);
    let mut row = vec![Rgb565::BLACK; side as usize];
    for y in 0..side {
        picture.row(y, &mut row);
        for (x, &pixel) in (0..).zip(&row) {
            let ray = scenes::VASE_SCENE.camera.ray(x, y, side, side);
            let hit = scenes::VASE.nearest_by::<S>(&ray, 0.0);
            assert_eq!(hit.is_some(), pixel != Rgb565::BLACK, "column {x}, row {y}: {hit:?}");
        }
    }
}

over_every_backend!(shows_the_vase);
