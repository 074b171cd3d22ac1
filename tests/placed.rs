//! Pictures at a place of a display: every pixel that is promised is drawn and no other, whatever embedded-graphics makes of
//! the display; only what changed is drawn again. All through a display that records every call.

#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code)]
mod scenes;

mod compared;
#[allow(dead_code)]
mod random;
mod recorder;

use compared::Compared;
use embedded_graphics::draw_target::DrawTargetExt;
use embedded_graphics::image::{Image, ImageDrawableExt};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_lathe::{Picture, Placed, Pose, Redraw, Rotation, Scene, Solid};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use recorder::Recorder;
use scenes::dial::{DIAL, dial};

fn area(x: i32, y: i32, width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

/// The columns and rows of a rectangle.
fn points(area: &Rectangle) -> Vec<(i32, i32)> {
    area.points().map(|Point { x, y }| (x, y)).collect()
}

/// Compared with pixels that were cut out of whole rows, as few differ as `Picture::part_of_row` promises.
fn assert_few(&Compared { pixels, differ }: &Compared) {
    assert!(pixels > 10_000 && differ * 1_000 <= pixels, "{differ} of {pixels}");
}

/// The picture computed row by row.
fn whole(picture: &Picture) -> Vec<Rgb565> {
    let mut pixels = vec![Rgb565::BLACK; (picture.width() * picture.height()) as usize];
    for (y, row) in pixels.chunks_mut(picture.width() as usize).enumerate() {
        picture.row(y as u32, row);
    }
    pixels
}

/// That the display shows in `area`, and nowhere else, the picture whose column 0 of row 0 is at `position`, and that each
/// pixel was written once.
fn shows(
    display: &Recorder,
    picture: &Picture,
    position: Point,
    area: &Rectangle,
    compared: &mut Compared,
    what: &str,
) {
    assert_eq!(display.written, points(area), "{what}");
    let whole = whole(picture);
    for (x, y) in points(area) {
        let (column, row) = (x - position.x, y - position.y);
        let truth = whole[row as usize * picture.width() as usize + column as usize];
        compared.add(display.at(x, y).unwrap(), truth, what);
    }
}

/// The reference scenes and random ones, at places inside the display, over each of its edges, and outside.
#[test]
fn a_picture_is_drawn_where_it_is_put() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut compared = Compared::default();
    let mut outside = 0;
    let mut check = |scene: &Scene, rng: &mut ChaCha8Rng, what: &str| {
        let picture = scene.picture(rng.random_range(1..70), rng.random_range(1..60));
        let position = Point::new(rng.random_range(-60..70), rng.random_range(-50..60));
        let screen = area(rng.random_range(-5..5), rng.random_range(-5..5), 64, 48);
        let all = Rectangle::new(position, Size::new(picture.width(), picture.height()));
        let placed: Placed<Rgb565> = picture.at(position);
        assert_eq!((placed.bounding_box(), placed.position()), (all, position));
        let mut room = vec![Rgb565::BLACK; rng.random_range(0..80)];
        let mut draw = |placed: &Placed<Rgb565>, within: Rectangle, what: &str| {
            let seen = within.intersection(&screen);
            for by_rows in [false, true] {
                let mut display = Recorder::new(screen);
                if by_rows {
                    placed.draw_by_rows(&mut display, &mut room).unwrap();
                } else {
                    placed.draw(&mut display).unwrap();
                }
                assert!(
                    display.calls.len() == usize::from(!seen.is_zero_sized()),
                    "{what}: {:?}",
                    display.calls
                );
                if !seen.is_zero_sized() {
                    shows(&display, &picture, position, &seen, &mut compared, what);
                }
            }
            outside += usize::from(seen.is_zero_sized());
        };
        draw(&placed, all, what);
        let part = area(
            rng.random_range(-9..60),
            rng.random_range(-9..40),
            rng.random_range(0..40),
            rng.random_range(0..40),
        );
        draw(&placed.only(&part), all.intersection(&part), &format!("{what}, only {part:?}"));
        let (top, bottom) = (rng.random_range(0..70), rng.random_range(0..70));
        let height = bottom.min(picture.height()).saturating_sub(top);
        let band = Rectangle::new(position + Point::new(0, top as i32), Size::new(picture.width(), height));
        draw(&placed.rows(top..bottom), band, &format!("{what}, rows {top} to {bottom}"));
        let by = Point::new(rng.random_range(-9..9), rng.random_range(-9..9));
        let moved = *placed.clone().translate_mut(by);
        assert_eq!((moved, moved.bounding_box()), (placed.translate(by), all.translate(by)));
        assert_eq!(moved.translate(-by), placed);
    };
    for (name, scene) in scenes::NAMED {
        (0..4).for_each(|_| check(scene, &mut rng, name));
    }
    for case in 0..200 {
        let lathes = random::random_lathes(&mut rng);
        let solids = random::posed(&mut rng, &lathes);
        let scene = Scene::new(&solids, random::random_camera(&mut rng), scenes::DAYLIGHT)
            .with_background(scenes::SKY);
        check(&scene, &mut rng, &format!("case {case}"));
    }
    println!("{} of {} pixels differ by a shade; {outside} lay outside", compared.differ, compared.pixels);
    assert_few(&compared);
    assert!(outside > 20);
}

