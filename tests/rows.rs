//! Rows of pixels, whose rays are reckoned together, against rays by themselves, over every backend.
//!
//! ```text
//! SCENES=20000 cargo test --release -p embedded-lathe --test rows random -- --nocapture       a hundred times as many, in a minute or two
//! SCENES=20000 cargo test --release -p embedded-lathe-in-integers --test rows random -- --nocapture       in integers
//! ```

mod promise;
mod random;
#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code)]
mod scenes;
mod shells;

use core::ops::Range;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_lathe::{
    Background, Camera, End, Lathe, Light, Paint, Pose, Profile, Ray, Rgb, Rotation, Scene, Segment, Sheet,
    Solid,
};
use promise::{PROMISE, unit};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use random::{even, random_camera, random_lathe, upright_camera};
use shells::random_shell;

const BLACK: Background = Background::Plain(Rgb::BLACK);

/// A scene's solids and light, as the test knows them: what a ray sees is reckoned here.
struct Known<'a> {
    scene: Scene<'a>,
    colors: &'a [Rgb],
    towards: [f32; 3],
    ambient: f32,
}

impl Known<'_> {
    /// What one ray by itself sees: Lambert's share of the nearest solid's color. Of two solids at the same
    /// distance, but for rounding, either: where one stands on another, their faces are each off by as many
    /// units as is promised of a hit's point, across the face.
    fn seen(&self, ray: &Ray) -> Vec<Rgb> {
        let solids = self.scene.solids.iter().zip(self.colors);
        let hits: Vec<_> =
            solids.filter_map(|(solid, color)| Some((solid.nearest(ray, 0.0)?, solid, color))).collect();
        let nearest = hits.iter().map(|(hit, ..)| hit.t).fold(f32::INFINITY, f32::min);
        let size = |v: [f32; 3]| v.iter().map(|c| c * c).sum::<f32>().sqrt();
        let seen = hits.iter().filter(|(hit, solid, _)| {
            let (direction, normal) = (ray.direction(), solid.surface(ray, hit).normal);
            let across = (0..3).map(|i| direction[i] * normal[i]).sum::<f32>().abs();
            let distances = size(ray.origin()) + hit.t * size(direction);
            hit.t <= nearest * (1.0 + 8.0 * f32::EPSILON)
                || f64::from((hit.t - nearest) * across) <= 2.0 * PROMISE * unit(2.0, distances.into())
        });
        let length = self.towards.iter().map(|c| c * c).sum::<f32>().sqrt();
        let colors = seen.map(|(hit, solid, color)| {
            let normal = solid.surface(ray, hit).normal;
            let side = if hit.enters { 1.0 } else { -1.0 };
            let color = solid.sheet_of(hit).color().unwrap_or(**color);
            let nl = side * (0..3).map(|i| normal[i] * self.towards[i]).sum::<f32>() / length;
            let share = self.ambient + (1.0 - self.ambient) * nl.max(0.0);
            Rgb::new(color.r * share, color.g * share, color.b * share)
        });
        colors.collect()
    }
}

/// How two pictures differ: in what they show, and by how many steps of a channel.
#[derive(Default, Debug)]
struct Difference {
    pixels: usize,
    covered: usize,
    mask: usize,
    one_step: usize,
    more: usize,
}

impl Difference {
    fn add(&mut self, known: &Known, side: u32, what: &str) {
        let picture = known.scene.picture(side, side);
        let mut row = vec![Rgb565::BLACK; side as usize];
        for y in 0..side {
            picture.row(y, &mut row);
            for (x, &pixel) in (0..).zip(&row) {
                let alone = known.seen(&known.scene.camera.ray(x, y, side, side));
                self.pixels += 1;
                self.covered += usize::from(!alone.is_empty());
                if (pixel == Rgb565::BLACK) != alone.is_empty() {
                    self.mask += 1;
                    println!("{what}: column {x}, row {y}: {pixel:?} instead of {alone:?}");
                    continue;
                }
                let steps = alone.iter().map(|&color| steps(pixel, Rgb565::paint(color, x, y)));
                match steps.min() {
                    Some(0) | None => {}
                    Some(1) => self.one_step += 1,
                    _ => {
                        self.more += 1;
                        println!("{what}: column {x}, row {y}: {pixel:?} instead of {alone:?}");
                    }
                }
            }
        }
    }

    fn assert_none(&self) {
        println!("{self:?}");
        assert_eq!((self.mask, self.more), (0, 0), "{self:?}");
        assert!(self.one_step * 10_000 <= self.pixels, "{self:?}");
        assert!(self.covered * 20 > self.pixels, "{self:?}");
    }
}

/// By how many steps two colors differ in any channel, at most.
fn steps(a: Rgb565, b: Rgb565) -> u8 {
    let channels = [(a.r(), b.r()), (a.g(), b.g()), (a.b(), b.b())];
    channels.map(|(one, other)| one.abs_diff(other)).into_iter().max().unwrap_or(0)
}

#[test]
fn the_reference_scenes_are_those_of_single_rays() {
    // The light of the scenes, their colors without gloss: the test knows no more than Lambert.
    let (towards, ambient) = ([-0.5, -0.7, 0.5], 0.15);
    for (name, scene) in scenes::NAMED {
        let matt: Vec<Solid> = scene.solids.iter().map(|solid| solid.shiny(0)).collect();
        let colors: Vec<Rgb> = matt.iter().map(Solid::color).collect();
        let scene = scene.with_solids(&matt).with_background(BLACK);
        let mut difference = Difference::default();
        difference.add(&Known { scene, colors: &colors, towards, ambient }, 240, name);
        difference.assert_none();
    }
}

/// As many as `SCENES` says, or two hundred; in integers five hundred.
fn number_of_scenes() -> u32 {
    let usual = if cfg!(embedded_lathe_arithmetic = "integers") { 500 } else { 200 };
    std::env::var("SCENES").map_or(usual, |number| number.parse().expect("a number"))
}

