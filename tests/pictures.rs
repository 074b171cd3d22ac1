//! From scenes to pixels: every way to them gives the same ones. Where they are: `laboratory/tests/vase.rs`.

#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code)]
mod scenes;

mod compared;

use compared::Compared;
use embedded_graphics::image::{Image, ImageDrawable, ImageDrawableExt};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use embedded_lathe::{
    Background, Camera, Lathe, Light, Paint, Picture, Pose, Profile, Rgb, Rotation, Scene, SceneError,
    Segment, Solid, valid,
};

fn drawn<C: PixelColor + Paint + From<BinaryColor>>(
    scene: &Scene,
    width: u32,
    height: u32,
) -> SimulatorDisplay<C> {
    let mut display = SimulatorDisplay::new(Size::new(width, height));
    scene.draw(&mut display).unwrap();
    display
}

/// The rows of a scene, one after another, asked for in the given lengths.
fn rows<C: Paint>(scene: &Scene, width: u32, height: u32, parts: &[usize], blank: C) -> Vec<C> {
    let picture = scene.picture(width, height);
    let mut pixels = vec![blank; (width * height) as usize];
    for (y, row) in pixels.chunks_mut(width as usize).enumerate() {
        let mut x = 0;
        for &len in parts.iter().cycle() {
            let end = row.len().min(x + len);
            picture.part_of_row(x as u32, y as u32, &mut row[x..end]);
            x = end;
            if x == row.len() {
                break;
            }
        }
    }
    pixels
}

/// Whole or in parts, by rows or by a display: what is shared along a row differs, so that bits may.
#[test]
fn every_way_gives_the_same_pixels() {
    // An odd width, whose middle is a pixel, and an even one, whose halves may be each other's mirror image.
    for ((name, scene), (width, height)) in
        scenes::NAMED.into_iter().flat_map(|named| [(named, (101, 67)), (named, (240, 240))])
    {
        let mut compared = Compared::default();
        let display = drawn::<Rgb565>(scene, width, height);
        let at = |x: u32, y: u32| display.get_pixel(Point::new(x as i32, y as i32));
        let all: Vec<Rgb565> =
            (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| at(x, y)).collect();
        let whole = width as usize;
        for parts in [&[whole][..], &[32], &[1], &[5, 40, 2]] {
            let rows = rows(scene, width, height, parts, Rgb565::BLACK);
            rows.iter().zip(&all).for_each(|(&a, &b)| compared.add(a, b, &format!("rows by {parts:?}")));
        }
        // Through memory of any length: to the last bit what parts of rows of that length give. None is a run
        // of 80, 160 bytes.
        for (room, part) in [(0, 80), (1, 1), (37, 37), (whole, whole), (1000, whole)] {
            let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(width, height));
            scene.draw_by_rows(&mut display, &mut vec![Rgb565::BLACK; room]).unwrap();
            for (i, pixel) in rows(scene, width, height, &[part], Rgb565::BLACK).into_iter().enumerate() {
                let (x, y) = (i % whole, i / whole);
                let here = display.get_pixel(Point::new(x as i32, y as i32));
                assert_eq!(here, pixel, "{name}, {room} at a time: column {x}, row {y}");
            }
        }
        // As an image, part of which lies outside the display, at a place of its own.
        let mut clipped = SimulatorDisplay::<Rgb565>::new(Size::new(60, 50));
        let image = scene.picture(width, height).image::<Rgb565>();
        Image::new(&image, Point::new(-20, -10)).draw(&mut clipped).unwrap();
        for (x, y) in (0..60).flat_map(|x| (0..50).map(move |y| (x, y))) {
            compared.add(clipped.get_pixel(Point::new(x, y)), at(x as u32 + 20, y as u32 + 10), "clipped");
        }
        let area = Rectangle::new(Point::new(30, 20), Size::new(17, 9));
        let mut part = SimulatorDisplay::<Rgb565>::new(Size::new(17, 9));
        Image::new(&image.sub_image(&area), Point::zero()).draw(&mut part).unwrap();
        for (x, y) in (0..17).flat_map(|x| (0..9).map(move |y| (x, y))) {
            compared.add(part.get_pixel(Point::new(x, y)), at(x as u32 + 30, y as u32 + 20), "part");
        }
        let Compared { differ, pixels } = compared;
        println!("{name}, {width} wide: {differ} of {pixels} pixels differ by one shade");
        assert!(differ * 10_000 <= pixels, "{name}, {width} wide: {differ} of {pixels}");
    }
}