/// `translated` moves it, `clipped` and `cropped` cut it: that of a picture, and that of its `Image`.
#[test]
fn a_picture_is_moved_and_cut_as_every_drawable() {
    let mut compared = Compared::default();
    let position = Point::new(11, -7);
    for (name, scene) in scenes::NAMED {
        let picture = scene.picture(50, 40);
        let placed: Placed<Rgb565> = picture.at(position);
        let picture_image = picture.image::<Rgb565>();
        let image = Image::new(&picture_image, position);
        let box_of = |position| Rectangle::new(position, Size::new(50, 40));
        let (screen, window) = (area(0, 0, 60, 50), area(5, 4, 30, 20));
        let by = Point::new(-20, 9);
        for is_image in [false, true] {
            macro_rules! draw {
                ($target:expr) => {
                    if is_image { image.draw($target) } else { placed.draw($target) }.unwrap()
                };
            }
            let mut check = |display: &Recorder, position: Point, cut: &Rectangle, what: &str| {
                let seen = box_of(position).intersection(&screen).intersection(cut);
                assert!(!seen.is_zero_sized());
                shows(display, &picture, position, &seen, &mut compared, &format!("{name}, {what}"));
            };
            let mut display = Recorder::new(screen);
            draw!(&mut display.translated(by));
            check(&display, position + by, &screen, "translated");
            let mut display = Recorder::new(screen);
            draw!(&mut display.clipped(&window));
            check(&display, position, &window, "clipped");
            let mut display = Recorder::new(screen);
            draw!(&mut display.cropped(&window));
            check(&display, position + window.top_left, &window, "cropped");
        }
        // A part of an image, at a place of its own.
        let part = area(13, 9, 17, 21);
        let mut display = Recorder::new(screen);
        Image::new(&picture_image.sub_image(&part), Point::new(4, 4)).draw(&mut display).unwrap();
        shows(&display, &picture, Point::new(4, 4) - part.top_left, &area(4, 4, 17, 21), &mut compared, name);
    }
    assert_few(&compared);
}

/// `Scene::draw` fills the bounding box of whatever it is given, as `clear` does.
#[test]
fn a_scene_fills_the_bounding_box() {
    let scene = &scenes::VASE_SCENE;
    let mut compared = Compared::default();
    let (screen, window) = (area(0, 0, 120, 90), area(15, 14, 60, 50));
    let mut display = Recorder::new(screen);
    scene.draw(&mut display.translated(Point::new(7, 5))).unwrap();
    shows(&display, &scene.picture(120, 90), Point::zero(), &screen, &mut compared, "translated");
    for is_clipped in [true, false] {
        let mut display = Recorder::new(screen);
        if is_clipped {
            scene.draw(&mut display.clipped(&window)).unwrap();
        } else {
            scene.draw(&mut display.cropped(&window)).unwrap();
        }
        shows(&display, &scene.picture(60, 50), window.top_left, &window, &mut compared, "cut");
    }
    assert_few(&compared);
}