/// The random scenes of some numbers, each seen by such a camera: rows against single rays.
fn random_scenes(numbers: Range<u32>, side: u32, camera: impl Fn(&mut ChaCha8Rng) -> Camera) {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let mut difference = Difference::default();
    for number in 0..numbers.end {
        let lathes = [random_lathe(&mut rng), random_lathe(&mut rng)];
        let turn = Rotation::about([even(&mut rng, -1.0, 1.0), 0.3, 0.5], even(&mut rng, -3.0, 3.0)).unwrap();
        let away = Pose::new([even(&mut rng, -1.0, 1.0), 0.2, 0.1], turn, even(&mut rng, 0.3, 1.5)).unwrap();
        let colors = [Rgb::WHITE, Rgb::new(0.9, 0.5, 0.3)];
        let solids = [Solid::new(&lathes[0], colors[0]), Solid::new(&lathes[1], colors[1]).posed(away)];
        let towards = [even(&mut rng, -1.0, 1.0), -1.0, 0.5];
        let scene = Scene::new(
            &solids[..rng.random_range(1..=2)],
            camera(&mut rng),
            Light::new(towards, 0.2).unwrap(),
        );
        if numbers.contains(&number) {
            let known = Known { scene, colors: &colors, towards, ambient: 0.2 };
            difference.add(&known, side, &format!("scene {number}"));
        }
    }
    difference.assert_none();
}

#[test]
fn random_scenes_are_those_of_single_rays() {
    random_scenes(0..number_of_scenes(), 60, random_camera);
}

/// A waist as sharp as a blade, seen from within: rays that pass it within rounding leave by the open end beyond.
#[test]
fn a_sharp_waist_seen_from_within_is_that_of_single_rays() {
    random_scenes(12_950..12_951, 60, random_camera);
}

/// Parallel rays that graze the crease above a wall of 10⁻⁴: the error that a Newton step may leave, in units
/// of the wall's height, decides what they see.
#[test]
fn a_crease_above_a_low_wall_is_that_of_single_rays() {
    random_scenes(3_989..3_990, 60, random_camera);
}

/// Seen from within, a wall beside a sharp crease bends so much that the error of the root beyond decides
/// whether a ray grazes it.
#[test]
fn a_grazed_wall_before_a_tracked_root_is_that_of_single_rays() {
    random_scenes(37_052..37_053, 60, random_camera);
}

/// Parallel rays some of which begin before a cap, and their neighbours inside the solid.
#[test]
fn rays_that_begin_on_either_side_of_a_cap_are_those_of_single_rays() {
    random_scenes(19_660..19_661, 60, random_camera);
}

#[test]
fn random_upright_scenes_are_those_of_single_rays() {
    // An even number of columns: a row's halves may be each other's mirror image.
    random_scenes(0..number_of_scenes(), 48, upright_camera);
}

/// A cup with a flat rim, whose hollow has a color of its own; a torus; a mushroom with an undercut.
fn bodies() -> [Vec<(Profile<2>, bool, Option<Rgb>)>; 3] {
    let profile = |knots: &[f32], ordinates: &[f32]| Profile::from_squared_radii(knots, ordinates).unwrap();
    let white = Some(Rgb::new(0.9, 0.9, 0.7));
    [
        vec![
            (profile(&[0.0, 1.0, 1.0], &[0.16, 0.2, 0.22, 0.25, 0.2]).base(End::Capped), false, None),
            (profile(&[0.1, 1.0], &[0.12, 0.16, 0.18, 0.2]).base(End::Capped), true, white),
        ],
        vec![
            (profile(&[-0.25, 0.25], &[0.25, 0.62, 0.62, 0.25]), false, None),
            (profile(&[-0.25, 0.25], &[0.25, 0.05, 0.05, 0.25]), true, None),
        ],
        vec![
            (profile(&[0.4, 0.9], &[0.36, 0.4, 0.3, 0.0]), false, white),
            (profile(&[0.0, 0.5], &[0.04, 0.03, 0.03, 0.04]).base(End::Capped), false, None),
            (profile(&[0.4, 0.5, 0.5], &[0.36, 0.3, 0.3, 0.25, 0.04]), true, None),
        ],
    ]
}

/// The sheets of a body, given their lathes, and each one's side and color.
fn sheets_of<'a>(
    lathes: &'a [Lathe<[Segment; 2]>],
    sheets: &[(Profile<2>, bool, Option<Rgb>)],
) -> Vec<Sheet<'a>> {
    let sheet = |(lathe, (_, is_inner, color)): (&'a Lathe<[Segment; 2]>, &(_, bool, Option<Rgb>))| {
        let sheet = if *is_inner { Sheet::inner(lathe) } else { Sheet::outer(lathe) };
        color.map_or(sheet, |color| sheet.colored(color))
    };
    lathes.iter().zip(sheets).map(sheet).collect()
}

/// Bodies alone, beside solids, and through one another.
#[test]
fn bodies_are_those_of_single_rays() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let lathes = bodies().map(|sheets| {
        let turned = sheets.iter().map(|(profile, ..)| Lathe::turn_beside(*profile, &sheets[0].0));
        (turned.collect::<Vec<_>>(), sheets)
    });
    let sheets = lathes.each_ref().map(|(lathes, sheets)| sheets_of(lathes, sheets));
    let colors = [Rgb::new(0.9, 0.5, 0.3), Rgb::new(0.3, 0.4, 0.9)];
    let mut difference = Difference::default();
    for number in 0..number_of_scenes() / 4 {
        let other = random_lathe(&mut rng);
        let mut pose = || {
            let turn = Rotation::about_x(even(&mut rng, -3.0, 3.0))
                .then(Rotation::about_z(even(&mut rng, -3.0, 3.0)));
            Pose::new([even(&mut rng, -0.5, 0.5), 0.2, 0.1], turn, even(&mut rng, 0.5, 1.5)).unwrap()
        };
        let (first, second) = (pose(), pose());
        let body = |i: usize, color| Solid::body(&sheets[i % 3], color).unwrap();
        let beside = if number % 2 == 0 {
            Solid::new(&other, colors[1])
        } else {
            body(1 + number as usize, colors[1])
        };
        let solids = [body(number as usize, colors[0]).posed(first), beside.posed(second)];
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        let towards = [even(&mut rng, -1.0, 1.0), -1.0, 0.5];
        let solids = &solids[..rng.random_range(1..=2)];
        let scene = Scene::new(solids, camera, Light::new(towards, 0.2).unwrap());
        let known = Known { scene, colors: &colors, towards, ambient: 0.2 };
        difference.add(&known, 48, &format!("scene {number}"));
    }
    difference.assert_none();
}