/// How many pixels of 240×240 differ between whole rows and parts of so many pixels, in a display's finest
/// colors: by one shade of a channel, and by more.
fn differing_by_parts(scene: &Scene, parts: &[usize]) -> [usize; 2] {
    let whole = rows(scene, 240, 240, &[240], Rgb888::BLACK);
    let parts = rows(scene, 240, 240, parts, Rgb888::BLACK);
    let mut differ = [0; 2];
    for (one, other) in whole.into_iter().zip(parts).filter(|(one, other)| one != other) {
        let channels = [(one.r(), other.r()), (one.g(), other.g()), (one.b(), other.b())];
        differ[usize::from(channels.iter().any(|(a, b)| a.abs_diff(*b) > 1))] += 1;
    }
    differ
}

/// What the doc of `Picture::part_of_row` promises: of the reference scenes, from where they are seen and
/// from up to 200 times as far, the picture's angle as much narrower.
#[test]
fn parts_of_rows_are_the_whole_row_from_far_away_too() {
    const PIXELS: usize = 240 * 240;
    let up = [0.0, 0.0, 1.0];
    let target = [0.0, 0.0, 0.5];
    let views = [
        ("from the side", [0.0, -2.2, 0.9], up),
        ("leaning", [0.0, -2.2, 0.9], [0.342_020_14, 0.0, 0.939_692_6]),
        ("from above", [0.0, -2.2, 2.7], up),
    ];
    let (mut most_by_parts, mut most_by_pixels, mut most_at_creases) = (0, 0, 0);
    for (name, scene) in scenes::NAMED {
        for ((view, eye, up), far) in
            views.iter().flat_map(|&view| [1.0, 10.0, 40.0, 140.0, 200.0].map(|far| (view, far)))
        {
            let eye = core::array::from_fn(|i| target[i] + (eye[i] - target[i]) * far);
            let camera = Camera::perspective(eye, target, up, 0.3 / far).unwrap();
            let scene = scene.with_camera(camera);
            for parts in [&[40][..], &[32], &[5, 40, 2], &[1]] {
                let [by_a_step, by_more] = differing_by_parts(&scene, parts);
                let what =
                    format!("{name}, {view}, {far} times as far, by {parts:?}: {by_a_step}, {by_more}");
                let (allowed, most) =
                    if parts == [1] { (1_000, &mut most_by_pixels) } else { (5_000, &mut most_by_parts) };
                *most = by_a_step.max(*most);
                most_at_creases = by_more.max(most_at_creases);
                assert!(by_a_step * allowed <= PIXELS, "{what}");
                // Which side of a crease a ray sees that meets it to within rounding.
                assert!(by_more * 50_000 <= PIXELS, "{what}");
            }
        }
    }
    // The view that showed that each part rounded the eye's distance in its own way: then 100 pixels
    // differed.
    let camera = Camera::perspective([0.0, -307.0, 307.5], target, up, 0.00186).unwrap();
    let [vase, more] = differing_by_parts(&scenes::VASE_SCENE.with_camera(camera), &[40]);
    println!(
        "of {PIXELS} pixels at most {most_by_parts} differ by parts, {most_by_pixels} one by one, \
         {most_at_creases} at creases; of the vase from afar {vase}"
    );
    assert!(vase * 10_000 <= PIXELS && more == 0, "{vase}, {more}");
}

/// A display that takes pixels by `nth`, as clipping drivers do.
struct Skips(Vec<(usize, Rgb565)>);

impl OriginDimensions for Skips {
    fn size(&self) -> Size {
        Size::new(64, 48)
    }
}

impl DrawTarget for Skips {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, _: I) -> Result<(), Self::Error> {
        panic!("pixel by pixel is slow");
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Self::Error> {
        assert_eq!(area.size, self.size());
        let mut colors = colors.into_iter();
        let mut at = 0;
        for skip in [0, 1, 31, 0, 63, 64, 65, 700, 0, 5].into_iter().cycle() {
            at += skip;
            let Some(color) = colors.nth(skip) else {
                assert!(at >= 64 * 48);
                return Ok(());
            };
            self.0.push((at, color));
            at += 1;
        }
        Ok(())
    }
}

