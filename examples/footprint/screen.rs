//! Everything by which a picture is part of a screen, on a display that takes pixels and shows none:
//! `laboratory/tests/panics.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../bare/mod.rs"]
mod bare;
#[cfg(target_os = "none")]
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;
#[cfg(target_os = "none")]
#[path = "../bench/sink.rs"]
mod sink;

#[cfg(target_os = "none")]
use {
    core::hint::black_box,
    embedded_graphics::{pixelcolor::Rgb565, prelude::*},
    embedded_lathe::{Camera, Pose, Redraw, Rotation},
};

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    static mut ROW: [Rgb565; 240] = [Rgb565::BLACK; 240];
    static mut OVER: [Option<Rgb565>; 240] = [None; 240];
    static mut BYTES: [u8; 480] = [0; 480];
    let mut display = sink::Sink::<Rgb565>::new(240, 240);
    let mut redraw = Redraw::new(display.bounding_box());
    loop {
        let Ok(solids) = scenes::dial::dial(black_box(0.3)) else { continue };
        let scene = scenes::dial::DIAL.with_solids(black_box(&solids));
        let Ok(camera) = scene.camera.framing(&solids, black_box(240), 240) else { continue };
        let picture = scene.with_camera(camera).picture(black_box(240), black_box(240));
        let placed = picture.at(black_box(Point::new(-3, 9)));
        let changed = redraw.next(placed.covered());
        let Ok(()) = placed.only(&changed).rows(0..black_box(200)).draw(&mut display);
        let Ok(()) = placed.translate(Point::new(1, 1)).draw_by_rows(&mut display, black_box(&mut ROW[..]));
        let Ok(()) = placed.draw_spans(&mut display, black_box(&mut ROW[..]), |y| picture.disc_of_row(y));
        let Ok(()) = placed.without_background().draw_by_rows(&mut display, black_box(&mut OVER[..]));
        picture.bytes_of_row(0, black_box(7), black_box(&mut BYTES[..]));
        black_box((placed.bounding_box(), placed.pick(black_box(Point::new(40, 50)))));
        black_box(poses(&camera));
    }
}

/// Poses from an IMU's numbers, and where a point of one is seen.
#[cfg(target_os = "none")]
fn poses(camera: &Camera) -> Option<Point> {
    let turn = Rotation::from_quaternion(black_box(0.5), black_box([0.1, 0.2, 0.3])).ok()?;
    let rotation = Rotation::from_rows(black_box(turn.rows())).ok()?;
    let pose = Pose::about(black_box([0.1; 3]), rotation).ok()?.then(Pose::IDENTITY).ok()?.inverse().ok()?;
    camera.pixel_of(pose.apply(black_box([0.2; 3])), Size::new(240, 240))
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("cargo test -p embedded-lathe-laboratory --test panics -- --ignored");
}
