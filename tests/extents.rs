//! Where solids are in a picture: points projected, rectangles that hold every pixel, cameras that frame, and what is under a
//! pixel. The truth are single rays, one through each pixel.

#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code)]
mod scenes;

mod random;

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_lathe::{
    Background, Camera, Light, Pick, Picture, Pose, Profile, Rgb, Rotation, Scene, SceneError, Sheet, Solid,
    valid,
};
use embedded_lathe::{End, Lathe, Segment};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

/// Pixels as `[left, top, right, bottom]`, the last two not included.
fn corners(area: &Rectangle) -> [i64; 4] {
    let (left, top) = (i64::from(area.top_left.x), i64::from(area.top_left.y));
    [left, top, left + i64::from(area.size.width), top + i64::from(area.size.height)]
}

/// The smallest rectangle that holds the pixels whose rays hit; `None` if none does.
fn hit_pixels(picture: &Picture, is_hit: impl Fn(u32, u32) -> bool) -> Option<[i64; 4]> {
    let mut seen: Option<[i64; 4]> = None;
    for y in 0..picture.height() {
        for x in (0..picture.width()).filter(|&x| is_hit(x, y)) {
            let (x, y) = (i64::from(x), i64::from(y));
            let [left, top, right, bottom] = seen.unwrap_or([x, y, x + 1, y + 1]);
            seen = Some([left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1)]);
        }
    }
    seen
}

/// By how many pixels a rectangle is wider than it need be, at most, on any side. `None` if neither has a pixel.
fn wider(area: &Rectangle, seen: Option<[i64; 4]>, what: &str) -> Option<i64> {
    let [left, top, right, bottom] = corners(area);
    let Some(seen) = seen else {
        return (!area.is_zero_sized()).then_some((right - left).max(bottom - top));
    };
    let over = [seen[0] - left, seen[1] - top, right - seen[2], bottom - seen[3]];
    assert!(over.iter().all(|&pixels| pixels >= 0), "{what}: {area:?} does not hold {seen:?}");
    over.into_iter().max()
}

fn solid_is_hit(picture: &Picture, solid: &Solid, x: u32, y: u32) -> bool {
    let ray = picture.scene().camera.ray(x, y, picture.width(), picture.height());
    solid.nearest(&ray, 0.0).is_some()
}

#[test]
fn a_rectangle_holds_its_solid_closely() {
    for ((name, scene), (width, height)) in
        scenes::NAMED.into_iter().flat_map(|named| [(101, 67), (240, 240)].map(|size| (named, size)))
    {
        let picture = scene.picture(width, height);
        let mut all: Option<[i64; 4]> = None;
        for (i, solid) in scene.solids.iter().enumerate() {
            let seen = hit_pixels(&picture, |x, y| solid_is_hit(&picture, solid, x, y));
            let what = format!("{name}, {width}×{height}, solid {i}");
            let wider = wider(&picture.covered_by(solid), seen, &what);
            assert!(wider.is_some_and(|pixels| pixels <= 1), "{what}: {wider:?} pixels wider");
            let [a, b, c, d] = all.or(seen).unwrap();
            all = seen.map(|[e, f, g, h]| [a.min(e), b.min(f), c.max(g), d.max(h)]).or(all);
        }
        let wider = wider(&picture.covered(), all, name);
        assert!(wider.is_some_and(|pixels| pixels <= 1), "{name}: {wider:?} pixels wider");
    }
}

