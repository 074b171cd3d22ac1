//! Outlines that are cubic in squared radius over height come out as they are.

use embedded_lathe_outline::{Fit, Outline, Piece, Side, body, point, read};
use std::f64::consts::{FRAC_PI_2, PI};

/// Segments and the proven error, in sizes of the outline.
fn fitted(outline: &Outline, tolerance: f64) -> (usize, f64) {
    let body = body(outline, &Fit::within(tolerance)).expect("an outline");
    (body.segments(), body.error / outline.size())
}

/// A few units of 2⁻²⁴: rounding of heights and squared radii to f32, twice.
const ROUNDING: f64 = 8.0 / 16_777_216.0;

#[test]
fn quadrics_are_one_segment_each() {
    let circle =
        |from: f64, sweep: f64| Piece::arc(point(0.0, 2.0), point(1.5, 0.0), point(0.0, 1.5), from, sweep);
    let ellipse = Piece::arc(point(0.0, -1.0), point(0.5, 0.0), point(0.0, 2.0), -FRAC_PI_2, PI);
    let cases = [
        ("cylinder", vec![Piece::line(point(1.0, 0.0), point(1.0, 3.0))]),
        ("cone", vec![Piece::line(point(1.0, 0.0), point(0.0, 3.0))]),
        (
            "frustum, raised to degree 3",
            vec![Piece::bezier(&[point(1.0, 0.0), point(2.0, 1.0), point(3.0, 2.0), point(4.0, 3.0)])],
        ),
        ("sphere of two quarters", circle(-FRAC_PI_2, PI)),
        ("part of a sphere", circle(-1.1, 2.3)),
        ("spheroid", ellipse),
        ("sphere drawn downwards", circle(FRAC_PI_2, -PI)),
        ("a cubic in squared radius", vec![Piece::squares([0.0, 1.0], [0.04, 0.3, -0.05, 0.2])]),
    ];
    for (name, pieces) in cases {
        let (segments, error) = fitted(&Outline::open(pieces).unwrap(), 0.1);
        assert!(segments == 1 && error <= ROUNDING, "{name}: {segments} segments, off by {error:e}");
    }
}

#[test]
fn corners_are_kept_and_straight_lines_exact() {
    // A cup with a wall and a floor, in millimeters.
    let cup = [
        [20.0, 0.0],
        [24.0, 40.0],
        [30.0, 60.0],
        [28.0, 60.0],
        [22.0, 40.0],
        [18.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
    ];
    let outline = Outline::polygon(&cup.map(|[r, z]| point(r, z)), true).unwrap();
    let body = body(&outline, &Fit::within(1.0)).unwrap();
    assert_eq!(body.segments(), 4);
    assert!(body.error <= ROUNDING * outline.size());
    let [outer, inner] = body.sheets.as_slice() else { panic!("{body:?}") };
    assert_eq!((outer.side, outer.base, outer.top), (Side::Outer, Some(0.0), Some(784.0)));
    assert_eq!((inner.side, inner.base, inner.top), (Side::Inner, Some(0.0), None));
    assert_eq!(outer.knots, [0.0, 40.0, 60.0]);
    assert_eq!(inner.knots, [4.0, 40.0, 60.0]);
    assert_eq!(outer.ordinates[..4], [400.0, 453.33334, 512.0, 576.0]);
}

#[test]
fn steps_stand_twice() {
    // A knob: a rim, a ledge, a stem.
    let knob = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 4.0], [0.0, 4.0]];
    let outline = Outline::polygon(&knob.map(|[r, z]| point(r, z)), false).unwrap();
    let body = body(&outline, &Fit::within(0.01)).unwrap();
    let [sheet] = body.sheets.as_slice() else { panic!("{body:?}") };
    assert_eq!(sheet.knots, [0.0, 1.0, 1.0, 4.0]);
    assert_eq!(sheet.ordinates, [9.0, 9.0, 9.0, 9.0, 4.0, 4.0, 4.0, 4.0]);
    assert_eq!((sheet.base, sheet.top, body.segments()), (Some(0.0), Some(0.0), 2));
}

#[test]
fn a_spline_in_squared_radius_is_not_fitted() {
    let form = r#"{"kind": "sor", "points": [[0.1, -0.1], [0.12, 0.0], [0.3, 0.4], [0.2, 0.7], [0.25, 1.0], [0.3, 1.1]]}"#;
    let drawing = read::json(form, &read::Options::default()).unwrap();
    let (segments, error) = fitted(&drawing.outline, 0.2);
    assert!(segments == 3 && error <= ROUNDING, "{segments} segments, off by {error:e}");
}