/// Pictures of any size, at any place: what the display has room for is drawn, and it is the right part.
#[test]
fn a_picture_of_any_size_is_cut_to_the_display() {
    let scene = &scenes::VASE_SCENE;
    let sizes = [1, 40, 1 << 20, 1 << 31, u32::MAX];
    let places = [i32::MIN, -(1 << 30), -500_000, -3, 0, 5, i32::MAX - 2, i32::MAX];
    let mut drawn = 0;
    for (width, height) in sizes.into_iter().flat_map(|width| sizes.map(|height| (width, height))) {
        let picture = scene.picture(width, height);
        for (x, y) in places.into_iter().flat_map(|x| places.map(|y| (x, y))) {
            let placed: Placed<Rgb565> = picture.at(Point::new(x, y));
            let mut display = Recorder::of_size(8, 6);
            placed.draw(&mut display).unwrap();
            for (column, row) in points(&area(0, 0, 8, 6)) {
                let [i, j] = [(column, x), (row, y)].map(|(at, from)| i64::from(at) - i64::from(from));
                let is_within = (0..i64::from(width)).contains(&i) && (0..i64::from(height)).contains(&j);
                assert_eq!(display.at(column, row).is_some(), is_within, "{width}×{height} at {x}, {y}");
                drawn += usize::from(is_within);
            }
            if let Some(&(left, top)) = display.written.first() {
                let first = display.calls[0];
                let [i, j] = [(left, x), (top, y)].map(|(at, from)| (i64::from(at) - i64::from(from)) as u32);
                let mut row = vec![Rgb565::BLACK; first.size.width as usize];
                picture.part_of_row(i, j, &mut row);
                let found: Vec<_> =
                    (0..row.len()).map(|at| display.at(left + at as i32, top).unwrap()).collect();
                assert_eq!(found, row, "{width}×{height} at {x}, {y}");
            }
            // What embedded-graphics computes with the box does not overflow.
            let bounds = placed.bounding_box();
            assert!(bounds.bottom_right().is_none_or(|last| last.x >= bounds.top_left.x));
            let _ = (
                placed.covered().bottom_right(),
                placed.rows(0..u32::MAX),
                placed.only(&area(x, y, u32::MAX, u32::MAX)),
            );
            assert_eq!(
                placed.translate(Point::new(i32::MAX, i32::MIN)).position().y,
                y.saturating_add(i32::MIN)
            );
        }
        let image = picture.image::<Rgb565>();
        let mut display = Recorder::of_size(8, 6);
        Image::new(&image, Point::new(-3, 2)).draw(&mut display).unwrap();
        assert_eq!(display.at(0, 2).is_some(), width > 3);
    }
    assert!(drawn > 5_000, "{drawn}");
}

/// The display's own error, wherever it is raised, and no pixel after it.
#[test]
fn an_error_in_the_middle_is_returned() {
    let picture = scenes::STILL_LIFE.picture(30, 20);
    let all = 30 * 20;
    for after in (0..all).step_by(37).chain([all - 1, all]) {
        let mut display = Recorder::of_size(40, 30).failing_after(after);
        let result = picture.at(Point::new(3, 4)).draw(&mut display);
        assert_eq!(result, if after < all { Err("cable") } else { Ok(()) }, "{after}");
        assert_eq!(display.written.len(), after);
    }
}