/// Single solids through rays; whole scenes through the rows that are painted: a pixel whose color is not the
/// background's shows a solid.
#[test]
fn a_rectangle_holds_whatever_is_seen() {
    const SEA: Rgb = Rgb::new(0.0, 1.0, 1.0);
    let mut rng = ChaCha8Rng::seed_from_u64(23);
    let (mut whole, mut none, mut cut_off, mut loose, mut tight) = (0, 0, 0, 0, 0);
    for case in 0..200 {
        let lathes = random::random_lathes(&mut rng);
        let mut solids = random::posed(&mut rng, &lathes);
        let mut camera =
            if case % 3 == 0 { random::upright_camera(&mut rng) } else { random::random_camera(&mut rng) };
        if case % 5 == 4 {
            // Far from the origin, where positions are rounded; or all of it tiny or huge.
            let is_far = case % 2 == 0;
            let size = if is_far { 1.0 } else { 10_f32.powi(rng.random_range(-18..18)) };
            let away = if is_far { [3000.0, -2000.0, 1000.0] } else { [0.0; 3] };
            let place = |p: [f32; 3]| [0, 1, 2].map(|i| size * p[i] + away[i]);
            solids.iter_mut().for_each(|solid| {
                let (pose, scale) = (solid.pose(), solid.pose().scale() * size);
                *solid = solid.posed(Pose::new(place(pose.position()), pose.rotation(), scale).unwrap());
            });
            let (eye, ahead) = (camera.eye(), camera.forward());
            let target = [0, 1, 2].map(|i| eye[i] + ahead[i]);
            let half_width = camera.right().iter().map(|c| c * c).sum::<f32>().sqrt();
            camera = Camera::perspective(place(eye), place(target), camera.up(), half_width).unwrap();
        }
        let scene = Scene::new(&solids, camera, valid!(Light::new([0.0, 0.0, 1.0], 0.5)))
            .with_background(Background::Plain(SEA));
        let picture = scene.picture(rng.random_range(1..60), rng.random_range(1..50));
        let size = Size::new(picture.width(), picture.height());
        for (i, solid) in solids.iter().enumerate() {
            let seen = hit_pixels(&picture, |x, y| solid_is_hit(&picture, solid, x, y));
            let area = picture.covered_by(solid);
            match wider(&area, seen, &format!("case {case}, solid {i}, {camera:?}")) {
                None => none += 1,
                Some(_) if area.size == size => whole += 1,
                // Of a solid that is cut off at an edge, what is left may not reach as far as the whole.
                Some(_) if is_at_an_edge(&area, size) => cut_off += 1,
                Some(0 | 1) => tight += 1,
                Some(_) => loose += 1,
            }
        }
        let mut pixels = vec![Rgb::BLACK; (size.width * size.height) as usize];
        for (y, row) in pixels.chunks_mut(size.width as usize).enumerate() {
            picture.row(y as u32, row);
        }
        let seen = hit_pixels(&picture, |x, y| pixels[(y * size.width + x) as usize] != SEA);
        wider(&picture.covered(), seen, &format!("case {case}, {camera:?}"));
    }
    println!(
        "{tight} tight, {loose} looser, {cut_off} cut off, {whole} the whole picture, {none} without pixels"
    );
    // Solids, or parts of them, that are thinner than a pixel have looser ones.
    assert!(tight > 10 * loose && whole < 2 * tight && none > 10, "{tight}, {loose}, {whole}, {none}");
}

fn is_at_an_edge(area: &Rectangle, size: Size) -> bool {
    let [left, top, right, bottom] = corners(area);
    left == 0 || top == 0 || right == i64::from(size.width) || bottom == i64::from(size.height)
}

/// Bodies, endless sheets, rings beyond the wall, and pictures without pixels.
#[test]
fn rectangles_of_odd_solids() {
    static FLANGED: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::from_squared_radii(
        &[0.0, 0.0, 1.0, 1.0],
        &[0.25, 0.04, 0.04, 0.04, 0.04, 0.36]
    )));
    static SHEET: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(0.3, 0.5)?.squash(0.0)?));
    static WALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(0.2, 0.5)));
    const TALL: Profile<1> = valid!(Profile::cylinder(0.1, 0.9)?.base(End::Open));
    static INSIDE: Lathe<[Segment; 1]> = Lathe::turn_beside(TALL, &valid!(Profile::<1>::cylinder(0.2, 0.5)));
    static SHEETS: [Sheet; 2] = [Sheet::outer(&WALL), Sheet::inner(&INSIDE)];
    let body = Solid::body(&SHEETS, Rgb::WHITE).unwrap();
    let front = Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.0).unwrap();
    let picture = Scene::new(&[], front, scenes::DAYLIGHT).picture(100, 100);
    let area = |x, y, width, height| Rectangle::new(Point::new(x, y), Size::new(width, height));
    assert_eq!(picture.covered(), Rectangle::zero());
    // The lower flange has radius 0.5, the upper 0.6; rows 49 and 50 are at ±0.01, and each is 0.02 high.
    for (solid, truth) in [
        (Solid::new(&FLANGED, Rgb::WHITE), area(20, 0, 60, 50)),
        (Solid::new(&SHEET, Rgb::WHITE), area(0, 0, 100, 100)),
        (body, area(40, 5, 20, 45)),
    ] {
        assert_eq!(
            wider(&picture.covered_by(&solid), Some(corners(&truth)), "odd"),
            Some(0),
            "{:?}",
            picture.covered_by(&solid)
        );
        for (width, height) in [(0, 5), (5, 0), (0, 0)] {
            let none = Scene::new(&[solid], front, scenes::DAYLIGHT).picture(width, height).covered();
            assert_eq!(none, Rectangle::zero());
        }
    }
    // Behind the camera; and around it: then it is the whole picture.
    let away = Camera::orthographic([0.0, 5.0, 0.0], [0.0, 6.0, 0.0], [0.0, 0.0, 1.0], 1.0).unwrap();
    let within = Camera::perspective([0.0, 0.0, 0.25], [0.0, 1.0, 0.25], [0.0, 0.0, 1.0], 0.1).unwrap();
    let picture = |camera| Scene::new(&[], camera, scenes::DAYLIGHT).picture(9, 7);
    assert_eq!(picture(away).covered_by(&body), Rectangle::zero());
    assert_eq!(picture(within).covered_by(&body), area(0, 0, 9, 7));
    // Sizes beyond the coordinates of embedded-graphics.
    let vast = scenes::VASE_SCENE.picture(u32::MAX, u32::MAX).covered();
    assert!(vast.size.width > 1 << 30 && vast.top_left.x >= 0);
}

