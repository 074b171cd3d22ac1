//! Any ray at any valid open profile: the nearest hit is within four times the promised displacement of the
//! exact truth, if the squared radius may be off by as many units of the largest ordinate: near the axis that
//! is a large displacement (laboratory/tests/stability/touching.rs).
#![no_main]

use arbitrary::Arbitrary;
use laboratory::cases::{Cast, Outline};
use embedded_lathe::{
    Profile, Ray, math,
    solve::{Cardano, Split},
};
use laboratory::{forms, hits::Truth};
use libfuzzer_sys::fuzz_target;

const UNITS: f64 = 4.0 * laboratory::PROMISE;

/// Numbers of the order of one, so that the fuzzer need not look for them: the families cover scale and distance.
#[derive(Arbitrary, Debug)]
struct Input {
    heights: Vec<u8>,
    ordinates: [u16; 16],
    zeros: u16,
    squash: u8,
    origin: [i16; 3],
    far: u8,
    direction: [i16; 3],
    level: u8,
}

fuzz_target!(|input: Input| {
    let mut knots = vec![0.0];
    for height in input.heights.iter().take(5) {
        knots.push(knots[knots.len() - 1] + (f32::from(*height) + 1.0) / 128.0);
    }
    let count = 3 * knots.len() - 2;
    let mut ordinates: Vec<f32> = input.ordinates[..count].iter().map(|&b| f32::from(b) / 65536.0).collect();
    for (i, b) in ordinates.iter_mut().enumerate() {
        if input.zeros >> i & 1 == 1 {
            *b = 0.0;
        }
    }
    let k = f32::from(input.squash) / 255.0;
    let valid = Profile::<16>::from_squared_radii(&knots, &ordinates);
    if valid.is_err() {
        return;
    }
    let outline = Outline { name: "fuzzed", knots, ordinates, k, base_closed: false, top_closed: false };
    let far = (f32::from(input.far) / 16.0).exp2() / 8192.0;
    let mut direction = input.direction.map(|d| f32::from(d) / 32768.0);
    // Towards the horizontal by halves.
    direction[2] *= (-f32::from(input.level % 32)).exp2();
    let start = input.origin.map(|o| f32::from(o) / 16384.0);
    let mut origin: [f32; 3] = std::array::from_fn(|i| start[i] - far * direction[i]);
    origin[2] += 0.5;
    let cast = Cast { origin, direction, t_min: 0.0 };
    if Ray::new(cast.origin, cast.direction).is_err() {
        return;
    }
    let distance = origin.iter().map(|o| f64::from(*o).powi(2)).sum::<f64>().sqrt();
    let unit = (-24f64).exp2() * (outline.size() + distance);
    let truth = Truth::of(&outline, cast, unit);
    let largest = outline.ordinates.iter().fold(0f32, |size, b| size.max(*b));
    let doubt = UNITS * (-24f64).exp2() * f64::from(largest);
    let lathe = forms::turned(&outline);
    for answer in [
        forms::asked(&lathe, &cast),
        forms::shipped::<Split<math::Native>>(&lathe, &cast),
        forms::shipped::<Cardano<math::Micromath>>(&lathe, &cast),
    ] {
        let units = truth.judge_unsure(answer, doubt);
        // A crossing but for the rounding of t is as good as can be, however large that is.
        let is_rounded = answer.map(f64::from).is_some_and(|t| {
            truth.crossings.iter().any(|at| (at - t).abs() <= (-24f64).exp2() * at.abs())
        });
        assert!(
            is_rounded || units <= UNITS,
            "{cast:?} {outline:?}: {answer:?} is {units} units off; truth {:?}",
            truth.crossings
        );
    }
});