/// Without its background a picture is drawn where rays hit a solid, and nowhere else; in runs of a row, each pixel once, in the
/// colors of the whole picture. Over anything.
#[test]
fn only_the_solids_are_drawn_over_what_is_there() {
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    let mut compared = Compared::default();
    let (mut pixels, mut differ, mut most_calls) = (0, 0, 0);
    let mut check = |scene: &Scene, rng: &mut ChaCha8Rng, what: &str| {
        let picture = scene.picture(rng.random_range(1..90), rng.random_range(1..60));
        let position = Point::new(rng.random_range(-20..20), rng.random_range(-20..20));
        let screen = area(0, 0, 80, 50);
        let window = area(rng.random_range(0..20), rng.random_range(0..20), 70, 45);
        let by = Point::new(rng.random_range(-9..9), rng.random_range(-9..9));
        let room = [0, 1, 7, 40, 200][rng.random_range(0..5)];
        let overlay = picture.at::<Rgb565>(position).without_background();
        assert_eq!(overlay.bounding_box(), picture.at::<Rgb565>(position).bounding_box());
        let mut display = Recorder::new(screen);
        overlay.draw_by_rows(&mut display.clipped(&window).translated(by), &mut vec![None; room]).unwrap();
        let (at, room) = (position + by, if room == 0 { 40 } else { room });
        let all = Rectangle::new(at, Size::new(picture.width(), picture.height()));
        let seen = all.intersection(&screen).intersection(&window);
        let whole = whole(&picture);
        for &(x, y) in &display.written {
            assert!(seen.contains(Point::new(x, y)), "{what}: {x}, {y} is not in {seen:?}");
            let (column, row) = ((x - at.x) as usize, (y - at.y) as usize);
            compared.add(display.at(x, y).unwrap(), whole[row * picture.width() as usize + column], what);
        }
        assert_eq!(display.written.len(), display.shown.len(), "{what}: a pixel is drawn twice");
        for (x, y) in points(&seen) {
            let ray =
                scene.camera.ray_at(Point::new(x, y) - at, Size::new(picture.width(), picture.height()));
            let is_hit = scene.nearest(&ray, 0.0).is_some();
            pixels += 1;
            differ += usize::from(is_hit != display.at(x, y).is_some());
        }
        // Runs are as long as the memory allows.
        for pair in display.calls.windows(2) {
            let [one, next] = [pair[0], pair[1]].map(|run| (run.top_left, run.size.width as i32));
            assert!(pair[1].size.height == 1 && next.1 <= room as i32);
            let is_cut = (next.0.x - seen.top_left.x) % room as i32 == 0;
            assert!(
                one.0.y < next.0.y || one.0.x + one.1 < next.0.x || one.0.x + one.1 == next.0.x && is_cut,
                "{what}: {pair:?}"
            );
        }
        most_calls = most_calls.max(display.calls.len());
    };
    for (name, scene) in scenes::NAMED {
        (0..4).for_each(|_| check(scene, &mut rng, name));
    }
    for case in 0..200 {
        let lathes = random::random_lathes(&mut rng);
        let solids = random::posed(&mut rng, &lathes);
        let scene = Scene::new(&solids, random::random_camera(&mut rng), scenes::DAYLIGHT);
        check(&scene, &mut rng, &format!("case {case}"));
    }
    println!("{differ} of {pixels} pixels differ from single rays; at most {most_calls} calls");
    assert_few(&compared);
    assert!(
        pixels > 100_000 && differ * 10_000 <= pixels && most_calls > 80,
        "{differ} of {pixels}, {most_calls}"
    );
}

/// What a part covers is the part of what the picture covers, moved to where the picture is.
#[test]
fn what_a_part_covers_is_cut_to_it() {
    let picture = scenes::VASE_SCENE.picture(70, 60);
    let (at, all) = (Point::new(-20, 5), picture.covered());
    let placed: Placed<Rgb565> = picture.at(at);
    assert_eq!(placed.covered(), all.translate(at));
    for part in [area(0, 10, 20, 15), area(-20, 30, 70, 1), area(10, 20, 500, 500)] {
        let shown = placed.only(&part).covered();
        assert_eq!(shown, all.translate(at).intersection(&part));
        assert!(!shown.is_zero_sized() && shown != placed.covered());
    }
    // Beside the vase, and without any solid.
    assert!(placed.only(&area(-20, 5, 3, 60)).covered().is_zero_sized());
    let none = Scene::new(&[], scenes::VASE_SCENE.camera, scenes::DAYLIGHT);
    assert_eq!(none.picture(70, 60).at::<Rgb565>(at).covered(), Rectangle::zero());
}

