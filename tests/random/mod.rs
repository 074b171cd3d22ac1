//! Solids and cameras at random.

use embedded_lathe::{Camera, End, Lathe, Pose, Profile, Rgb, Rotation, Segment, Solid};
use rand::RngExt;
use rand::rngs::ChaCha8Rng;

pub fn even(rng: &mut ChaCha8Rng, from: f32, to: f32) -> f32 {
    rng.random_range(from..to)
}

/// One to eight segments of uneven height, some of whose ends are poles or creases. One lathe of three has steps.
pub fn random_lathe(rng: &mut ChaCha8Rng) -> Lathe<[Segment; 8]> {
    loop {
        let segments = rng.random_range(1..=8);
        let mut knots = vec![even(rng, -1.0, 0.0)];
        let mut ordinates = vec![if rng.random_ratio(1, 4) { 0.0 } else { even(rng, 0.0, 0.6) }];
        for _ in 0..segments {
            let is_low = rng.random_ratio(1, 8);
            let height = if is_low { 10_f32.powf(even(rng, -6.0, -2.0)) } else { even(rng, 0.03, 0.5) };
            knots.push(knots[knots.len() - 1] + height);
            // Smooth three times out of four, if heights were even.
            let last = ordinates[ordinates.len() - 1];
            let lean = if ordinates.len() > 1 { last - ordinates[ordinates.len() - 2] } else { 0.0 };
            let smooth = rng.random_ratio(3, 4) && last + lean >= 0.0;
            ordinates.push(if smooth { last + lean } else { even(rng, 0.0, 0.6) });
            ordinates.push(even(rng, 0.0, 0.6));
            ordinates.push(if rng.random_ratio(1, 12) { 0.0 } else { even(rng, 0.0, 0.6) });
        }
        if rng.random_ratio(1, 3) {
            // From the top down, so that places below stay as they are.
            for knot in (0..=segments).rev() {
                if rng.random_ratio(1, 3) {
                    knots.insert(knot, knots[knot]);
                    ordinates.insert(3 * knot, even(rng, 0.0, 0.6));
                }
            }
        }
        let end = |open| if open { End::Open } else { End::Capped };
        let squash = if rng.random_ratio(1, 3) { even(rng, 0.1, 1.0) } else { 1.0 };
        if let Ok(profile) =
            Profile::<8>::from_squared_radii(&knots, &ordinates).and_then(|profile| profile.squash(squash))
        {
            // A ring at an end stays there every other time.
            let profile = if rng.random() { profile.base(end(rng.random())) } else { profile };
            return Lathe::turn(if rng.random() { profile.top(end(rng.random())) } else { profile });
        }
    }
}

/// From all around, also from within, above, near the axis and across: c changes its sign within rows.
pub fn random_camera(rng: &mut ChaCha8Rng) -> Camera {
    loop {
        let vector = |rng: &mut ChaCha8Rng, size: f32| [(); 3].map(|()| even(rng, -size, size));
        let distance: f32 = [0.3, 1.5, 3.0, 6.0][rng.random_range(0..4)];
        let mut eye = vector(rng, distance);
        match rng.random_range(0..4) {
            0 => (eye[0], eye[1]) = (0.01 * eye[0], 0.01 * eye[1]),
            1 => eye[2] = even(rng, -0.3, 0.3),
            _ => {}
        }
        let (target, up) = (vector(rng, 0.3), vector(rng, 1.0));
        let wide = even(rng, 0.2, 1.0) / distance.max(1.0);
        let camera = if rng.random_ratio(1, 4) {
            Camera::orthographic(eye, target, up, even(rng, 0.2, 1.5))
        } else {
            Camera::perspective(eye, target, up, wide)
        };
        if let Ok(camera) = camera {
            return camera;
        }
    }
}

/// Upright, somewhere around the axis, and looking at it: rows are their own mirror image.
pub fn upright_camera(rng: &mut ChaCha8Rng) -> Camera {
    loop {
        let distance: f32 = [0.3, 1.5, 3.0, 6.0][rng.random_range(0..4)];
        let turn = Rotation::about_z(even(rng, -3.0, 3.0));
        let eye = turn.apply([0.0, -distance, even(rng, -distance, distance)]);
        let (target, up) = ([0.0, 0.0, even(rng, -0.3, 0.3)], [0.0, 0.0, 1.0]);
        let camera = if rng.random() {
            Camera::orthographic(eye, target, up, even(rng, 0.2, 1.5))
        } else {
            Camera::perspective(eye, target, up, even(rng, 0.2, 1.0) / distance.max(1.0))
        };
        if let Ok(camera) = camera {
            return camera;
        }
    }
}

/// One to three lathes, for [`posed`].
#[allow(dead_code)]
pub fn random_lathes(rng: &mut ChaCha8Rng) -> Vec<Lathe<[Segment; 8]>> {
    (0..rng.random_range(1..=3)).map(|_| random_lathe(rng)).collect()
}

/// The lathes as solids, each turned, of another size and color, about the origin.
#[allow(dead_code)]
pub fn posed<'a>(rng: &mut ChaCha8Rng, lathes: &'a [Lathe<[Segment; 8]>]) -> Vec<Solid<'a>> {
    let colors = [Rgb::new(1.0, 0.2, 0.1), Rgb::new(0.2, 0.9, 0.3), Rgb::new(0.3, 0.4, 1.0)];
    let mut pose = || {
        let turn = Rotation::about_x(even(rng, -3.0, 3.0)).then(Rotation::about_z(even(rng, -3.0, 3.0)));
        let place = [(); 3].map(|()| even(rng, -0.7, 0.7));
        Pose::new(place, turn, even(rng, 0.2, 1.0)).unwrap()
    };
    lathes.iter().zip(colors).map(|(lathe, color)| Solid::new(lathe, color).posed(pose())).collect()
}