#[test]
fn pixels_may_be_skipped() {
    let mut display = Skips(Vec::new());
    scenes::VASE_SCENE.draw(&mut display).unwrap();
    let all = rows(&scenes::VASE_SCENE, 64, 48, &[64], Rgb565::BLACK);
    assert!(display.0.len() > 20);
    assert!(display.0.iter().all(|&(at, color)| color == all[at]));
}

#[test]
fn a_display_of_no_size_is_drawn_in_no_time() {
    for (width, height) in [(0, 0), (0, 9), (9, 0)] {
        drawn::<Rgb565>(&scenes::VASE_SCENE, width, height);
    }
    scenes::VASE_SCENE.picture(8, 8).row(8, &mut [Rgb565::BLACK; 0]);
    // Longer than the picture is wide: the rest is the caller's.
    let mut row = [Rgb565::WHITE; 12];
    scenes::VASE_SCENE.picture(8, 8).row(0, &mut row);
    assert_eq!(row[8..], [Rgb565::WHITE; 4]);
}

/// A picture without columns or without rows has no pixels, and the largest ones are computed where they are
/// asked for: nothing is NaN, nothing overflows.
#[test]
fn pictures_of_any_size_have_a_defined_answer() {
    let dusk = Background::Gradient { top: Rgb::BLACK, bottom: Rgb::WHITE };
    let scene = scenes::VASE_SCENE.with_background(dusk);
    for (width, height) in [(5, 0), (0, 5), (0, 0)] {
        let mut row = [Rgb::new(0.3, 0.2, 0.1); 5];
        scene.picture(width, height).row(0, &mut row);
        assert_eq!(row, [Rgb::new(0.3, 0.2, 0.1); 5], "{width}×{height}");
    }
    let sizes = [1, 2, 5, 1 << 16, 1 << 24, u32::MAX - 1, u32::MAX];
    for (width, height) in sizes.into_iter().flat_map(|width| sizes.map(|height| (width, height))) {
        let picture = scene.picture(width, height);
        for (x, y) in [0, 1, 2].into_iter().flat_map(|i| [(i, i), (width / 2, height / 2)]) {
            for (x, y) in
                [(x, y), (width - 1 - x.min(width - 1), height - 1 - y.min(height - 1)), (x, u32::MAX)]
            {
                let mut part = [Rgb::new(-1.0, f32::NAN, -1.0); 7];
                picture.part_of_row(x, y, &mut part);
                let within = (width.saturating_sub(x) as usize).min(7);
                let is_color =
                    |color: &Rgb| [color.r, color.g, color.b].iter().all(|c| (0.0..=1.0).contains(c));
                assert!(
                    part[..within].iter().all(is_color),
                    "{width}×{height}, column {x}, row {y}: {part:?}"
                );
                assert!(
                    part[within..].iter().all(|color| color.g.is_nan()),
                    "{width}×{height}, column {x}, row {y}"
                );
            }
        }
    }
}

/// A picture lives on its own, its scene a temporary, and may be made at compile time.
#[test]
fn a_picture_owns_its_scene() {
    static PICTURE: Picture = scenes::STILL_LIFE.picture(24, 24);
    let solids = scenes::STILL_LIFE.solids.to_vec();
    let own = Scene::new(&solids, scenes::STILL_LIFE.camera, scenes::STILL_LIFE.light)
        .with_background(scenes::STILL_LIFE.background)
        .picture(24, 24);
    assert_eq!(own, PICTURE);
    let (mut one, mut other) = ([Rgb888::BLACK; 24], [Rgb888::WHITE; 24]);
    for y in 0..24 {
        own.row(y, &mut one);
        PICTURE.row(y, &mut other);
        assert_eq!(one, other, "row {y}");
    }
}

