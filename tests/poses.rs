//! Poses and rotations against f64: composed, inverted, about a pivot, from quaternions and from matrices.

use embedded_lathe::{Pose, Rotation, SceneError, valid};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

/// Rounding of a handful of f32 operations on numbers of size 1.
const CLOSE: f64 = 1e-6;

type Matrix = [[f64; 3]; 3];

fn wide(rotation: Rotation) -> Matrix {
    rotation.rows().map(|row| row.map(f64::from))
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    a.map(|row| [0, 1, 2].map(|j| (0..3).map(|k| row[k] * b[k][j]).sum()))
}

fn transposed(m: Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i]))
}

/// The largest difference of two elements.
fn apart(a: Matrix, b: Matrix) -> f64 {
    let pairs = a.into_iter().flatten().zip(b.into_iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn numbers<const N: usize>(rng: &mut ChaCha8Rng, size: f32) -> [f32; N] {
    [(); N].map(|()| rng.random_range(-size..size))
}

fn rotation(rng: &mut ChaCha8Rng) -> Rotation {
    let [x, y, z] = numbers(rng, 3.0);
    Rotation::about_x(x).then(Rotation::about_y(y)).then(Rotation::about_z(z))
}

/// Position, rotation and scale applied to a point, in f64.
fn applied(pose: &Pose, point: [f64; 3]) -> [f64; 3] {
    let (m, s) = (wide(pose.rotation()), f64::from(pose.scale()));
    let turned = m.map(|row| s * (0..3).map(|k| row[k] * point[k]).sum::<f64>());
    [0, 1, 2].map(|i| f64::from(pose.position()[i]) + turned[i])
}

fn is_near(a: [f32; 3], b: [f64; 3], size: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (f64::from(*a) - b).abs() <= CLOSE * size)
}

#[test]
fn poses_are_composed_inverted_and_turned_about_a_pivot() {
    let mut rng = ChaCha8Rng::seed_from_u64(23);
    for case in 0..500 {
        let mut pose = || {
            let scale = rng.random_range(0.2..4.0);
            Pose::new(numbers(&mut rng, 2.0), rotation(&mut rng), scale).unwrap()
        };
        let (one, next) = (pose(), pose());
        let point: [f32; 3] = numbers(&mut rng, 1.5);
        let wide_point = point.map(f64::from);
        assert!(is_near(one.apply(point), applied(&one, wide_point), 16.0), "case {case}");
        let both = one.then(next).unwrap();
        let truth = applied(&next, applied(&one, wide_point));
        // The size of what is added: 4·(4·1.5·√3 + 2·√3) + 2·√3.
        assert!(is_near(both.apply(point), truth, 64.0), "case {case}: {:?} {truth:?}", both.apply(point));

        let back = one.inverse().unwrap();
        assert!(is_near(back.apply(one.apply(point)), wide_point, 64.0), "case {case}");
        let none = one.then(back).unwrap();
        assert!(apart(wide(none.rotation()), IDENTITY) < CLOSE && (none.scale() - 1.0).abs() < 1e-6);

        let turn = rotation(&mut rng);
        let about = Pose::about(point, turn).unwrap();
        assert!(is_near(about.apply(point), wide_point, 8.0), "case {case}");
        assert_eq!((about.rotation(), about.scale()), (turn, 1.0));
    }
}

#[test]
fn what_leaves_the_range_of_a_pose_is_an_error() {
    let at = |position, scale| Pose::new(position, Rotation::IDENTITY, scale).unwrap();
    let (large, small) = (at([1.0, 0.0, 0.0], 1e20), at([1.0, 0.0, 0.0], 1e-20));
    assert_eq!(large.then(large), Err(SceneError::Scale { scale: f32::INFINITY }));
    assert_eq!(small.then(small), Err(SceneError::Scale { scale: 1e-20 * 1e-20 }));
    let far = at([3e38, 0.0, 0.0], 1.0);
    assert_eq!(far.then(large), Err(SceneError::Position { position: [f32::INFINITY, 1e20 * 0.0, 0.0] }));
    let lost = at([-3e38, 0.0, 0.0], 1e-3).inverse();
    assert!(matches!(lost, Err(SceneError::Position { position: [f32::INFINITY, _, _] })), "{lost:?}");
    for scale in [1e-30, 1e30] {
        let back = at([0.0; 3], scale).inverse().unwrap();
        assert!((back.scale() * scale - 1.0).abs() < 1e-6 && back.inverse().is_ok());
    }
    let pivot = [0.0, f32::NAN, 0.0];
    assert!(matches!(Pose::about(pivot, Rotation::IDENTITY), Err(SceneError::Position { .. })));
    let wrong = SceneError::Rotation { row: 1, elements: [0.0, f32::NAN, f32::NAN] };
    assert_eq!(Pose::about([0.0; 3], Rotation::about_x(f32::NAN)), Err(wrong));
}

/// A quaternion of an axis and an angle, of any length, is that rotation.
#[test]
fn quaternions_are_the_rotations_that_they_stand_for() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for case in 0..500 {
        let angle = rng.random_range(-6.0..6.0);
        let axis: [f32; 3] = numbers(&mut rng, 1.0);
        let Ok(truth) = Rotation::about(axis, angle) else { continue };
        let length = axis.iter().map(|c| f64::from(*c).powi(2)).sum::<f64>().sqrt();
        let (sin, cos) = (0.5 * f64::from(angle)).sin_cos();
        let size = 10_f64.powi(rng.random_range(-30..30));
        let w = (size * cos) as f32;
        let v = axis.map(|c| (size * sin * f64::from(c) / length) as f32);
        for (w, v) in [(w, v), (-w, v.map(|c| -c))] {
            let found = Rotation::from_quaternion(w, v).unwrap();
            assert!(apart(wide(found), wide(truth)) < CLOSE, "case {case}: {w}, {v:?}");
        }
    }
    let nan = f32::NAN;
    for (w, v) in [
        (0.0, [0.0; 3]),
        (nan, [1.0; 3]),
        (1.0, [0.0, nan, 0.0]),
        (1.0, [0.0, 0.0, f32::INFINITY]),
        (1e-40, [0.0; 3]),
    ] {
        let error = Rotation::from_quaternion(w, v).unwrap_err();
        assert_eq!(error, SceneError::RotationQuaternion { w, v });
    }
    assert_eq!(Rotation::from_quaternion(f32::MAX, [0.0; 3]), Ok(Rotation::IDENTITY));
}