/// Cups, tubes, and cups with a hollow in their foot: seen from outside, none of their sheets hides another.
#[test]
fn shells_are_those_of_single_rays() {
    let mut rng = ChaCha8Rng::seed_from_u64(2030);
    let colors = [Rgb::new(0.9, 0.5, 0.3), Rgb::new(0.3, 0.4, 0.9), Rgb::new(0.2, 0.9, 0.4)];
    let mut difference = Difference::default();
    for number in 0..number_of_scenes() {
        let lathes = random_shell(&mut rng);
        let sheet = |(number, (lathe, color))| {
            let sheet: Sheet = if number == 0 { Sheet::outer(lathe) } else { Sheet::inner(lathe) };
            sheet.colored(color)
        };
        let sheets: Vec<_> =
            lathes.iter().map(|lathe| -> &Lathe { lathe }).zip(colors).enumerate().map(sheet).collect();
        let turn =
            Rotation::about_x(even(&mut rng, -3.0, 3.0)).then(Rotation::about_z(even(&mut rng, -3.0, 3.0)));
        let turn = if rng.random() { turn } else { Rotation::IDENTITY };
        let pose = Pose::new([0.0, 0.1, -0.3], turn, even(&mut rng, 0.5, 1.5)).unwrap();
        let solids = [Solid::body(&sheets, Rgb::WHITE).unwrap().posed(pose)];
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        let towards = [even(&mut rng, -1.0, 1.0), -1.0, 0.5];
        let scene = Scene::new(&solids, camera, Light::new(towards, 0.2).unwrap());
        let known = Known { scene, colors: &colors, towards, ambient: 0.2 };
        difference.add(&known, 48, &format!("scene {number}"));
    }
    difference.assert_none();
}

/// Solids around the axis and one above another over a wide disc, some upright: painted one over the other
/// where planes part them, compared where none does, and hidden by the disc from below, though that reaches
/// farther away.
#[test]
fn solids_apart_are_those_of_single_rays() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let colors = [
        Rgb::WHITE,
        Rgb::new(0.9, 0.5, 0.3),
        Rgb::new(0.2, 0.9, 0.4),
        Rgb::new(0.3, 0.4, 0.9),
        Rgb::gray(0.5),
    ];
    let disc = Lathe::turn(Profile::<1>::cylinder(2.0, 0.05).unwrap());
    let mut difference = Difference::default();
    for number in 0..number_of_scenes() {
        let lathes: [_; 4] = core::array::from_fn(|_| random_lathe(&mut rng));
        let solids: [_; 5] = core::array::from_fn(|i| {
            let Some(lathe) = lathes.get(i) else {
                let below = Pose::new([0.0, 0.0, -1.2], Rotation::IDENTITY, 1.0);
                return Solid::new(&disc, colors[i]).posed(below.unwrap());
            };
            let [x, y, z] = [[0.7, 0.1, 0.0], [-0.4, 0.6, 0.1], [-0.3, -0.7, 0.0], [-0.4, 0.6, 0.9]][i];
            let upright = Rotation::about_z(even(&mut rng, -3.0, 3.0));
            let lean = if rng.random() { 0.0 } else { even(&mut rng, -1.5, 1.5) };
            let pose = Pose::new([x, y, z], upright.then(Rotation::about_x(lean)), even(&mut rng, 0.1, 0.5));
            Solid::new(lathe, colors[i]).posed(pose.unwrap())
        });
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        let (towards, ambient) = ([even(&mut rng, -1.0, 1.0), -1.0, 0.5], 0.2);
        let light = Light::new(towards, ambient).unwrap();
        let scene = Scene::new(&solids, camera, light);
        let known = Known { scene, colors: &colors, towards, ambient };
        difference.add(&known, 60, &format!("scene {number}"));
    }
    difference.assert_none();
}

/// The parts of a solid's pose.
fn placed(solid: Solid) -> ([f32; 3], Rotation, f32) {
    let pose = solid.pose();
    (pose.position(), pose.rotation(), pose.scale())
}