/// Forty balls in two crossing rows, more than a picture keeps the order of, in any order: the picture is the
/// same, and that of single rays.
#[test]
fn many_solids_hide_one_another_as_they_should() {
    let ball = |i: u32| {
        let along = 0.11 * (i / 2) as f32 - 1.05;
        let place = if i.is_multiple_of(2) { [along, along, 0.0] } else { [along, -along, 0.02] };
        let color =
            Rgb::from_u8(40 + 5 * i as u8, 255 - 5 * i as u8, if i.is_multiple_of(3) { 200 } else { 60 });
        Solid::new(&scenes::BALL, color).posed(Pose::new(place, Rotation::IDENTITY, 0.6).unwrap())
    };
    let camera = Camera::perspective([0.2, -4.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], 0.35).unwrap();
    let light = Light::new([0.0, -1.0, 0.5], 1.0).unwrap();
    let orders: [fn(u32) -> u32; 4] = [|i| i, |i| 39 - i, |i| 7 * i % 40, |i| 23 * i % 40];
    let pictures = orders.map(|order| {
        let solids: Vec<_> = (0..40).map(|i| ball(order(i))).collect();
        rows(&Scene::new(&solids, camera, light), 90, 60, &[90], Rgb888::BLACK)
    });
    let solids: Vec<_> = (0..40).map(ball).collect();
    let mut covered = 0;
    for (i, color) in (0..90 * 60).zip(&pictures[0]) {
        let (x, y) = (i % 90, i / 90);
        let ray = camera.ray(x, y, 90, 60);
        let hits = solids.iter().filter_map(|solid| Some((solid.nearest(&ray, 0.0)?.t, solid.color())));
        let nearest = hits.min_by(|(a, _), (b, _)| a.total_cmp(b)).map_or(Rgb::BLACK, |(_, color)| color);
        assert_eq!(*color, Rgb888::paint(nearest, x, y), "column {x}, row {y}");
        covered += usize::from(nearest != Rgb::BLACK);
    }
    assert!(covered > 500, "{covered}");
    for picture in &pictures {
        assert!(*picture == pictures[0]);
    }
}

/// A display's own error comes through.
#[test]
fn an_error_of_the_display_passes_through() {
    struct Broken;
    impl OriginDimensions for Broken {
        fn size(&self) -> Size {
            Size::new(4, 4)
        }
    }
    impl DrawTarget for Broken {
        type Color = Gray4;
        type Error = &'static str;
        fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, _: I) -> Result<(), &'static str> {
            Err("cable")
        }
    }
    assert_eq!(scenes::VASE_SCENE.draw(&mut Broken), Err("cable"));
}

/// The laboratory asks for the feature `std`; alone, the crate is built without, and all of this file holds
/// as well: the pictures in the documents are the same.
#[test]
#[ignore = "for `cargo test -p embedded-lathe --test pictures -- --include-ignored`, without std"]
fn all_of_this_is_without_std() {
    if cfg!(feature = "std") {
        panic!("the crate is built with its feature std");
    }
}

/// The pictures in the documents are what is drawn now.
#[test]
fn the_pictures_in_the_documents_are_up_to_date() {
    for (name, scene) in scenes::NAMED {
        let path = format!("{}/docs/{name}.png", env!("CARGO_MANIFEST_DIR"));
        let kept =
            SimulatorDisplay::<Rgb888>::load_png(&path).unwrap_or_else(|error| panic!("{path}: {error:?}"));
        assert!(
            kept == drawn::<Rgb888>(scene, 240, 240),
            "{path}: run `cargo run --release --example pictures`"
        );
    }
}

/// By its numbers, as they are written there.
#[test]
fn the_readme_lists_the_bottle_and_the_vase_that_it_shows() {
    let readme = include_str!("../README.md");
    let points = scenes::BOTTLE_POINTS.map(|(height, radius)| format!("({height:?}, {radius:?})")).join(", ");
    assert!(readme.contains(&points), "{points}");
    assert!(readme.contains("](docs/bottle.png)"));
    for numbers in [&scenes::VASE_KNOTS[..], &scenes::VASE_ORDINATES] {
        let listed = format!("&{numbers:?}");
        assert!(readme.contains(&listed), "{listed}");
    }
    assert!(readme.contains("](docs/vase.png)"));
}