/// Another solid's picture, and text beside it, stay where the solid is not: the vase in front of the bowl.
#[test]
fn a_picture_lies_over_another() {
    let (width, height) = (70, 60);
    let mut display = Recorder::of_size(width, height);
    scenes::BOWL_SCENE.draw(&mut display).unwrap();
    let below = display.clone();
    display.next_frame();
    let picture = scenes::VASE_SCENE.picture(width, height);
    let placed = picture.at(Point::zero());
    // The rectangle that the vase covers is enough.
    placed.only(&placed.covered()).without_background().draw(&mut display).unwrap();
    let mut rows = vec![None; (width * height) as usize];
    rows.chunks_mut(width as usize).zip(0..).for_each(|(row, y)| picture.row::<Option<Rgb565>>(y, row));
    let mut compared = Compared::default();
    let mut over = 0;
    for (i, color) in rows.into_iter().enumerate() {
        let (x, y) = ((i % width as usize) as i32, (i / width as usize) as i32);
        match color {
            Some(color) => compared.add(display.at(x, y).unwrap(), color, "the vase"),
            None => assert_eq!(display.at(x, y), below.at(x, y), "{x}, {y}"),
        }
        over += usize::from(color.is_some());
    }
    assert!(over > 1_000 && compared.differ <= 1 && display.written.len() == over, "{over}");
    // A display's error ends it.
    for after in (0..over).step_by(97) {
        let mut display = Recorder::of_size(width, height).failing_after(after);
        assert_eq!(placed.without_background().draw(&mut display), Err("cable"));
        assert_eq!(display.written.len(), after);
    }
}

/// A ball that moves in front of a vase, drawn by its rectangle alone: the display shows what whole frames show.
#[test]
fn only_what_changed_is_drawn_again() {
    let (width, height) = (80, 60);
    let position = Point::new(9, 6);
    let screen = area(0, 0, 100, 70);
    let mut compared = Compared::default();
    let mut display = Recorder::new(screen);
    let mut redraw = Redraw::new(Rectangle::new(position, Size::new(width, height)));
    let mut drawn = 0;
    for frame in 0..40 {
        let angle = 0.17 * frame as f32;
        // It leaves the picture at the right, and comes back.
        let place = [0.9 + angle.cos(), angle.sin() - 0.6, 0.5];
        let ball =
            Solid::new(&scenes::BALL, scenes::CLAY).posed(Pose::new(place, Rotation::IDENTITY, 0.8).unwrap());
        let solids = [scenes::VASE_SCENE.solids[0], ball];
        let scene = scenes::VASE_SCENE.with_solids(&solids).with_background(scenes::SKY);
        let picture = scene.picture(width, height);
        let now = picture.covered_by(&ball).translate(position);
        let changed =
            if now.size == Size::zero() { redraw.next(Rectangle::zero()) } else { redraw.next(now) };
        display.next_frame();
        picture.at(position).only(&changed).draw(&mut display).unwrap();
        assert_eq!(
            display.written,
            points(&changed.intersection(&Rectangle::new(position, Size::new(width, height))))
        );
        drawn += display.written.len();
        for (i, truth) in whole(&picture).into_iter().enumerate() {
            let (x, y) = ((i % width as usize) as i32, (i / width as usize) as i32);
            compared.add(
                display.at(x + position.x, y + position.y).unwrap(),
                truth,
                &format!("frame {frame}"),
            );
        }
    }
    assert_few(&compared);
    assert!(drawn < 40 * 80 * 60 / 4, "{drawn}");
}

