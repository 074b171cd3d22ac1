//! The dearest row of many random scenes: its instructions by `Picture::row`, against those of one ray for each pixel and each
//! solid.
//!
//! ```text
//! cargo test --release -p embedded-lathe-laboratory --test dearest                                  300 scenes
//! SCENES=20000 cargo test --release -p embedded-lathe-laboratory --test dearest -- --nocapture      the ten dearest of as many
//! ```
//!
//! The test runs itself under valgrind, whose callgrind counts instructions: the same on each machine, however busy it is.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_lathe::{Camera, End, Lathe, Light, Pose, Profile, Rgb, Rotation, Scene, Segment, Solid};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use std::{env, fs, hint::black_box, process};

/// The most segments of a lathe.
const SEGMENTS: usize = 64;

/// Columns and rows of the pictures.
const SIDE: u32 = 120;

/// None of the `FIRST` scenes may take more than `MOST` times the instructions of single rays: the dearest takes 1.3
/// times as many. A longer search prints the dearest: of 20 000 scenes the first takes 2.2 times as many, and two take more
/// than twice as many. Their probes hold for one pixel or two, and their single rays are cast without the fast path.
const FIRST: u64 = 300;
const MOST: f64 = 1.5;

/// Says that this process is the one that valgrind counts.
const COUNTED: &str = "DEAREST_COUNTED";

fn even(rng: &mut ChaCha8Rng, from: f32, to: f32) -> f32 {
    rng.random_range(from..to)
}

fn log_even(rng: &mut ChaCha8Rng, from: f32, to: f32) -> f32 {
    10_f32.powf(even(rng, from, to))
}

/// One to 64 segments: smooth or with creases, some thin or flat, with spikes, steps and poles.
fn lathe(rng: &mut ChaCha8Rng) -> Lathe<[Segment; SEGMENTS]> {
    loop {
        let segments = (log_even(rng, 0.0, 1.806) as usize).clamp(1, SEGMENTS);
        let (mut knots, mut ordinates) = (vec![even(rng, -0.8, 0.0)], vec![even(rng, 0.0, 0.5)]);
        let (height, thin) = (even(rng, 0.1, 2.0) / segments as f32, rng.random_ratio(1, 3));
        let (calm, spiky) = (rng.random_ratio(1, 2), rng.random_ratio(1, 6));
        for _ in 0..segments {
            let is_thin = thin && rng.random_ratio(1, 6);
            let rise = if is_thin { log_even(rng, -6.0, -2.0) } else { height * even(rng, 0.3, 1.7) };
            knots.push(knots[knots.len() - 1] + rise);
            let last = ordinates[ordinates.len() - 1];
            let next = match (spiky && rng.random_ratio(1, 8), calm) {
                (true, _) => even(rng, 0.0, 1.0),
                (_, true) => (last + even(rng, -0.05, 0.05)).abs(),
                _ => even(rng, 0.0, 0.6),
            };
            let lean = if ordinates.len() > 1 { last - ordinates[ordinates.len() - 2] } else { 0.0 };
            ordinates.push(if calm { (last + lean).max(0.0) } else { even(rng, 0.0, 0.6) });
            ordinates.push(if calm { next } else { even(rng, 0.0, 0.6) });
            ordinates.push(next);
        }
        if rng.random_ratio(1, 3) {
            for knot in (0..=segments).rev() {
                if rng.random_ratio(1, 4) {
                    knots.insert(knot, knots[knot]);
                    ordinates.insert(3 * knot, even(rng, 0.0, 0.6));
                }
            }
        }
        let end = |open| if open { End::Open } else { End::Capped };
        if let Ok(profile) = Profile::from_squared_radii(&knots, &ordinates) {
            return Lathe::turn(profile.base(end(rng.random())).top(end(rng.random())));
        }
    }
}

/// From all around, nearly along the axis, nearly level, and from within.
fn camera(rng: &mut ChaCha8Rng) -> Camera {
    loop {
        let mut vector = |size: f32| [(); 3].map(|()| even(rng, -size, size));
        let (mut eye, mut target, mut up) = (vector(3.0), vector(0.3), vector(1.0));
        match rng.random_range(0..5) {
            0 => (eye[0], eye[1]) = (0.01 * eye[0], 0.01 * eye[1]),
            1 => {
                (eye[2], target[2], up) = (target[2] + log_even(rng, -6.0, -1.0), target[2], [0.0, 0.0, 1.0])
            }
            2 => (target, up) = ([0.0, 0.0, target[2]], [0.0, 0.0, 1.0]),
            3 => eye = eye.map(|c| 0.1 * c),
            _ => {}
        }
        let distance = eye.map(|c| c * c).iter().sum::<f32>().sqrt();
        let camera = if rng.random_ratio(1, 4) {
            Camera::orthographic(eye, target, up, even(rng, 0.2, 1.5))
        } else {
            Camera::perspective(eye, target, up, even(rng, 0.2, 1.0) / distance.max(1.0))
        };
        if let Ok(camera) = camera {
            return camera;
        }
    }
}