/// Two to ten solids that no plane parts: through one another, one in another and about the same axis, one
/// standing in another's cap, and in one place.
#[test]
fn solids_through_one_another_are_those_of_single_rays() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let colors: [_; 10] =
        core::array::from_fn(|i| [(i * 37 % 10) as f32, (i * 53 % 7) as f32, (9 - i) as f32])
            .map(|[r, g, b]| Rgb::new(0.2 + 0.08 * r, 0.3 + 0.1 * g, 0.2 + 0.08 * b));
    let mut difference = Difference::default();
    for number in 0..number_of_scenes() {
        let lathes: [_; 10] = core::array::from_fn(|_| random_lathe(&mut rng));
        let many = if rng.random_ratio(1, 8) { 10 } else { rng.random_range(2..=6) };
        let mut solids = Vec::<Solid>::new();
        for (lathe, color) in lathes.iter().zip(colors).take(many) {
            let turn = [even(&mut rng, -1.0, 1.0), 0.3, 0.5];
            let turn = Rotation::about(turn, even(&mut rng, -3.0, 3.0)).unwrap();
            let scale = even(&mut rng, 0.3, 1.5);
            let last = solids.last().copied();
            let solid = match (rng.random_range(0..5), last) {
                // In the last one's place.
                (0, Some(last)) => last.colored(color),
                // About its axis, within it or around it.
                (1, Some(last)) => {
                    let (position, rotation, scale) = placed(last);
                    let pose = Pose::new(position, rotation, scale * even(&mut rng, 0.3, 1.2));
                    Solid::new(last.lathe(), color).posed(pose.unwrap())
                }
                // Its lower end where the last one has its upper end.
                (2, Some(last)) => {
                    let (position, rotation, scale) = placed(last);
                    let up =
                        rotation.apply([0.0, 0.0, scale * (last.lathe().heights()[1] - lathe.heights()[0])]);
                    let place = [0, 1, 2].map(|i| position[i] + up[i]);
                    Solid::new(lathe, color).posed(Pose::new(place, rotation, scale).unwrap())
                }
                _ => {
                    let place = [(); 3].map(|()| even(&mut rng, -0.4, 0.4));
                    Solid::new(lathe, color).posed(Pose::new(place, turn, scale).unwrap())
                }
            };
            solids.push(solid);
        }
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        let (towards, ambient) = ([even(&mut rng, -1.0, 1.0), -1.0, 0.5], 0.2);
        let scene = Scene::new(&solids, camera, Light::new(towards, ambient).unwrap());
        let known = Known { scene, colors: &colors, towards, ambient };
        difference.add(&known, 60, &format!("scene {number}"));
    }
    difference.assert_none();
}

/// Of two in the same place the first is seen.
#[test]
fn the_first_of_two_in_one_place_is_seen() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let mut row = [Rgb565::BLACK; 60];
    let mut seen = 0;
    for number in 0..20 {
        let lathe = random_lathe(&mut rng);
        let colors = [Rgb::new(0.0, 1.0, 0.0), Rgb::new(1.0, 0.0, 0.0)];
        let solids = colors.map(|color| Solid::new(&lathe, color));
        let light = Light::new([0.0, -1.0, 0.5], 1.0).unwrap();
        let scene = Scene::new(&solids, random_camera(&mut rng), light);
        for y in 0..60 {
            scene.picture(60, 60).row(y, &mut row);
            let first = row.iter().filter(|pixel| **pixel == Rgb565::GREEN).count();
            let none = row.iter().filter(|pixel| **pixel == Rgb565::BLACK).count();
            assert_eq!(first + none, 60, "scene {number}, row {y}: {row:?}");
            seen += first;
        }
    }
    assert!(seen > 10_000, "{seen}");
}

/// Of two solids so near to each other that a row does not know their distances well enough, the same profile
/// in two sizes, the one is seen that single rays find nearer, to the last bit of their distances. Each solid
/// is a body of twice the same sheet: to such a body [`Solid::nearest`] casts the rays that a picture compares.
#[test]
fn the_nearer_of_two_that_all_but_coincide_is_seen() {
    let mut rng = ChaCha8Rng::seed_from_u64(1995);
    let colors = [Rgb::new(0.0, 1.0, 0.0), Rgb::new(1.0, 0.0, 0.0)];
    let mut row = [Rgb565::BLACK; 60];
    let (mut both, mut wrong) = (0, 0);
    for _ in 0..100 {
        let lathe = random_lathe(&mut rng);
        let sheets = [Sheet::outer(&lathe); 2];
        let smaller = 1.0 - 10_f32.powf(even(&mut rng, -7.0, -5.0));
        let smaller = Pose::new([0.0; 3], Rotation::IDENTITY, smaller).unwrap();
        let [one, other] = colors.map(|color| Solid::body(&sheets, color).unwrap());
        let solids = [one, other.posed(smaller)];
        let light = Light::new([0.0, -1.0, 0.5], 1.0).unwrap();
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        let scene = Scene::new(&solids, camera, light);
        for y in 0..60 {
            scene.picture(60, 60).row(y, &mut row);
            for (x, pixel) in (0..).zip(row) {
                let ray = camera.ray(x, y, 60, 60);
                let [Some(a), Some(b)] = [0, 1].map(|i| solids[i].nearest(&ray, 0.0)) else { continue };
                both += 1;
                wrong += u32::from(pixel != if b.t < a.t { Rgb565::RED } else { Rgb565::GREEN });
            }
        }
    }
    assert!(wrong == 0 && both > 100_000, "{wrong} of {both}");
}

/// Three balls as far away, side by side, are all seen.
#[test]
fn all_of_three_as_far_away_are_seen() {
    let [left, right] = [-0.4, 0.4].map(|angle| Rotation::about_z(angle).apply([0.0, 4.0, 0.0]));
    let ball = |place| {
        let pose = Pose::new(place, Rotation::IDENTITY, 1.0).unwrap();
        Solid::new(&scenes::BALL, Rgb::WHITE).posed(pose)
    };
    // The outer two are mirror images; the one between is put where it is as far to the last bit.
    let solids = [ball(left), ball(right), ball([0.0, (left[0] * left[0] + left[1] * left[1]).sqrt(), 0.0])];
    let camera = Camera::perspective([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], 0.6).unwrap();
    let light = Light::new([0.0, -1.0, 0.0], 0.5).unwrap();
    let scene = Scene::new(&solids, camera, light);
    let mut row = [Rgb565::BLACK; 240];
    scene.picture(240, 3).row(1, &mut row);
    let edges = row.windows(2).filter(|pair| (pair[0] == Rgb565::BLACK) != (pair[1] == Rgb565::BLACK));
    assert_eq!(edges.count(), 6, "{row:?}");
}