/// A point of the world, and the pixel whose ray passes nearest to it.
#[test]
fn a_projected_point_is_where_its_ray_is() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let (mut ahead, mut behind) = (0, 0);
    for case in 0..2000 {
        let camera = random::random_camera(&mut rng);
        let (width, height) = (rng.random_range(1..300), rng.random_range(1..300));
        let (x, y) = (rng.random_range(0..width), rng.random_range(0..height));
        let ray = camera.ray(x, y, width, height);
        let point = ray.at(random::even(&mut rng, 0.1, 9.0));
        let found = camera.project(point, width, height).unwrap();
        // A pixel is 2·half-width/width wide at unit distance; a point is rounded relative to its coordinates.
        let size =
            9.0 * 2_f32.powi(-22) * width as f32 / camera.right().iter().map(|c| c.abs()).fold(0.0, f32::max);
        let off = (found[0] - x as f32).abs().max((found[1] - y as f32).abs());
        assert!(off < 1e-3 + 16.0 * size, "case {case}: {found:?}, not {x}, {y}; {camera:?}");
        let pixel = camera.pixel_of(point, Size::new(width, height)).unwrap();
        assert!(
            (pixel - Point::new(x as i32, y as i32)).abs().component_max(Point::zero()) == Point::zero()
                || size > 0.01
        );
        ahead += 1;
        assert_eq!(camera.project(ray.at(-1.0), width, height), None);
        behind += 1;
    }
    assert_eq!(ahead, behind);
    let camera = scenes::VASE_SCENE.camera;
    for point in [[f32::NAN, 0.0, 0.0], [f32::INFINITY; 3], camera.eye()] {
        assert_eq!(camera.project(point, 240, 240), None);
    }
    assert_eq!(camera.project([0.0; 3], 0, 240), None);
    // Half a pixel is rounded up, on either side of zero, and far pixels saturate.
    let flat = Camera::orthographic([0.0, -1.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 4.0).unwrap();
    let pixel = |x| flat.pixel_of([x, 0.0, 0.0], Size::new(8, 1)).unwrap().x;
    assert_eq!(
        [-5.25, -5.0, -4.75, 0.0, 0.25, 1e20, -1e20].map(pixel),
        [-2, -1, -1, 4, 4, i32::MAX, i32::MIN]
    );
}

/// That no ray beside the picture hits a solid. Returns whether the solids fill three quarters of its width or height.
fn is_framed(solids: &[Solid], camera: Camera, (width, height): (u32, u32), what: &str) -> bool {
    let is_hit = |x: i32, y: i32| {
        let ray = camera.ray_at(Point::new(x, y), Size::new(width, height));
        solids.iter().any(|solid| solid.nearest(&ray, 0.0).is_some())
    };
    let (right, bottom) = (width as i32, height as i32);
    for x in -9..right + 9 {
        assert!(!is_hit(x, -1) && !is_hit(x, bottom), "{what}: column {x}");
    }
    for y in -9..bottom + 9 {
        assert!(!is_hit(-1, y) && !is_hit(right, y), "{what}: row {y}");
    }
    let covered = Scene::new(solids, camera, scenes::DAYLIGHT).picture(width, height).covered().size;
    4 * covered.width > 3 * width || 4 * covered.height > 3 * height
}

