//! Any numbers as a profile: what is accepted has no negative squared radius beyond the stated rounding, what is refused as negative has one, and a ray at what is accepted gives
//! numbers.
#![no_main]

use arbitrary::Arbitrary;
use embedded_lathe::{Lathe, Profile, ProfileError, Ray};
use laboratory::exact::{Exact, Polynomial, exact, float};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
struct Input {
    knots: Vec<f32>,
    ordinates: Vec<f32>,
    squash: f32,
    origin: [f32; 3],
    direction: [f32; 3],
}

fuzz_target!(|input: Input| {
    let Input { knots, ordinates, squash, origin, direction } = &input;
    let of = |segment: usize| &ordinates[first_ordinate(knots, segment)..][..4];
    let least = |segment: usize| least(of(segment));
    let profile = match Profile::<8>::from_squared_radii(knots, ordinates) {
        Ok(profile) => profile,
        Err(ProfileError::Negative { segment, .. }) => {
            // Or what lies beyond a step where the profile ends.
            let beyond = ordinates[0].min(ordinates[ordinates.len() - 1]);
            assert!(least(segment) < 0.0 || beyond < 0.0, "{input:?}");
            return;
        }
        Err(_) => return,
    };
    for segment in 0..profile.segments() {
        let largest = of(segment).iter().fold(0f32, |size, b| size.max(b.abs()));
        let slack = 2.0 * 8.0 / 16_777_216.0 * f64::from(largest) + f64::from(f32::from_bits(1));
        assert!(least(segment) >= -slack, "{input:?} {}", least(segment));
    }
    let Ok(profile) = profile.squash(*squash) else {
        assert!(!(0.0..=1.0).contains(squash));
        return;
    };
    let (lathe, Ok(ray)) = (Lathe::turn(profile.closed()), Ray::new(*origin, *direction)) else {
        return;
    };
    // Farther out distances overflow.
    let numbers = knots.iter().chain(origin);
    if numbers.fold(0f32, |size, x| size.max(x.abs())) > 1e15 {
        return;
    }
    let hits = lathe.hits::<33>(&ray, 0.0);
    for hit in &hits {
        assert!(!hit.t.is_nan() && (0.0..=1.0).contains(&hit.u), "{input:?} {hit:?}");
        let seen = lathe.surface(&ray, hit);
        assert!(!seen.normal.iter().any(|n| n.is_nan()), "{input:?} {hit:?} {seen:?}");
    }
    assert_eq!(lathe.nearest(&ray, 0.0), hits.first().copied(), "{input:?}");
    // One that lies within rounding of the ray's start may be a hit and have no place beyond it.
    let start = || {
        let largest = ordinates.iter().fold(0f32, |size, b| size.max(b.abs()));
        let lengths = knots.iter().chain(origin).map(|x| f64::from(*x)).chain([f64::from(largest).sqrt()]);
        let length = direction.iter().map(|d| f64::from(*d).powi(2)).sum::<f64>().sqrt();
        4.0 * (-24f64).exp2() * lengths.map(f64::abs).sum::<f64>() / length
    };
    let is_hit = lathe.is_hit(&ray, 0.0);
    assert!(is_hit || hits.is_empty(), "{input:?}");
    assert!(!is_hit || !hits.is_empty() || !lathe.hits::<33>(&ray, -start() as f32).is_empty(), "{input:?}");
});

/// The number of a segment's first ordinate: three for each segment below, and one for each step.
fn first_ordinate(knots: &[f32], segment: usize) -> usize {
    let (mut segments, mut first) = (0, 0);
    for pair in knots.windows(2) {
        if pair[0] == pair[1] {
            first += 1;
        } else if segments == segment {
            break;
        } else {
            (segments, first) = (segments + 1, first + 3);
        }
    }
    first
}

/// The exact least value of a segment, rounded once.
fn least(b: &[f32]) -> f64 {
    let [b0, b1, b2, b3]: [Exact; 4] = std::array::from_fn(|j| exact(b[j]));
    let three = exact(3.0);
    let (d1, d2) = (&b1 - &b0, &b2 - &b1);
    let f = Polynomial(vec![b0.clone(), &three * &d1, &three * (&d2 - &d1), &b3 - &b0 - &three * &d2]);
    let (zero, one) = (exact(0.0), exact(1.0));
    let turns = f.turns(&zero, &one).into_iter().map(|u| f.at(&u));
    turns.chain([b0, b3]).map(|f| float(&f)).fold(f64::INFINITY, f64::min)
}