/// A coin within another solid is not seen, however small it is, near its surface, or far from the origin.
#[test]
fn what_is_within_another_solid_is_hidden() {
    let up = [0.0, 0.0, 1.0];
    let column = Lathe::turn(Profile::<1>::cylinder(1.0, 100.0).unwrap());
    let coin = Lathe::turn(Profile::<1>::cylinder(1.0, 1.0).unwrap());
    let slab = Lathe::turn(Profile::<1>::cylinder(2.0, 0.37).unwrap());
    let closed = Profile::<1>::from_squared_radii(&[0.3, 0.35], &[0.09; 4])
        .unwrap()
        .base(End::Capped)
        .top(End::Capped);
    let thin = Lathe::turn(closed);
    let pose = |place, rotation, scale| Pose::new(place, rotation, scale).unwrap();
    let upright = |place, scale| pose(place, Rotation::IDENTITY, scale);
    // A coin a twentieth of its size below the top of the column; and one on edge, far away, all numbers
    // exact.
    let size = 5e-4_f32;
    let (deep, far) = (upright([0.0, 0.0, -1.05 * size], size), 1_048_576.0);
    let on_edge = pose([far, 0.0, 0.0], Rotation::about_y(core::f32::consts::FRAC_PI_2), 1.0);
    let column = Solid::new(&column, Rgb::WHITE).posed(upright([0.0, 0.0, -100.0], 1.0));
    let coin = Solid::new(&coin, scenes::CLAY).posed(deep);
    let thick =
        [Solid::new(&slab, Rgb::WHITE).posed(on_edge), Solid::new(&thin, scenes::CLAY).posed(on_edge)];
    let views = [
        ([column, coin], Camera::perspective([0.0, -5.0 * size, 3.0 * size], [0.0; 3], up, 0.4)),
        ([column, coin], Camera::perspective([0.0, -40.0, 30.0], [0.0; 3], up, 2.0 * size / 50.0)),
        (thick, Camera::perspective([far + 4.0, -1.0, 1.0], [far, 0.0, 0.0], up, 0.5)),
    ];
    let light = Light::new([0.3, -1.0, 0.5], 0.5).unwrap();
    for (number, (solids, camera)) in views.into_iter().enumerate() {
        let scene = Scene::new(&solids, camera.unwrap(), light);
        let mut row = [Rgb565::BLACK; 60];
        let mut seen = 0;
        for y in 0..60 {
            scene.picture(60, 60).row(y, &mut row);
            // White is gray in the shade, and clay is not.
            let is_grey = |pixel: &Rgb565| pixel.r() == pixel.b();
            assert!(row.iter().all(is_grey), "scene {number}, row {y}: {row:?}");
            seen += row.iter().filter(|pixel| **pixel != Rgb565::BLACK).count();
        }
        assert!(seen > 1_000, "scene {number}: {seen}");
    }
}

/// Of two whose axes all but coincide, the hidden one stays hidden, however near they come.
#[test]
fn one_almost_within_another_is_hidden() {
    let cylinder = Lathe::turn(Profile::<1>::cylinder(1.0, 1.0).unwrap());
    for near in [1e-10, 1e-22, 1e-25, 1e-30] {
        let inner = Pose::new([near, 0.8 * near, -0.6], Rotation::IDENTITY, 0.5).unwrap();
        let colors = [Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 1.0, 0.0)];
        let solids = [Solid::new(&cylinder, colors[0]), Solid::new(&cylinder, colors[1]).posed(inner)];
        let (towards, ambient) = ([0.3, -1.0, 0.5], 0.5);
        let camera = Camera::perspective([4.5, -0.1, 2.2], [0.0; 3], [0.0, 0.0, 1.0], 0.4).unwrap();
        let light = Light::new(towards, ambient).unwrap();
        let scene = Scene::new(&solids, camera, light);
        let mut difference = Difference::default();
        difference.add(&Known { scene, colors: &colors, towards, ambient }, 60, &format!("{near:e} apart"));
        difference.assert_none();
    }
}

/// Everything so many times as large, by powers of two, is the same to the last bit.
#[test]
fn a_world_of_any_size_looks_the_same() {
    let vase_and_two = |size: f32| {
        let at = |x: f32, y: f32, z: f32| [size * x, size * y, size * z];
        let pose = |place, scale: f32| Pose::new(place, Rotation::about_x(0.2), size * scale).unwrap();
        let solids = [
            Solid::new(&scenes::BALL, Rgb::new(0.8, 0.8, 0.3)).posed(pose(at(-0.4, -0.3, 0.4), 1.0)),
            Solid::new(&scenes::VASE, scenes::CLAY).posed(pose(at(0.0, 0.0, 0.0), 1.0)),
            Solid::new(&scenes::PAWN, Rgb::WHITE).posed(pose(at(0.3, 0.8, 0.0), 1.2)),
        ];
        let up = [0.0, 0.0, 1.0];
        let camera = Camera::perspective(at(0.0, -2.6, 1.2), at(0.0, 0.0, 0.4), up, 0.42).unwrap();
        let scene = scenes::STILL_LIFE.with_solids(&solids).with_camera(camera);
        let mut row = [Rgb565::BLACK; 120];
        let rows = (0..120).flat_map(|y| {
            scene.picture(120, 120).row(y, &mut row);
            row
        });
        rows.collect::<Vec<_>>()
    };
    let exact = vase_and_two(1.0);
    for power in [-60, -30, 10, 60] {
        assert!(vase_and_two(2_f32.powi(power)) == exact, "2 to the power of {power}");
    }
}