/// A ball of light and shade in sixteen grays, dithered, to read with the eye.
#[test]
fn a_ball_in_sixteen_greys() {
    static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    let solids = [Solid::new(&BALL, Rgb::WHITE)];
    let scene = Scene::new(
        &solids,
        valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.1)),
        valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    );
    let mut display = MockDisplay::<Gray4>::new();
    let ball = scene.picture(16, 16).image::<Gray4>();
    ball.draw(&mut display).unwrap();
    display.assert_pattern(&[
        "0000000000000000",
        "00000DECCA800000",
        "000EEFDDCB974000",
        "00EFFEEDCB976200",
        "00EFEEDDBA975300",
        "0DFEEDDCBA975220",
        "0DDEDDCBA9764210",
        "0CDDDCCAA8754120",
        "0BCCBBA987542210",
        "0ABBBA9875532120",
        "0899997755321210",
        "0077876543212100",
        "0045554322121200",
        "0002322121212000",
        "0000021212100000",
        "0000000000000000",
    ]);
}

/// A gray of so much light, over 64 pixels of each display: its mean is the light, as near as the shades
/// allow.
#[test]
fn few_shades_are_dithered() {
    fn mean<C: Paint>(share: f32, light: impl Fn(C) -> f32) -> f32 {
        (0..64).map(|i| light(C::paint(Rgb::gray(share), i % 8, i / 8))).sum::<f32>() / 64.0
    }
    for step in 0..=100 {
        let share = step as f32 / 100.0;
        // Half of 1/64 of a shade, and the weights of the luma add up to 1 but for rounding.
        let close = |mean: f32, shades: f32| (mean - share).abs() <= (0.5 / 64.0 + 1e-4) / shades;
        assert!(close(mean(share, |c: BinaryColor| f32::from(u8::from(c.is_on()))), 1.0), "{share}");
        assert!(close(mean(share, |c: Gray2| f32::from(c.luma()) / 3.0), 3.0), "{share}");
        assert!(close(mean(share, |c: Gray4| f32::from(c.luma()) / 15.0), 15.0), "{share}");
        let gray8 = Gray8::paint(Rgb::gray(share), 3, 5);
        assert!((f32::from(gray8.luma()) / 255.0 - share).abs() <= 0.501 / 255.0);
    }
    for (share, off) in [(f32::NAN, 0), (-3.0, 0), (7.0, 31), (f32::INFINITY, 31)] {
        assert_eq!(Rgb565::paint(Rgb::gray(share), 0, 0).r(), off);
    }
}