/// Calls `see` with the random scene of a number, and with the row to be looked at.
fn with_scene<T>(number: u64, see: impl FnOnce(&Scene, u32) -> T) -> T {
    let rng = &mut ChaCha8Rng::seed_from_u64(number);
    let lathes: Vec<_> = (0..rng.random_range(1..=6)).map(|_| lathe(rng)).collect();
    let mut solids: Vec<Solid> = Vec::new();
    for lathe in &lathes {
        let axis = [even(rng, -1.0, 1.0), 0.3, 0.5];
        let turn = if rng.random() { 0.0 } else { even(rng, -3.0, 3.0) };
        let rotation = Rotation::about(axis, turn).unwrap();
        let place = match (rng.random_range(0..3), solids.last()) {
            // On the last one.
            (0, Some(last)) => {
                let [x, y, z] = last.pose().position();
                [x, y, z + last.pose().scale() * last.lathe().heights()[1] - lathe.heights()[0]]
            }
            (1, Some(last)) => last.pose().position(),
            _ => [(); 3].map(|()| even(rng, -0.5, 0.5)),
        };
        let pose = Pose::new(place, rotation, even(rng, 0.5, 1.5)).unwrap();
        solids.push(Solid::new(lathe, Rgb::WHITE).posed(pose));
    }
    let light = Light::new([-0.5, -0.7, 0.5], 0.15).unwrap();
    see(&Scene::new(&solids, camera(rng), light), rng.random_range(0..SIDE))
}

/// What valgrind counts: its name is given to it.
#[inline(never)]
fn counted(work: &mut dyn FnMut()) {
    work();
}

/// Each scene's row by the picture, and by single rays.
fn draw(scenes: u64) {
    for number in 0..scenes {
        with_scene(number, |scene, y| {
            let (picture, mut row) = (scene.picture(SIDE, SIDE), [Rgb565::BLACK; SIDE as usize]);
            counted(&mut || picture.row(y, black_box(&mut row)));
            counted(&mut || {
                for x in 0..SIDE {
                    let ray = scene.camera.ray(x, y, SIDE, SIDE);
                    scene.solids.iter().for_each(|solid| {
                        black_box(solid.nearest(&ray, 0.0));
                    });
                }
            });
        });
    }
}

#[test]
fn no_row_takes_much_more_than_its_single_rays() {
    let scenes = env::var("SCENES").map_or(FIRST, |number| number.parse().expect("a number"));
    if env::var_os(COUNTED).is_some() {
        return draw(scenes);
    }
    let file = env::temp_dir().join(format!("dearest-{}.callgrind", process::id()));
    // Callgrind would keep only one of two options that name their function in the same way.
    let output = process::Command::new("valgrind")
        .args(["--tool=callgrind", "--toggle-collect=*dearest*counted*", "--dump-after=*::counted*"])
        .args(["--combine-dumps=yes", &format!("--callgrind-out-file={}", file.display())])
        .arg(env::current_exe().unwrap())
        .env(COUNTED, "")
        .output()
        .expect("valgrind starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let profile = fs::read_to_string(&file).unwrap();
    fs::remove_file(&file).unwrap();
    let counts: Vec<f64> = profile
        .lines()
        .filter_map(|line| line.strip_prefix("totals: "))
        .map(|total| total.trim().parse().unwrap())
        .collect();
    let mut rows: Vec<_> =
        (0_u64..).zip(counts.chunks_exact(2)).map(|(number, row)| (row[0] / row[1], number, row)).collect();
    assert!(rows.len() as u64 >= scenes && scenes > 0, "{} counts of {scenes} scenes", rows.len());
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (times, number, row) in rows.iter().take(10) {
        let [row, rays] = [row[0], row[1]].map(|count| count / f64::from(SIDE));
        let (solids, segments) = with_scene(*number, |scene, _| {
            (scene.solids.len(), scene.solids.iter().map(|solid| solid.lathe().segments()).max().unwrap())
        });
        println!(
            "scene {number}: {row:.0} instructions a pixel, {times:.2} times the {rays:.0} of single rays; \
             {solids} solids of up to {segments} segments"
        );
    }
    let first = rows.iter().find(|(_, number, _)| *number < FIRST).expect("the first scenes");
    let (dearest, number, _) = first;
    assert!(*dearest <= MOST, "scene {number}: {dearest:.2} times the instructions of single rays");
}
