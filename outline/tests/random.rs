//! Outlines at random: what is proven holds when it is measured.

mod measure;

use embedded_lathe::{Rgb, Solid};
use embedded_lathe_outline::{
    Body, Fit, Joins, Outline, OutlineError, Piece, Point, Profiles, Segment, body, point,
};
use measure::{drawn, farthest, lines, on, silhouette};
use rand::{RngExt, SeedableRng, rngs::ChaCha8Rng};

/// Of the size.
const TOLERANCES: [f64; 3] = [1e-2, 1e-3, 1e-4];

#[test]
fn proven_bounds_hold() {
    check(0..12, 100);
}

/// `cargo test --release -p embedded-lathe-outline --test random -- --ignored`
#[test]
#[ignore = "ten minutes"]
fn proven_bounds_hold_for_five_hundred() {
    std::thread::scope(|scope| {
        for from in [24, 149, 274, 399] {
            scope.spawn(move || check(from..from + 125, 400));
        }
    });
}

fn check(seeds: core::ops::Range<u64>, places: usize) {
    let mut kinds = [0; 5];
    let mut done = 0;
    for seed in seeds.clone() {
        let (outline, kind) = random(seed);
        for tolerance in TOLERANCES {
            let tolerance = tolerance * outline.size();
            // Every fifth with free joins.
            let joins = if seed % 5 == 4 { Joins::Free } else { Joins::Smooth };
            let fit = Fit { places, joins, ..Fit::within(tolerance) };
            match body(&outline, &fit) {
                Ok(body) => {
                    hold(seed, &outline, &body);
                    if joins == Joins::Smooth {
                        smooth(seed, &outline, &body);
                    }
                    if seed % 4 == 0 {
                        rendered(seed, &outline, &body);
                    }
                    done += 1;
                    kinds[kind] += 1;
                }
                // Walls at random may cross, and thin ones may be thinner than the tolerance.
                Err(OutlineError::CrossesItself { .. } | OutlineError::WallsMeet { .. }) => {}
                Err(error) => panic!("seed {seed}, tolerance {tolerance:e}: {error}\n{outline:?}"),
            }
        }
    }
    let all = 3 * (seeds.end - seeds.start);
    assert!(done * 4 >= all * 3, "{done} of {all} outlines are outlines");
    if seeds.end - seeds.start > 1 {
        assert!(kinds.iter().all(|count| *count > 0), "a kind of outline never came up: {kinds:?}");
    }
}

/// The distance measured both ways is below the bound, and the bound below the tolerance.
fn hold(seed: u64, outline: &Outline, body: &Body) {
    assert!(body.error <= body.tolerance, "seed {seed}: proven {} for {}", body.error, body.tolerance);
    let at = |what: &str, (measured, place): (f64, Point)| {
        // What the chords of the lines measured against are off by: below a 10⁻⁶ of the size.
        let chords = 2e-6 * outline.size();
        let [error, tolerance] = [body.error, body.tolerance];
        assert!(
            measured <= error + chords,
            "seed {seed}, {tolerance:e}: {what} is off by {measured:e} at {place:?}, proven {error:e}\n{body:?}\n{outline:?}"
        );
    };
    // Chords of an 800th of a segment's height: of its curve of radius ρ they miss (π·h/1600)²/(8·ρ), some 10⁻⁷ of
    // the size.
    let fitted = lines(body, 800);
    // Straight pieces on the axis are no wall.
    let size = outline.size();
    let points: Vec<Point> = drawn(outline, 60).into_iter().filter(|p| p.r > 1e-6 * size).collect();
    at("the drawing", farthest(&points, &fitted));
    at("the body", farthest(&on(&lines(body, 60)), &[drawn(outline, 800)]));
}

/// What the crate draws has the drawing's silhouette.
fn rendered(seed: u64, outline: &Outline, body: &Body) {
    let profiles = Profiles::of(body);
    let lathes = profiles.turned::<128>().unwrap_or_else(|error| panic!("seed {seed}: {error}\n{body:?}"));
    let sheets = profiles.sheets(&lathes);
    let solid = Solid::body(&sheets, Rgb::WHITE).expect("a body");
    silhouette(&solid, outline, body.error, &format!("seed {seed}"));
}

/// Where the drawing is smooth the tangents of neighboring segments agree.
fn smooth(seed: u64, outline: &Outline, body: &Body) {
    let pieces = outline.pieces();
    let after_last = outline.is_closed().then(|| &pieces[0]);
    let pairs = pieces.iter().zip(pieces.iter().skip(1).chain(after_last));
    // No cubic in squared radius has a level tangent off the axis: where one is drawn there is none to share.
    let is_corner = |(a, b): &(&Piece, &Piece)| turn(a, b) > 0.5e-3 || is_level(b);
    let corners: Vec<Point> = pairs.filter(is_corner).map(|(a, _)| a.end()).collect();
    let near = |p: Point| {
        corners.iter().any(|corner| (corner.r - p.r).hypot(corner.z - p.z) <= 1e-6 * outline.size())
    };
    for sheet in &body.sheets {
        let segments: Vec<Segment> = sheet.segments().collect();
        for (below, above) in segments.windows(2).map(|pair| (pair[0], pair[1])) {
            let place = point(above.b[0].max(0.0).sqrt(), above.z[0]);
            // At a step there is no tangent to agree with, and at a pole within a wall none at all.
            if below.b[3] != above.b[0] || place.r == 0.0 || near(place) {
                continue;
            }
            let lean = |rise: f64, z: [f64; 2]| (3.0 * rise / (z[1] - z[0]) / (2.0 * place.r)).atan();
            let [low, high] =
                [lean(below.b[3] - below.b[2], below.z), lean(above.b[1] - above.b[0], above.z)];
            assert!(
                (low - high).abs() <= 1e-3,
                "seed {seed}: an edge of {:e} rad at {place:?}\n{body:?}\n{outline:?}",
                low - high
            );
        }
    }
}

