//! Rows as bytes: those of `Rgb565`, sent from two buffers, left between two rows, from several threads; and the columns that a
//! round panel asks for.

#[path = "../examples/two_rows/bus.rs"]
mod bus;
#[path = "../examples/two_rows/frame.rs"]
mod frame;
#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code)]
mod scenes;

mod recorder;

use bus::Bus;
use embedded_graphics::pixelcolor::{Rgb565, raw::ToBytes};
use embedded_graphics::prelude::*;
use embedded_lathe::{Picture, Scene};
use frame::Frame;
use recorder::Recorder;

/// The whole picture, by rows of `Rgb565`, as bytes.
fn bytes(picture: &Picture) -> Vec<u8> {
    let mut row = vec![Rgb565::BLACK; picture.width() as usize];
    (0..picture.height())
        .flat_map(|y| {
            picture.row(y, &mut row);
            row.iter().flat_map(|color| color.to_be_bytes()).collect::<Vec<_>>()
        })
        .collect()
}

#[test]
fn bytes_are_those_of_the_colors() {
    for (name, scene) in scenes::NAMED {
        let picture = scene.picture(101, 67);
        let truth = bytes(&picture);
        for (y, row) in (0..67).zip(truth.chunks(202)) {
            let mut buffer = [0; 202];
            picture.bytes_of_row(0, y, &mut buffer);
            assert_eq!(buffer, row, "{name}, row {y}");
        }
    }
    let picture = scenes::VASE_SCENE.picture(20, 20);
    for (x, len, written) in
        [(0, 0, 0), (0, 1, 0), (0, 7, 6), (0, 41, 40), (17, 40, 6), (20, 8, 0), (u32::MAX, 8, 0)]
    {
        let mut buffer = vec![0xaa; len];
        picture.bytes_of_row(x, 9, &mut buffer);
        let mut part = vec![Rgb565::BLACK; written / 2];
        picture.part_of_row(x, 9, &mut part);
        assert_eq!(buffer[..written], part.iter().flat_map(|color| color.to_be_bytes()).collect::<Vec<_>>());
        assert!(buffer[written..].iter().all(|&byte| byte == 0xaa), "{x}, {len}: {buffer:?}");
    }
}

/// The program of `examples/two_rows`, and the display that it fills; between its rows another frame is computed.
#[test]
fn one_row_is_sent_while_the_next_is_computed() {
    let picture = scenes::STILL_LIFE.picture(240, 50);
    let other_picture = scenes::VASE_SCENE.picture(240, 20);
    let [mut sent, mut computed] = [(); 2].map(|()| &mut *Box::leak(Box::new([0; 480])));
    let (mut bus, mut frame, mut other) = (Bus::new(), Frame::new(picture), Frame::new(other_picture));
    let (mut is_row, mut beside, mut row) = (frame.next_row(sent), Vec::new(), [0; 480]);
    while is_row {
        bus.start(sent);
        is_row = frame.next_row(computed);
        if other.next_row(&mut row) {
            beside.extend(row);
        }
        sent = bus.finish();
        std::mem::swap(&mut sent, &mut computed);
    }
    assert!(bus.close() == bytes(&picture) && beside == bytes(&other_picture));
}

/// A frame goes to another thread, half drawn; and two threads share a picture's rows.
#[test]
fn rows_are_computed_in_any_thread() {
    fn is_shared<T: Send + Sync>() {}
    is_shared::<Picture>();
    is_shared::<Scene>();
    let picture = scenes::BOWL_SCENE.picture(60, 40);
    let truth = bytes(&picture);
    let mut pixels = vec![0; truth.len()];
    let (upper, lower) = pixels.split_at_mut(60 * 2 * 25);
    let rows = |frame: &mut Frame, rows: &mut [u8]| rows.chunks_mut(120).all(|row| frame.next_row(row));
    let mut frame = Frame::new(picture);
    assert!(rows(&mut frame, upper));
    let is_drawn = std::thread::scope(|scope| scope.spawn(move || rows(&mut frame, lower)).join().unwrap());
    assert!(is_drawn && pixels == truth);
    std::thread::scope(|scope| {
        let (even, odd) = (picture, &picture);
        let every_other = |picture: &Picture, first: u32| {
            let mut buffer = [0; 120];
            (first..40).step_by(2).all(|y| {
                picture.bytes_of_row(0, y, &mut buffer);
                buffer == truth[120 * y as usize..][..120]
            })
        };
        let one = scope.spawn(move || every_other(&even, 0));
        assert!(every_other(odd, 1) && one.join().unwrap());
    });
}

/// By each pixel's nearest point to the middle, in whole numbers; and no other pixel is drawn.
#[test]
fn a_round_panel_asks_for_its_disc() {
    for (width, height) in [(1, 1), (2, 2), (7, 7), (240, 240), (31, 20), (20, 31), (0, 4), (4, 0), (1, 90)] {
        let picture = scenes::VASE_SCENE.picture(width, height);
        let (w, h) = (i64::from(width), i64::from(height));
        let off = |i: i64, of: i64| (2 * i - of).max(of - 2 * i - 2).max(0);
        let is_shown = |x: i64, y: i64| off(x, w).pow(2) + off(y, h).pow(2) < w.min(h).pow(2);
        for y in 0..h + 3 {
            let columns = picture.disc_of_row(y as u32);
            for x in 0..w {
                assert_eq!(columns.contains(&(x as u32)), is_shown(x, y), "{width}×{height}: {x}, {y}");
            }
            assert!(columns.end <= width);
        }
        if width * height < 1000 {
            let mut display = Recorder::of_size(width + 2, height);
            let position = Point::new(1, -1);
            let placed = picture.at(position);
            placed.draw_spans(&mut display, &mut [], |y| picture.disc_of_row(y)).unwrap();
            let all =
                (0..h).flat_map(|y| (0..w).map(move |x| (x, y))).filter(|&(x, y)| y > 0 && is_shown(x, y));
            let all: Vec<_> = all.map(|(x, y)| (x as i32 + 1, y as i32 - 1)).collect();
            assert_eq!(display.written, all, "{width}×{height}");
        }
    }
    let vast = scenes::VASE_SCENE.picture(u32::MAX, u32::MAX);
    for y in [0, 1, u32::MAX / 2, u32::MAX - 1] {
        assert!(!vast.disc_of_row(y).is_empty());
    }
    assert_eq!(vast.disc_of_row(u32::MAX / 2), 0..u32::MAX);
    // An error in the middle is returned, and no span is drawn after it; spans the wrong way round are empty.
    let picture = scenes::VASE_SCENE.picture(30, 30);
    let mut display = Recorder::of_size(30, 30).failing_after(100);
    let mut row = [Rgb565::BLACK; 30];
    assert_eq!(
        picture.at(Point::zero()).draw_spans(&mut display, &mut row, |y| picture.disc_of_row(y)),
        Err("cable")
    );
    assert_eq!(display.written.len(), 100);
    let mut display = Recorder::of_size(30, 30);
    #[allow(clippy::reversed_empty_ranges)]
    picture
        .at(Point::zero())
        .draw_spans(&mut display, &mut row, |y| if y == 3 { 5..900 } else { 9..2 })
        .unwrap();
    assert_eq!(display.written, (5..30).map(|x| (x, 3)).collect::<Vec<_>>());
}