/// Rays exactly level in rows that are not, views from straight above, pictures of next to nothing of a
/// solid, and wide ones.
fn exact_cameras() -> Vec<Camera> {
    let up = [0.0, 0.0, 1.0];
    let mut cameras = vec![
        // The middle of the ball's picture is on the ball, and not on the axis.
        Camera::orthographic([0.7, -3.0, 0.0], [0.7, 0.0, 0.0], up, 1e-7),
        Camera::orthographic([0.7, -1e4, 0.0], [0.7, 0.0, 0.0], up, 1e-3),
        Camera::orthographic([0.0, 0.0, 5.0], [0.0; 3], [0.3, 1.0, 0.0], 1.2),
        Camera::perspective([0.0, 0.0, 5.0], [0.0; 3], [0.3, 1.0, 0.0], 0.3),
    ];
    for roll in [0.0, 0.5, 1.0, f32::INFINITY] {
        let up = if roll < f32::INFINITY { [roll, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        cameras.push(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], up, 1.2));
        cameras.push(Camera::perspective([0.0, -5.0, 0.0], [0.0; 3], up, 0.3));
    }
    for half_width in [1.0, 1.7, 5.0] {
        cameras.push(Camera::perspective([0.1, -1.04, 0.2], [0.0; 3], [0.3, 0.0, 1.0], half_width));
    }
    cameras.into_iter().map(Result::unwrap).collect()
}

/// A white solid alone, seen by a camera.
fn compare_lone(difference: &mut Difference, solid: Solid, camera: Camera, side: u32, what: &str) {
    let (towards, ambient) = ([-0.5, -0.7, 0.5], 0.15);
    let solids = [solid];
    let light = Light::new(towards, ambient).unwrap();
    let scene = Scene::new(&solids, camera, light);
    difference.add(&Known { scene, colors: &[Rgb::WHITE], towards, ambient }, side, what);
}

/// The same, and one picture of it.
fn lone(solid: Solid, camera: Camera, side: u32) -> Difference {
    let mut difference = Difference::default();
    compare_lone(&mut difference, solid, camera, side, "the picture");
    difference
}

#[test]
fn exact_views_are_those_of_single_rays() {
    let ball = Lathe::turn(Profile::<1>::sphere(1.0).unwrap());
    let mut difference = Difference::default();
    for (number, camera) in exact_cameras().into_iter().enumerate() {
        for side in [1, 2, 3, 60, 61] {
            let ball = Solid::new(&ball, Rgb::WHITE);
            compare_lone(&mut difference, ball, camera, side, &format!("camera {number}, {side} wide"));
        }
    }
    // Nearly all pixels of a picture of next to nothing have one color, and rounding may decide between two.
    assert_eq!((difference.mask, difference.more), (0, 0), "{difference:?}");
    assert!(difference.covered * 2 > difference.pixels, "{difference:?}");
}

/// A plate on a stalk, its edge rounded over 3·10⁻⁵: there a step of Newton's may end where no root is, and
/// what is left of it told nothing.
#[test]
fn edges_all_but_sharp_are_those_of_single_rays() {
    let [knots, stalk] = [[-0.3, 0.0, 3e-5, 0.30003], [0.23228319; 4]];
    let plate = [&stalk[..], &[0.8, 1.1804416, 0.99, 0.6, 0.5, 0.4]].concat();
    let plate = Lathe::turn(Profile::<3>::from_squared_radii(&knots, &plate).unwrap().closed());
    let (eye, at) = ([-0.7208667, -3.0, -1.2772677], [0.0, 0.0, 0.1]);
    let cameras = [
        Camera::perspective(eye, at, [0.2, 0.0, 1.0], 0.4),
        Camera::orthographic(eye, at, [0.3, 0.0, 1.0], 1.2),
    ];
    let mut difference = Difference::default();
    for camera in cameras {
        compare_lone(&mut difference, Solid::new(&plate, Rgb::WHITE), camera.unwrap(), 240, "plate");
    }
    assert_eq!((difference.mask, difference.more), (0, 0), "{difference:?}");
    assert!(difference.covered * 8 > difference.pixels, "{difference:?}");
}

/// An hourglass of two funnels, open at the top: its waist hides the wall below that a ray left it by one
/// pixel before.
#[test]
fn a_waist_seen_from_within_is_that_of_single_rays() {
    let glass = [1.0, 0.7, 0.4, 0.1, 0.4, 0.7, 1.0];
    let glass =
        Profile::<2>::from_squared_radii(&[-1.0, 0.0, 1.0], &glass).unwrap().base(End::Capped).top(End::Open);
    let glass = Lathe::turn(glass);
    let mut difference = Difference::default();
    for (eye, width) in [([0.0, -1.0, 4.0], 0.4), ([0.0, -2.0, 3.0], 0.4), ([0.0, -3.0, 3.0], 0.4)] {
        for up in [[0.0, 0.0, 1.0], [0.4, 0.0, 1.0]] {
            let camera = Camera::perspective(eye, [0.0, 0.0, 0.3], up, width).unwrap();
            compare_lone(
                &mut difference,
                Solid::new(&glass, Rgb::WHITE),
                camera,
                120,
                &format!("from {eye:?}"),
            );
        }
    }
    difference.assert_none();
}

/// A solid that lies across the picture: its rows' rays are mirror images of each other but for heights,
/// which count at its ends.
#[test]
fn a_cylinder_lying_down_is_that_of_single_rays() {
    let cylinder = |end| Lathe::turn(Profile::<1>::cylinder(1.0, 2.0).unwrap().base(end).top(end));
    let mut difference = Difference::default();
    for lathe in [cylinder(End::Capped), cylinder(End::Open)] {
        for z in [0.0, 1.0, 1.9] {
            let (eye, at, up) = ([5.0, 0.1, z], [0.0, 0.1, z], [0.0, 1.0, 0.0]);
            let cameras = [Camera::orthographic(eye, at, up, 1.5), Camera::perspective(eye, at, up, 0.3)];
            for camera in cameras {
                let what = format!("from {eye:?}");
                compare_lone(&mut difference, Solid::new(&lathe, Rgb::WHITE), camera.unwrap(), 60, &what);
            }
        }
    }
    difference.assert_none();
}