/// Of the reference scenes and of a white ball in a light that leaves no shade: a highlight adds light, up to
/// white.
#[test]
fn gloss_only_brightens() {
    static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    let solids = [Solid::new(&BALL, Rgb::WHITE).shiny(5)];
    let ball = Scene::new(
        &solids,
        valid!(Camera::perspective([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 0.3)),
        valid!(Light::new([0.0, -1.0, 0.3], 1.0)),
    );
    for scene in [&scenes::BOWL_SCENE, &scenes::STILL_LIFE, &ball] {
        let matt: Vec<_> = scene.solids.iter().map(|solid| solid.shiny(0)).collect();
        let matt = rows(&scene.with_solids(&matt), 60, 60, &[60], Rgb888::BLACK);
        let shiny = rows(scene, 60, 60, &[60], Rgb888::BLACK);
        let channels = |pixel: &Rgb888| [pixel.r(), pixel.g(), pixel.b()];
        let pairs = || matt.iter().flat_map(channels).zip(shiny.iter().flat_map(channels));
        assert!(pairs().all(|(matt, shiny)| matt <= shiny));
        assert!(pairs().any(|(_, shiny)| shiny == 255));
    }
}

#[test]
fn the_nearer_solid_hides_the_farther_whatever_their_order() {
    static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    let red = Solid::new(&BALL, Rgb::new(1.0, 0.0, 0.0));
    let far = valid!(Pose::new([0.4, 4.0, 0.0], Rotation::IDENTITY, 2.0));
    let green = Solid::new(&BALL, Rgb::new(0.0, 1.0, 0.0)).posed(far);
    fn scene<'a>(solids: &'a [Solid<'a>]) -> Scene<'a> {
        Scene::new(
            solids,
            valid!(Camera::perspective([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 0.5)),
            valid!(Light::new([0.0, -1.0, 0.0], 0.2)),
        )
    }
    let one = drawn::<Rgb888>(&scene(&[red, green]), 40, 40);
    assert!(one == drawn::<Rgb888>(&scene(&[green, red]), 40, 40));
    assert!(one.get_pixel(Point::new(20, 20)).r() > 0);
    assert!(one.get_pixel(Point::new(29, 20)).g() > 0);
}

#[test]
fn a_scene_needs_numbers() {
    use SceneError::{
        Ambient, HalfWidth, LightDirection, Position, RotationAngle, RotationAxis, Scale, UpDirection,
        ViewDirection,
    };
    let (up, eye, origin) = ([0.0, 0.0, 1.0], [0.0, -2.0, 0.0], [0.0; 3]);
    let nan = [f32::NAN; 3];
    for (eye, look_at) in [(eye, eye), (nan, origin), (eye, nan)] {
        assert_eq!(Camera::perspective(eye, look_at, up, 0.3), Err(ViewDirection { eye, look_at }));
    }
    for up in [origin, [0.0, 3.0, 0.0], nan] {
        assert_eq!(Camera::perspective(eye, origin, up, 0.3), Err(UpDirection { up }));
    }
    for half_width in [0.0, 9e-7, 30.1, -1.0, f32::NAN, f32::INFINITY] {
        let limits = HalfWidth { half_width, least: 1e-6, most: 30.0 };
        assert_eq!(Camera::perspective(eye, origin, up, half_width), Err(limits));
    }
    for half_width in [0.0, 9e-16, 1.1e15, -1.0, f32::NAN, f32::INFINITY] {
        let limits = HalfWidth { half_width, least: 1e-15, most: 1e15 };
        assert_eq!(Camera::orthographic(eye, origin, up, half_width), Err(limits));
    }
    for towards in [origin, nan] {
        assert_eq!(Light::new(towards, 0.1), Err(LightDirection { towards }));
    }
    for ambient in [1.5, -0.1, f32::NAN] {
        assert_eq!(Light::new(up, ambient), Err(Ambient { ambient }));
    }
    let position = [f32::INFINITY, 0.0, 0.0];
    assert_eq!(Pose::new(position, Rotation::IDENTITY, 1.0), Err(Position { position }));
    for angle in [f32::NAN, f32::INFINITY, 10_001.0, -1e9] {
        let wrong = SceneError::Rotation { row: 1, elements: [0.0, f32::NAN, f32::NAN] };
        assert_eq!(Pose::new(origin, Rotation::about_x(angle), 1.0), Err(wrong));
        let wrong = SceneError::Rotation { row: 0, elements: [f32::NAN, f32::NAN, 0.0] };
        assert_eq!(Pose::new(origin, Rotation::about_z(angle), 1.0), Err(wrong));
        assert_eq!(Rotation::about(up, angle), Err(RotationAngle { angle }));
    }
    for scale in [0.0, 1e-31, 1e31, -1.0, f32::NAN] {
        assert_eq!(Pose::new(origin, Rotation::IDENTITY, scale), Err(Scale { scale }));
    }
    for axis in [origin, nan] {
        assert_eq!(Rotation::about(axis, 1.0), Err(RotationAxis { axis }));
    }
}

#[test]
fn a_message_of_a_scene_reads_well() {
    let message = |error: SceneError| error.to_string();
    let limits = Camera::perspective([0.0, -2.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 31.0).unwrap_err();
    assert_eq!(
        message(limits),
        "the half-width of this kind of camera must be from 1e-6 to 30.0, and is 31.0"
    );
    let lost = Pose::new([0.0; 3], Rotation::about_x(20_000.0), 1.0).unwrap_err();
    assert_eq!(
        message(lost),
        "the rotation must be by angles from -10000 to 10000, which make its matrix finite; row 1 is [0.0, NaN, NaN]"
    );
    let nowhere = Camera::perspective([1.0; 3], [1.0; 3], [0.0, 0.0, 1.0], 0.3).unwrap_err();
    assert_eq!(
        message(nowhere),
        "the camera must look from one finite point at another, not from [1.0, 1.0, 1.0] at [1.0, 1.0, 1.0]"
    );
}

/// What solids, poses, cameras, lights and scenes are made of, they give back.
#[test]
fn parts_of_a_scene_can_be_asked_for() {
    let turn = Rotation::about_x(0.4).then(Rotation::about_z(1.0));
    let pose = Pose::new([1.0, -2.0, 3.0], turn, 0.7).unwrap();
    assert_eq!((pose.position(), pose.rotation(), pose.scale()), ([1.0, -2.0, 3.0], turn, 0.7));
    assert_eq!((Pose::default(), Rotation::default()), (Pose::IDENTITY, Rotation::IDENTITY));

    let plain = Solid::new(&scenes::BALL, Rgb::WHITE);
    assert_eq!((plain.pose(), plain.color(), plain.shininess()), (Pose::IDENTITY, Rgb::WHITE, 0));
    let solid = plain.posed(pose).colored(scenes::CLAY).shiny(9);
    assert_eq!((solid.pose(), solid.color(), solid.shininess()), (pose, scenes::CLAY, 9));
    let ball: &Lathe = &scenes::BALL;
    assert!(core::ptr::eq(solid.lathe(), ball));
    assert!(solid != plain && solid.posed(Pose::IDENTITY).colored(Rgb::WHITE).shiny(0) == plain);

    let light = Light::new([0.0, -4.0, 3.0], 0.25).unwrap();
    let [x, y, z] = light.towards();
    assert!(x == 0.0 && (y + 0.8).abs() < 1e-7 && (z - 0.6).abs() < 1e-7, "{:?}", light.towards());
    assert_eq!(light.ambient(), 0.25);

    // Looking along y, z upwards: x is to the right.
    let camera = Camera::perspective([0.5, -2.0, 0.25], [0.5, 1.0, 0.25], [0.0, 0.1, 1.0], 0.375).unwrap();
    assert_eq!((camera.eye(), camera.forward()), ([0.5, -2.0, 0.25], [0.0, 1.0, 0.0]));
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-7);
    assert!(near(camera.right(), [0.375, 0.0, 0.0]), "{:?}", camera.right());
    assert!(near(camera.up(), [0.0, 0.0, 0.375]), "{:?}", camera.up());

    let solids = [solid];
    let scene = Scene::new(&solids, camera, light);
    assert_eq!((scene.solids, scene.camera, scene.light), (&solids[..], camera, light));
    assert_eq!((scene.background, Background::default()), (Background::Plain(Rgb::BLACK), Background::BLACK));
    let mut other =
        scenes::VASE_SCENE.with_solids(&solids).with_camera(camera).with_background(Background::BLACK);
    assert!(other != scene && other.with_light(light) == scene);
    other.light = light;
    assert_eq!(other, scene);
}

/// A display's color is a solid's, by `From` and in a `const`, and is painted as itself again.
#[test]
fn colors_of_displays_are_those_of_solids() {
    fn back_and_forth<C: Paint + Into<Rgb> + PartialEq + core::fmt::Debug>(all: impl Iterator<Item = C>) {
        for color in all {
            assert_eq!(C::paint(color.into(), 0, 0), color);
        }
    }
    let bytes = || (0..=255).flat_map(|i: u8| [[i, 255 - i, i / 2], [i ^ 0x55, i, 255 - i]]);
    back_and_forth(bytes().map(|[r, g, b]| Rgb888::new(r, g, b)));
    back_and_forth(bytes().map(|[r, g, b]| Bgr888::new(r, g, b)));
    back_and_forth(bytes().map(|[r, g, b]| Rgb666::new(r, g, b)));
    back_and_forth(bytes().map(|[r, g, b]| Rgb565::new(r, g, b)));
    back_and_forth(bytes().map(|[r, g, b]| Bgr555::new(r, g, b)));
    back_and_forth((0..=255).map(Gray8::new));
    back_and_forth((0..16).map(Gray4::new));
    back_and_forth((0..4).map(Gray2::new));
    back_and_forth([BinaryColor::Off, BinaryColor::On].into_iter());
    for [r, g, b] in bytes() {
        let color = Rgb::from_rgb888(Rgb888::new(r, g, b));
        assert_eq!((color, color), (Rgb::from_u8(r, g, b), Rgb888::new(r, g, b).into()));
    }
    assert_eq!(Rgb::from(Rgb565::new(31, 21, 0)), Rgb::new(1.0, 1.0 / 3.0, 0.0));
}

/// By `Point` and `Size`, the same pictures and rays as by numbers; and rays beside the picture.
#[test]
fn points_and_sizes_are_those_of_embedded_graphics() {
    let scene = &scenes::VASE_SCENE;
    assert_eq!(scene.picture_of(Size::new(31, 17)), scene.picture(31, 17));
    let camera = scene.camera;
    assert_eq!(camera.ray_at(Point::new(3, 9), Size::new(31, 17)), camera.ray(3, 9, 31, 17));
    // One column to the left of the first is as far from it as the second.
    let [left, first, second] =
        [-1, 0, 1].map(|x| camera.ray_at(Point::new(x, 4), Size::new(32, 32)).direction());
    for i in 0..3 {
        assert!(
            ((first[i] - left[i]) - (second[i] - first[i])).abs() < 1e-6,
            "{left:?} {first:?} {second:?}"
        );
    }
    assert!(first != left);
}

/// A picture that is no pixel wide has no pixels; the ray through any of them is that through its middle.
#[test]
fn a_ray_of_a_picture_of_no_width_is_a_ray() {
    let eye = [1.0, -2.0, 0.5];
    let perspective = Camera::perspective(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.3).unwrap();
    let orthographic = Camera::orthographic(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.3).unwrap();
    for camera in [perspective, orthographic] {
        let middle = camera.ray(0, 0, 1, 1);
        for (x, y, height) in [(0, 0, 0), (0, 0, 9), (7, 3, 9), (u32::MAX, u32::MAX, u32::MAX)] {
            assert_eq!(camera.ray(x, y, 0, height), middle, "{x}, {y}, {height}");
        }
        // No rows: as high as none, so a ray above or below the middle, and one across it.
        let ray = camera.ray(3, 0, 7, 0);
        assert!([ray.origin(), ray.direction()].as_flattened().iter().all(|c| c.is_finite()));
    }
}

/// Against the standard library's functions, in f64: two roundings of each.
#[test]
fn rotations_turn_by_their_angle() {
    for (step, width) in (-1000..=1000).flat_map(|step| [(step, 0.0173), (step, 10.0)]) {
        let angle = step as f32 * width;
        let (sin, cos) = f64::from(angle).sin_cos();
        let x = Rotation::about_x(angle).apply([0.0, 1.0, 0.0]);
        let y = Rotation::about_y(angle).apply([0.0, 0.0, 1.0]);
        let z = Rotation::about_z(angle).apply([1.0, 0.0, 0.0]);
        for (c, s) in [(x[1], x[2]), (y[2], y[0]), (z[0], z[1])] {
            let off = (f64::from(c) - cos).abs().max((f64::from(s) - sin).abs());
            assert!(off < 2e-7, "{angle}: {off:e}");
        }
        let about = Rotation::about([0.0, 0.0, 2.0], angle).unwrap().apply([1.0, 0.0, 0.0]);
        assert!((about[0] - z[0]).abs() < 2e-7 && (about[1] - z[1]).abs() < 2e-7);
    }
}

/// All names of this crate and of embedded-graphics' prelude at once, in either order.
#[deny(warnings)]
mod both_preludes {
    macro_rules! draws {
        ($first:path, $second:path) => {
            use $first::*;
            use $second::*;

            #[test]
            fn a_line_and_a_scene() {
                use embedded_graphics::image::Image;
                use embedded_graphics::mock_display::MockDisplay;
                use embedded_graphics::pixelcolor::Gray4;
                use embedded_graphics::primitives::{Line, PrimitiveStyle};

                let mut display = MockDisplay::<Gray4>::new();
                let style = PrimitiveStyle::with_stroke(Gray4::WHITE, 1);
                Line::new(Point::zero(), Point::new(9, 0)).into_styled(style).draw(&mut display).unwrap();
                let scene = Scene::new(
                    &[],
                    valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
                    valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
                )
                .with_background(Background::Plain(Rgb::WHITE));
                let image = scene.picture(4, 4).image::<Gray4>();
                Image::new(&image, Point::new(0, 10)).draw(&mut display).unwrap();
                for place in [Point::new(9, 0), Point::new(3, 13)] {
                    assert_eq!(display.get_pixel(place), Some(Gray4::WHITE));
                }
            }
        };
    }

    mod lathe_first {
        draws!(embedded_lathe, embedded_graphics::prelude);
    }
    mod graphics_first {
        draws!(embedded_graphics::prelude, embedded_lathe);
    }
}