/// R is nearest to M if RᵀM is symmetric and has no negative eigenvalue, which for M near R it has not.
#[test]
fn a_matrix_gives_the_nearest_rotation() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let (mut accepted, mut refused) = (0, 0);
    for case in 0..2000 {
        let off = [1e-7, 1e-3, 0.02, 0.06][case % 4];
        let m = rotation(&mut rng).rows().map(|row| {
            let noise: [f32; 3] = numbers(&mut rng, off);
            [0, 1, 2].map(|j| row[j] + noise[j])
        });
        let wide_m = m.map(|row| row.map(f64::from));
        let skew = apart(product(wide_m, transposed(wide_m)), IDENTITY);
        match Rotation::from_rows(m) {
            Ok(found) => {
                accepted += 1;
                assert!(skew < 0.1 + CLOSE, "case {case}");
                let found = wide(found);
                assert!(apart(product(found, transposed(found)), IDENTITY) < CLOSE, "case {case}");
                let symmetric = product(transposed(found), wide_m);
                assert!(apart(symmetric, transposed(symmetric)) < CLOSE, "case {case}: {m:?}");
                assert!(apart(found, wide_m) < 0.1);
            }
            Err(SceneError::RotationRows { row, other, product: is }) => {
                refused += 1;
                let truth = product(wide_m, transposed(wide_m))[row][other];
                assert!((f64::from(is) - truth).abs() < CLOSE && skew > 0.1 - CLOSE, "case {case}");
            }
            Err(error) => panic!("case {case}: {error}"),
        }
    }
    assert!(accepted > 1500 && refused > 100, "{accepted} accepted, {refused} refused");

    let mirror = Rotation::from_rows([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]);
    assert_eq!(mirror, Err(SceneError::RotationMirrors { determinant: -1.0 }));
    let nan = Rotation::from_rows([[1.0, 0.0, 0.0], [0.0, f32::NAN, 0.0], [0.0, 0.0, 1.0]]);
    assert!(matches!(nan, Err(SceneError::RotationRows { row: 0, other: 1, .. })), "{nan:?}");
}

/// A thousandth of a turn a frame, for a million frames: it drifts, unless it is made a rotation again.
#[test]
fn a_rotation_composed_for_long_is_renewed() {
    let step = Rotation::about([0.3, -0.5, 0.8], 0.006).unwrap();
    let (mut drifts, mut renewed) = (Rotation::IDENTITY, Rotation::IDENTITY);
    for _ in 0..1_000_000 {
        drifts = drifts.then(step);
        renewed = Rotation::from_rows(renewed.then(step).rows()).unwrap();
    }
    let skew = |rotation| apart(product(wide(rotation), transposed(wide(rotation))), IDENTITY);
    assert!(skew(renewed) < CLOSE && skew(drifts) > 100.0 * CLOSE, "{:e}, {:e}", skew(renewed), skew(drifts));
}

/// All of it at compile time, too.
#[test]
fn poses_are_composed_by_the_compiler() {
    const TURN: Rotation = valid!(Rotation::from_quaternion(1.0, [0.0, 0.0, 1.0]));
    const SAME: Rotation = valid!(Rotation::from_rows(TURN.inverse().inverse().rows()));
    const KNOB: Pose = valid!(Pose::about([1.0, 0.0, 0.0], SAME));
    const POINTER: Pose = valid!(Pose::IDENTITY.then(KNOB)?.then(valid!(KNOB.inverse()))?);
    assert!(apart(wide(POINTER.rotation()), IDENTITY) < CLOSE && is_near(POINTER.position(), [0.0; 3], 1.0));
    assert!(is_near(KNOB.apply([2.0, 0.0, 0.0]), [1.0, 1.0, 0.0], 1.0));
}