/// No pixel beside the picture hits a solid, and the solids fill what they can.
#[test]
fn a_framing_camera_holds_all_solids() {
    let mut rng = ChaCha8Rng::seed_from_u64(31);
    let mut full = 0;
    for case in 0..200 {
        let lathes = random::random_lathes(&mut rng);
        let solids = random::posed(&mut rng, &lathes);
        let before =
            if case % 2 == 0 { random::upright_camera(&mut rng) } else { random::random_camera(&mut rng) };
        let (width, height) = (rng.random_range(20..50), rng.random_range(20..50));
        let camera = before.framing(&solids, width, height).unwrap();
        assert_eq!(camera.forward(), before.forward());
        // The cylinders touch two opposite edges of what may be filled; some solids are well within theirs.
        full += usize::from(is_framed(&solids, camera, (width, height), &format!("case {case}")));
    }
    for ((name, scene), size) in
        scenes::NAMED.into_iter().flat_map(|named| [(named, (240, 240)), (named, (31, 70))])
    {
        let camera = scene.camera.framing(scene.solids, size.0, size.1).unwrap();
        assert!(is_framed(scene.solids, camera, size, name), "{name}");
    }
    assert!(full > 150, "{full}");
    let camera = scenes::VASE_SCENE.camera;
    let error = |solids, width, height| camera.framing(solids, width, height).unwrap_err();
    for (solids, width, height) in
        [(&[][..], 9, 9), (scenes::VASE_SCENE.solids, 0, 9), (scenes::VASE_SCENE.solids, 9, 0)]
    {
        let nothing = SceneError::NothingToFrame { solids: solids.len(), width, height };
        assert_eq!(error(solids, width, height), nothing);
    }
    let sheet = Lathe::turn(Profile::<1>::cylinder(0.3, 0.5).unwrap().squash(0.0).unwrap());
    let solids = [scenes::VASE_SCENE.solids[0], Solid::new(&sheet, Rgb::WHITE)];
    assert_eq!(error(&solids, 9, 9), SceneError::Endless { solid: 1 });
    let large = [solids[0].posed(Pose::new([0.0; 3], Rotation::IDENTITY, 1e30).unwrap())];
    let flat = Camera::orthographic([0.0, -1.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.0).unwrap();
    assert!(matches!(flat.framing(&large, 9, 9), Err(SceneError::HalfWidth { .. })));
}

/// What is picked is the nearest of all solids' hits, and outside the picture there is nothing to pick.
#[test]
fn what_is_under_a_pixel_is_what_it_shows() {
    let mut rng = ChaCha8Rng::seed_from_u64(77);
    let mut picked = [0; 3];
    let mut check = |scene: &Scene, case: &str| {
        let solids = scene.solids;
        let size = Size::new(24, 18);
        for (x, y) in (-1..25).flat_map(|x| (-1..19).map(move |y| (x, y))) {
            let found = scene.pick(Point::new(x, y), size);
            let ray = scene.camera.ray_at(Point::new(x, y), size);
            let hits =
                solids.iter().enumerate().filter_map(|(i, solid)| Some((i, solid.nearest(&ray, 0.0)?)));
            let nearest = hits.min_by(|(_, a), (_, b)| a.t.total_cmp(&b.t));
            let is_within = (0..24).contains(&x) && (0..18).contains(&y);
            let truth = nearest.filter(|_| is_within);
            assert_eq!(found.map(|Pick { solid, hit, .. }| (solid, hit)), truth, "case {case}: {x}, {y}");
            assert_eq!(
                scene
                    .picture(24, 18)
                    .at::<embedded_graphics::pixelcolor::Rgb565>(Point::new(7, -3))
                    .pick(Point::new(x + 7, y - 3)),
                found
            );
            picked[found.map_or(0, |pick| 1 + pick.solid.min(1))] += 1;
        }
    };
    scenes::NAMED.into_iter().for_each(|(name, scene)| check(scene, name));
    for case in 0..200 {
        let lathes = random::random_lathes(&mut rng);
        let solids = random::posed(&mut rng, &lathes);
        let scene = Scene::new(&solids, random::random_camera(&mut rng), scenes::DAYLIGHT);
        check(&scene, &format!("case {case}"));
    }
    assert!(picked.iter().all(|&pixels| pixels > 1000), "{picked:?}");
    // The pick says which sheet of a body it is.
    const OUTSIDE: Profile<1> = valid!(Profile::cylinder(0.4, 0.8)?.top(End::Open));
    static SHEETS: [Lathe<[Segment; 1]>; 2] = [
        Lathe::turn(OUTSIDE),
        Lathe::turn_beside(
            valid!(Profile::from_squared_radii(&[0.1, 0.8], &[0.09, 0.1, 0.12, 0.16])?.base(End::Capped)),
            &OUTSIDE,
        ),
    ];
    static CUP: [Sheet; 2] = [Sheet::outer(&SHEETS[0]), Sheet::inner(&SHEETS[1])];
    let solids = [Solid::body(&CUP, Rgb::WHITE).unwrap()];
    let above = Camera::perspective([0.0, -2.0, 2.0], [0.0, 0.0, 0.6], [0.0, 0.0, 1.0], 0.3).unwrap();
    let scene = Scene::new(&solids, above, scenes::DAYLIGHT);
    let sheet = |y| scene.pick(Point::new(120, y), Size::new(240, 240)).map(|pick| pick.sheet);
    assert_eq!([sheet(100), sheet(200), sheet(2)], [Some(1), Some(0), None]);
}