/// A ring so low, so high up, that its middle is rounded to one of its ends.
#[test]
fn a_solid_whose_middle_is_rounded_is_that_of_single_rays() {
    let [low, high] = [1000.0001, 1000.0003];
    let ring = [1.926_030_7e-10, 1.926_030_7e-10, 2.416_913_6e-10, 1.901_072_1e-10];
    let ring = Lathe::turn(Profile::<1>::from_squared_radii(&[low, high], &ring).unwrap().base(End::Capped));
    let eye = [0.005_867_148_3, -0.005_859_375, low];
    let at = [eye[0] - 1.0, eye[1] + 1.0, low];
    let camera = Camera::perspective(eye, at, [1.0, 1.0, 0.0], 0.001).unwrap();
    let difference = lone(Solid::new(&ring, Rgb::WHITE), camera, 48);
    assert_eq!((difference.mask, difference.more), (0, 0), "{difference:?}");
    assert!(difference.covered > 1_000, "{difference:?}");
}

/// Parallel rays begin at places of the world, each rounded there.
#[test]
fn parallel_rays_far_from_the_origin_are_those_of_single_rays() {
    let ball = Lathe::turn(Profile::<1>::sphere(1.0).unwrap());
    let place = [1e4, 3e3, 7e3];
    let ball = Solid::new(&ball, Rgb::WHITE).posed(Pose::new(place, Rotation::IDENTITY, 1.0).unwrap());
    let eye = [place[0] + 1.1, place[1] - 4.0, place[2] + 1.3];
    let camera = Camera::orthographic(eye, place, [0.0, 0.0, 1.0], 1.3).unwrap();
    let difference = lone(ball, camera, 240);
    // So far out a step of an origin is a thousandth of the ball, and of its shades.
    assert_eq!(difference.mask, 0, "{difference:?}");
    assert!(difference.covered > 20_000, "{difference:?}");
}

/// From so far away that rounding is larger than the solid, rays meet it or not, each by itself.
#[test]
fn a_ball_lost_in_rounding_is_that_of_single_rays() {
    let ball = Lathe::turn(Profile::<1>::sphere(1.0).unwrap());
    let mut difference = Difference::default();
    for far in [1e7, 3e7, 6e7, 1.3e8, 1e9] {
        let camera = Camera::orthographic([0.0, -far, 0.3 * far], [0.0; 3], [0.0, 0.0, 1.0], 1.2).unwrap();
        compare_lone(&mut difference, Solid::new(&ball, Rgb::WHITE), camera, 64, &format!("from {far}"));
    }
    // Where on the ball they meet it is rounding, and so are its shades.
    assert_eq!(difference.mask, 0, "{difference:?}");
    assert!(difference.covered > 4_000, "{difference:?}");
}

/// An eye on an open end's rim, and rays almost in its plane: rounding tells where they pass that.
#[test]
fn rays_from_a_rim_are_those_of_single_rays() {
    let ordinates = [0.516_344_8, 0.100_530_04, 0.287_232_82, 0.225_039_26];
    let low = -0.649_274_23;
    let profile = Profile::<1>::from_squared_radii(&[low, 0.119_349_12], &ordinates).unwrap();
    let lathe = Lathe::turn(profile.base(End::Open).top(End::Open));
    let (eye, at) = ([0.0, -0.718_571_36, low], [0.0, 0.0, low]);
    let camera = Camera::perspective(eye, at, [1.0, 0.0, 1.0], 0.001).unwrap();
    lone(Solid::new(&lathe, Rgb::WHITE), camera, 60).assert_none();
}

/// An eye so near to a needle's cap that rounding tells on which side of it rays begin.
#[test]
fn an_eye_at_a_needles_cap_sees_what_single_rays_do() {
    let [low, high] = [-348.29932, 3958.5442];
    let ordinates = [0.25595456, 0.25595456, 0.084514335, 0.47793397, 0.50057364, 0.14882949, 0.38656664];
    let needle = Profile::<2>::from_squared_radii(&[low, 1527.9675, high], &ordinates).unwrap();
    let needle = Lathe::turn(needle.base(End::Capped).top(End::Capped));
    let (eye, at) = ([0.0, 0.0, -348.29944], [0.004_974_44, 0.016_966_347, -248.29944]);
    let camera = Camera::orthographic(eye, at, [1.0, 0.0, 0.0], 0.735_974_67).unwrap();
    lone(Solid::new(&needle, Rgb::WHITE), camera, 128).assert_none();
}