/// Scenes whose solids jump to other poses: the rectangle of what they covered and cover is enough, whatever they are.
#[test]
fn scenes_that_jump_are_drawn_by_their_rectangles() {
    let mut rng = ChaCha8Rng::seed_from_u64(18);
    let mut compared = Compared::default();
    let mut drawn = 0;
    let mut check = |scene: &Scene, after: &[Solid], what: &str| {
        let (picture, next) = (scene.picture(45, 38), scene.with_solids(after));
        let next = next.picture(45, 38);
        let mut display = Recorder::of_size(45, 38);
        picture.at(Point::zero()).draw(&mut display).unwrap();
        display.next_frame();
        let changed = Redraw::new(picture.covered()).next(next.covered());
        next.at(Point::zero()).only(&changed).draw(&mut display).unwrap();
        assert_eq!(display.written, points(&changed), "{what}");
        drawn += display.written.len();
        for (i, truth) in whole(&next).into_iter().enumerate() {
            compared.add(display.at((i % 45) as i32, (i / 45) as i32).unwrap(), truth, what);
        }
    };
    for (name, scene) in scenes::NAMED {
        let pose = Pose::new([0.3, -0.1, 0.2], Rotation::about_y(0.4), 0.8).unwrap();
        let after: Vec<_> =
            scene.solids.iter().map(|solid| solid.posed(solid.pose().then(pose).unwrap())).collect();
        check(scene, &after, name);
    }
    for case in 0..200 {
        let lathes = random::random_lathes(&mut rng);
        let (before, after) = (random::posed(&mut rng, &lathes), random::posed(&mut rng, &lathes));
        let camera =
            if case % 2 == 0 { random::random_camera(&mut rng) } else { random::upright_camera(&mut rng) };
        let scene = Scene::new(&before, camera, scenes::DAYLIGHT).with_background(scenes::SKY);
        check(&scene, &after, &format!("case {case}"));
    }
    println!("{drawn} of {} pixels drawn, {} differ by a shade", compared.pixels, compared.differ);
    assert_few(&compared);
    assert!(drawn < compared.pixels * 9 / 10);
}

/// A pointer in the knob's pose shows that the knob turns: by 5°, from any angle on. Only the pointer's rectangle is drawn.
#[test]
fn a_knob_is_seen_to_turn() {
    let step = core::f32::consts::PI / 36.0;
    let mut display = Recorder::of_size(240, 240);
    let mut redraw = Redraw::new(display.bounding_box());
    let mut compared = Compared::default();
    let mut last: Option<Vec<Rgb565>> = None;
    let (mut least, mut most_drawn) = (usize::MAX, 0);
    // 45° apart, and 5° on from each.
    for n in (0..8).flat_map(|eighth| [9 * eighth, 9 * eighth + 1]) {
        let solids = dial(n as f32 * step).unwrap();
        let picture = DIAL.with_solids(&solids).picture(240, 240);
        let changed = redraw.next(picture.covered_by(&solids[1]));
        display.next_frame();
        picture.at(Point::zero()).only(&changed).draw(&mut display).unwrap();
        let now = whole(&picture);
        for (i, &truth) in now.iter().enumerate() {
            let (x, y) = ((i % 240) as i32, (i / 240) as i32);
            compared.add(display.at(x, y).unwrap(), truth, &format!("{}°", 5 * n));
        }
        if let Some(last) = last
            && n % 9 == 1
        {
            least = least.min(last.iter().zip(&now).filter(|(a, b)| a != b).count());
            most_drawn = most_drawn.max(display.written.len());
        }
        last = Some(now);
    }
    println!("at least {least} pixels change, and at most {most_drawn} are drawn");
    assert_few(&compared);
    assert!(least >= 30 && most_drawn < 240 * 240 / 8, "{least}, {most_drawn}");
}

/// The union of two frames' rectangles, of which either may have no pixels.
#[test]
fn a_frame_draws_what_it_and_the_last_one_cover() {
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    let mut any = |_| {
        area(rng.random_range(-9..9), rng.random_range(-9..9), rng.random_range(0..9), rng.random_range(0..9))
    };
    let mut last = area(0, 0, 20, 10);
    let mut redraw = Redraw::new(last);
    for case in 0..500 {
        let now = any(case);
        let both = redraw.next(now);
        let held: Vec<_> = points(&last).into_iter().chain(points(&now)).collect();
        let least = held.iter().fold(None, |least: Option<[i32; 4]>, &(x, y)| {
            let [a, b, c, d] = least.unwrap_or([x, y, x, y]);
            Some([a.min(x), b.min(y), c.max(x), d.max(y)])
        });
        match least {
            Some([a, b, c, d]) => {
                assert_eq!(both, Rectangle::with_corners(Point::new(a, b), Point::new(c, d)), "{case}")
            }
            None => assert!(both.is_zero_sized(), "{case}: {both:?}"),
        }
        last = now;
    }
    let (low, high) = (area(i32::MIN, 0, 1, 1), area(i32::MAX, 0, 1, 1));
    assert_eq!(Redraw::new(low).next(high).size.width, u32::MAX);
}