/// The angle between the end of a piece and the start of the next one.
fn turn(a: &Piece, b: &Piece) -> f64 {
    let step = |from: Point, to: Point| (to.z - from.z).atan2(to.r - from.r);
    let turn = step(a.at(1.0 - 1e-6), a.end()) - step(b.start(), b.at(1e-6));
    turn.sin().abs().max(if turn.cos() < 0.0 { 1.0 } else { 0.0 })
}

/// Whether a piece is level where it begins. Over a step of 10⁻⁷ a curve that begins level, of control points not 30 times
/// as far apart in height as in radius, turns by less than 10⁻⁵, and rounding to f64 tilts the step by less than that.
fn is_level(piece: &Piece) -> bool {
    let (from, to) = (piece.start(), piece.at(1e-7));
    (to.z - from.z).abs() <= 1e-5 * (to.r - from.r).abs()
}

/// An outline with two to seven pieces outside, perhaps with an inner wall, and its kind.
fn random(seed: u64) -> (Outline, usize) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let kind = rng.random_range(0..5);
    let count = rng.random_range(2..7);
    let mut points = vec![point(if rng.random() { 0.0 } else { rng.random_range(0.3..1.0) }, 0.0)];
    for i in 1..=count {
        let z = i as f64 + rng.random_range(-0.2..0.2);
        points.push(point(rng.random_range(0.5..2.0), z));
    }
    if rng.random() {
        points[count] = point(0.0, points[count].z);
    }
    let mut pieces = wall(&mut rng, &points, kind);
    // A cap at the lower end, a ledge at the upper one.
    if points[0].r > 0.0 && rng.random() {
        pieces.insert(0, Piece::line(point(0.0, 0.0), points[0]));
    }
    match kind {
        // A vessel: the inner wall back down to the axis, or a ring.
        3 | 4 if points[count].r > 0.0 => {
            let end = points[count];
            let rim = point(end.r * 0.9, end.z);
            pieces.push(Piece::line(end, rim));
            let inner: Vec<Point> = core::iter::once(rim)
                .chain(points[1..count].iter().rev().map(|p| point(0.6 * p.r, p.z)))
                .collect();
            let last = inner[inner.len() - 1];
            pieces.extend(wall(&mut rng, &inner, 0));
            if kind == 3 || pieces[0].start().r == 0.0 {
                pieces.push(Piece::line(last, point(0.0, last.z)));
            } else {
                pieces.push(Piece::line(last, pieces[0].start()));
            }
        }
        _ => {}
    }
    let outline = if pieces[0].start() == pieces[pieces.len() - 1].end() {
        Outline::closed(pieces)
    } else {
        Outline::open(pieces)
    };
    (outline.expect("joined"), kind)
}

/// Pieces through points: lines, arcs, cubics, pieces of degree 5, some of which turn back in height.
fn wall(rng: &mut ChaCha8Rng, points: &[Point], kind: usize) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for ends in points.windows(2) {
        let (a, b) = (ends[0], ends[1]);
        match (rng.random_range(0..5), kind) {
            (0, _) => pieces.push(Piece::line(a, b)),
            (1, _) => pieces.extend(arc(a, b, rng.random_range(0.1..0.6))),
            (2, _) => {
                let mut inner = |t: f64| {
                    let r: f64 = a.r + t * (b.r - a.r) + rng.random_range(-0.1..0.3);
                    point(r.max(0.1), a.z + t * (b.z - a.z) + rng.random_range(-0.1..0.1))
                };
                let controls = [a, inner(0.2), inner(0.4), inner(0.6), inner(0.8), b];
                pieces.push(Piece::bezier(&controls));
            }
            // Undercut: beyond the end and back.
            (3, 1 | 2) => {
                let over = point(b.r + 0.5, b.z + 0.4);
                pieces.push(Piece::bezier(&[a, point(a.r + 0.6, a.z - 0.3), over, b]));
            }
            // Level at both ends.
            (3, _) => {
                let level = |p: Point, q: Point| point(p.r + 0.4 * (q.r - p.r), p.z);
                pieces.push(Piece::bezier(&[a, level(a, b), level(b, a), b]));
            }
            _ => {
                let upright = |p: Point, z: f64| point(p.r.max(0.05), p.z + z);
                pieces.push(Piece::bezier(&[a, upright(a, 0.3), upright(b, -0.3), b]));
            }
        }
    }
    pieces
}

/// An arc from a to b that bulges outwards by half of `bulge` times their distance.
fn arc(a: Point, b: Point, bulge: f64) -> Vec<Piece> {
    let (dr, dz) = (b.r - a.r, b.z - a.z);
    let chord = dr.hypot(dz);
    let rise = 0.5 * bulge * chord;
    let radius = (0.25 * chord * chord + rise * rise) / (2.0 * rise);
    let to_center = (radius - rise) / chord;
    let center = point(0.5 * (a.r + b.r) - to_center * dz, 0.5 * (a.z + b.z) + to_center * dr);
    let angle = |p: Point| (p.z - center.z).atan2(p.r - center.r);
    let from = angle(a);
    let sweep = (angle(b) - from).rem_euclid(std::f64::consts::TAU);
    Piece::arc(center, point(radius, 0.0), point(0.0, radius), from, sweep)
}