/// A sheet among whose segments some are too low to have a height beside the others.
#[test]
fn where_a_wall_has_no_slope_it_has_a_normal() {
    let knots = [-102_034_510.0, -1.725_744_2, -0.021_551_609, 0.224_632_26];
    let wall = [
        0.466_442_58,
        1.276_554_1,
        8.800_485_6e-23,
        1.377_190_1,
        1.006_616_1,
        1.602_684,
        1.457_845_2,
        1.828_824,
        1.882_505_9,
        0.0,
    ];
    let sheet = Profile::<3>::from_squared_radii(&knots, &wall).unwrap().squash(0.0).unwrap();
    let sheet = Lathe::turn(sheet.base(End::Open).top(End::Open));
    let pose = Pose::new([1.243_113_5, -0.191_487_79, -0.196_320_53], Rotation::IDENTITY, 1.0).unwrap();
    let solids = [Solid::new(&sheet, Rgb::WHITE).posed(pose)];
    let eye = [0.177_331_92, -1.084_042_5, 1.545_180_3];
    let at = [eye[0] - 0.1, eye[1] + 0.9, eye[2] - 1.0];
    let camera = Camera::perspective(eye, at, [0.0, -1.0, 3.5e-7], 0.230_720_3).unwrap();
    let light = Light::new([0.3, -1.0, 0.5], 0.5).unwrap();
    let scene = Scene::new(&solids, camera, light);
    let mut row = [Rgb565::BLACK; 33];
    let mut seen = 0;
    for y in 0..33 {
        // Painting it overflows nowhere.
        scene.picture(33, 33).row(y, &mut row);
        for x in 0..33 {
            let ray = camera.ray(x, y, 33, 33);
            let Some(hit) = solids[0].nearest(&ray, 0.0) else { continue };
            let normal = solids[0].surface(&ray, &hit).normal;
            assert!((normal.iter().map(|c| c * c).sum::<f32>() - 1.0).abs() < 1e-6, "{normal:?}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

/// Rays so nearly level that they come into an open end's plane far outside the solid.
#[test]
fn rays_nearly_level_with_an_open_end_are_those_of_single_rays() {
    let cone = Profile::<1>::from_squared_radii(&[0.0, 0.65], &[0.74, 0.43, 0.22, 0.1])
        .unwrap()
        .closed()
        .top(End::Open);
    let cone = Lathe::turn(cone);
    let mut difference = Difference::default();
    for part in 0..40 {
        // Rows run along the axis, and pixels are so far apart that one ray at most comes through the open
        // end.
        let height = 0.5 + part as f32 / (40.0 * 16.0);
        let (eye, at, up) = ([0.0, -5.0, height + 0.004], [0.0, 0.0, height], [1.0, 0.0, 0.0]);
        let camera = Camera::orthographic(eye, at, up, 0.5).unwrap();
        compare_lone(&mut difference, Solid::new(&cone, Rgb::WHITE), camera, 16, &format!("height {height}"));
    }
    difference.assert_none();
}

/// Rays in a cap's very plane, or as near to it as rounding tells, meet the rim or not, as single rays do.
#[test]
fn rays_level_with_a_cap_are_those_of_single_rays() {
    let cylinder = Lathe::turn(Profile::<1>::cylinder(1.0, 0.7).unwrap());
    let up = [0.0, 0.0, 1.0];
    let turned = Pose::new([0.0; 3], Rotation::about_x(core::f32::consts::PI), 0.410_956_62);
    let upright = Pose::new([0.0, 0.0, 0.35], Rotation::IDENTITY, 1.0);
    let (eye, target) = ([0.3, -5.0, 0.35], [0.2, 0.0, 0.35]);
    let views = [
        (turned, [-0.671_061_2, 0.032_068_312, 0.0], [0.0, 0.08549, 0.0], up, 0.46),
        (upright, eye, target, [0.3, 0.0, 1.0], 1.2),
        (upright, eye, target, up, 1.2),
    ];
    let mut difference = Difference::default();
    for (number, (pose, eye, target, up, wide)) in views.into_iter().enumerate() {
        let solid = Solid::new(&cylinder, Rgb::WHITE).posed(pose.unwrap());
        let cameras =
            [Camera::perspective(eye, target, up, wide), Camera::orthographic(eye, target, up, wide)];
        for camera in cameras.map(Result::unwrap) {
            for side in [3, 60, 61] {
                compare_lone(&mut difference, solid, camera, side, &format!("view {number}, {side} wide"));
            }
        }
    }
    assert_eq!((difference.mask, difference.more), (0, 0), "{difference:?}");
    assert!(difference.covered * 20 > difference.pixels, "{difference:?}");
}

/// A ring so low that its ends are all in doubt.
#[test]
fn a_low_ring_is_that_of_single_rays() {
    let camera = Camera::perspective([0.0, -5.0, 1.0], [0.0; 3], [0.3, 0.0, 1.0], 0.3).unwrap();
    let mut difference = Difference::default();
    for height in [1e-4, 3e-4, 1e-2] {
        let ring = Lathe::turn(Profile::<1>::cylinder(1.0, height).unwrap().base(End::Open).top(End::Open));
        let ring = Solid::new(&ring, Rgb::WHITE);
        compare_lone(&mut difference, ring, camera, 60, &format!("ring {height}"));
    }
    assert_eq!((difference.mask, difference.more, difference.one_step), (0, 0, 0), "{difference:?}");
    assert!(difference.covered > 0, "{difference:?}");
}

/// Balls from a pixel's size down to a hundredth of it, in the way of its ray, beside another solid.
#[test]
fn tiny_solids_are_seen() {
    let (side, mut rng) = (240, ChaCha8Rng::seed_from_u64(1995));
    let ball = Lathe::turn(Profile::<1>::sphere(1.0).unwrap());
    let mut row = vec![Rgb565::BLACK; side as usize];
    let mut seen = 0;
    for number in 0..4_000 {
        let camera = if rng.random() { random_camera(&mut rng) } else { upright_camera(&mut rng) };
        let (x, y) = (rng.random_range(0..side), rng.random_range(0..side));
        let (ray, next) = (camera.ray(x, y, side, side), camera.ray((x + 1) % side, y, side, side));
        let t = even(&mut rng, 1.0, 6.0);
        let [place, beside] = [ray, next].map(|ray| ray.at(t));
        let pixel = (0..3).map(|i| (place[i] - beside[i]).powi(2)).sum::<f32>().sqrt().min(0.05);
        let size = pixel * 10_f32.powf(even(&mut rng, -2.0, 0.0));
        let tiny = Pose::new(place, Rotation::IDENTITY, size).unwrap();
        let solids = [
            Solid::new(&ball, Rgb::WHITE).posed(tiny),
            Solid::new(&ball, Rgb::WHITE).posed(Pose::new([9.0, 9.0, 9.0], Rotation::IDENTITY, 0.1).unwrap()),
        ];
        let light = Light::new([-1.0, -1.0, 1.0], 1.0).unwrap();
        let scene = Scene::new(&solids, camera, light);
        scene.picture(side, side).row(y, &mut row);
        let is_hit = solids.iter().any(|solid| solid.nearest(&ray, 0.0).is_some());
        assert_eq!(row[x as usize] != Rgb565::BLACK, is_hit, "ball {number}, {size} large, at column {x}");
        seen += usize::from(is_hit);
    }
    assert!(seen > 3_000, "{seen}");
}
