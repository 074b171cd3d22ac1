//! What fuzzing and the first runs found, by its inputs.

use embedded_lathe::solve::BACKWARD_ERROR;
use embedded_lathe::{Cubic, Lathe, Profile, Ray};
use laboratory::cases::{Cast, Outline};
use laboratory::contenders::{EVERYWHERE, HOST};
use laboratory::forms::{METHODS, turned};
use laboratory::hits::Truth as HitTruth;
use laboratory::judge::Truth;
use laboratory::{PROMISE, ROUNDOFF};

fn solved(c: [f32; 4], lo: f32, hi: f32) {
    let truth = Truth::promised(&c, lo, hi);
    for method in EVERYWHERE.iter().chain(HOST).filter(|method| method.shipped) {
        let answer = (method.first_root)(&c, lo, hi);
        let units = truth.judge(answer.map(f64::from)).units;
        let (method, backend, roots) = (method.method, method.backend, &truth.roots);
        assert!(
            units <= f64::from(BACKWARD_ERROR),
            "{method} over {backend}: {c:?} on [{lo}, {hi}]: {answer:?}, roots {roots:?}, {units} units"
        );
    }
    for root in Cubic::new(c).roots(lo, hi) {
        let units = truth.residual(root.into());
        assert!(units <= f64::from(BACKWARD_ERROR), "{c:?} on [{lo}, {hi}]: {root}, {units} units");
    }
}

fn met(knots: &[f32], ordinates: &[f32], k: f32, origin: [f32; 3], direction: [f32; 3]) {
    met_unsure(0.0, knots, ordinates, k, origin, direction);
}

/// The same if the squared radius may be off.
fn met_unsure(doubt: f64, knots: &[f32], ordinates: &[f32], k: f32, origin: [f32; 3], direction: [f32; 3]) {
    let outline = Outline {
        name: "found",
        knots: knots.to_vec(),
        ordinates: ordinates.to_vec(),
        k,
        base_closed: false,
        top_closed: false,
    };
    let cast = Cast { origin, direction, t_min: 0.0 };
    let truth = HitTruth::of(&outline, cast, outline.unit(origin));
    for (_, solver, nearest) in METHODS.iter().filter(|(form, ..)| *form == "crate") {
        let answer = nearest(&outline, &cast);
        let units = truth.judge_unsure(answer, doubt);
        let crossings = &truth.crossings;
        assert!(
            units <= PROMISE,
            "{solver}: {outline:?} {cast:?}: {answer:?}, crossings {crossings:?}, {units} units"
        );
    }
}

/// Values that overflow far out have a sign all the same.
#[test]
fn powers_that_overflow() {
    solved([0.0, 5.785636e-39, 1.83671e-40, 6.162976e-33], -1.9983972e18, 1.6543612e-24);
}

/// Far out, how all roots' search starts is a question for the unit that is used there.
#[test]
fn a_start_in_its_own_unit() {
    let c = [-1.1876598e38, -2.0803189e-8, -2.0803189e-8, -2.0803189e-8];
    solved(c, -1.701448e38, -7.450581e-9);
    assert_eq!(Cubic::new(c).roots(-1.701448e38, -7.450581e-9).len(), 1);
}

/// Drafts of the solver without a bracket failed on these: a minimum that all but touches zero; a triple
/// root, where the slope is nothing; a root at 10⁻²⁰ reckoned from a point of inflection at 10¹³; and one at
/// 10¹⁹ where the terms are of the size of 10⁴⁰.
#[test]
fn without_a_bracket() {
    solved([2.5239446, -1.6659768, -1.144438, 0.7555574], 0.5, 1.5);
    solved([0.0, 0.0, 0.0, -3.0], -4.0, 4.0);
    solved([2.9802322e-8, 2879611500000.0, 0.08935399, 8.881784e-16], -0.5, 0.5);
    solved([-1.0193732e-5, -5.9074003e-17, -114.65907, 8.695641e-18], -2.37e11, 1.456e19);
}

/// Where terms underflow a Newton iteration may go to and fro between two numbers for ever: this took for
/// ever.
#[test]
fn a_solve_that_did_not_end() {
    solved([1e-45, 6.012e-42, 1.964554e-24, -0.13838196], -0.033224195, 0.99316406);
}

/// Terms that underflow in a cubic whose largest coefficient is 2⁻²⁰, the least that is solved as it is.
#[test]
fn what_does_not_count() {
    solved([9.1698e-41, 2.547e-41, 8.61e-42, 2.7151555e-6], -41730.0, 1.9669537e-6);
    solved([8.8e-44, 4.935213e-34, 2.204052e-39, -1.2815221e-6], 5.803302e-39, 12815.803);
}

/// The tip of a cone is a double root of the squared radius: the surface is known there to the square root of what g is.
#[test]
fn conical_poles() {
    let cone = |origin, direction| met(&[0.0, 2.0], &[2.25, 0.75, 0.0, 0.0], 1.0, origin, direction);
    let horn = |origin, direction| met(&[-0.5, 1.0], &[0.3, 0.5, 0.0, 0.0], 1.0, origin, direction);
    cone([0.0, 0.0, -3.8670805], [0.0, 0.0, 1.0]);
    cone([2.7930758, 1.7313111, -1.3935946], [-0.5912634, -0.36652043, 0.71838033]);
    horn([-3.3501995, -0.6608515, 1.3132836], [0.97699165, 0.19271894, -0.09136043]);
    horn([-0.14866678, -2.4716709, 1.6911535], [0.05782981, 0.9614443, -0.2688505]);
}

/// A tip met by a ray along the axis: g is a parabola whose double root is its end, and its rounded values do not reach zero.
#[test]
fn a_tip_beside_the_end_of_a_parabola() {
    let cone = [1.8305972, 0.61019903, 0.0, 0.0];
    met(&[0.0, 1.6416687], &cone, 1.0, [0.0, 0.0, -4.6322885], [0.0, 0.0, 1.0]);
}

/// From a seed beside a turning point at 10⁻³⁸ steps that may only double u do not get far enough.
#[test]
fn far_from_a_turning_point() {
    solved([0.5, 1.2035114e-38, -0.18596761, 1e-45], -133123.9, 8.61e-42);
    solved([1.8626451e-9, 1.7357155e-38, -0.031296432, 1.6806e-41], -34359740000.0, 0.125);
}

/// The same tips met by rays along the axis, which are nearest to it everywhere.
#[test]
fn conical_poles_along_the_axis() {
    let tip = [0.0, 0.0, 0.0, 0.0, 0.21955872, 0.0, 0.0];
    met(
        &[0.0, 0.421875, 0.84375],
        &tip,
        1.0,
        [-6.1035156e-5, -6.1035156e-5, 0.51556396],
        [0.0, 0.0, 6.1035156e-5],
    );
    met(
        &[0.0, 1.7578125],
        &[0.0, 0.21044922, 0.0, 0.0],
        0.0,
        [0.0, 0.0, 0.51068085],
        [0.0, 0.0, 0.0022277832],
    );
}

/// Two conical poles in one segment, along the axis: far from the one that its cubic is formed about the other is found anew.
#[test]
fn a_far_conical_pole_along_the_axis() {
    let [b1, b2] = [0.99998474_f32, 0.0038909912];
    met(
        &[1.84375, 2.265625, 2.65625, 3.0390625],
        &[0.0, 0.12109375, 0.99998474, 0.0, b1, b2, 0.0, 1.5258789e-5, 0.99993896, 0.99998474],
        0.0,
        [0.0, 0.0, 2.125],
        [0.0, 0.0, 2.7263013e-8],
    );
}

/// Along a sheet's edge that tapers to nothing, where g vanishes all but doubly: Newton's steps there are of any length.
#[test]
fn an_edge_that_tapers_away() {
    let largest = f64::from(0.22212219_f32);
    met_unsure(
        4.0 * PROMISE * largest * ROUNDOFF,
        &[0.0, 0.421875, 0.84375],
        &[0.0007324219, 0.0, 0.0, 0.0, 0.22212219, 0.0, 0.0],
        0.0,
        [0.23460878, -6.1035156e-5, 8.160765],
        [-3.0517578e-5, 0.0, -1.0],
    );
}

/// A segment so low that its knots are one height in the frame, between two that make a crease.
#[test]
fn a_segment_of_no_height() {
    met(
        &[-1.0, 0.0, 1e-9, 1.5],
        &[0.125, 0.1167, 0.10833, 0.1, 0.1, 0.1, 0.1, 1.0, 2.0, 3.0],
        1.0,
        [0.0, -0.5, -0.1],
        [1.0, 0.0, 1.0],
    );
}

/// A tip whose slope is of no normal size has the axis for its normal: its own, brought to one, was not a number.
#[test]
fn a_tip_all_but_without_a_slope() {
    let profile = Profile::<1>::from_squared_radii(&[0.0, 1.0], &[1.0, 1.0, 1e-40, 0.0]).expect("valid");
    let (lathe, ray) = (Lathe::turn(profile), Ray::new([0.0, 0.0, 2.0], [0.0, 0.0, -1.0]).expect("finite"));
    let hit = lathe.nearest(&ray, 0.0).expect("the tip");
    assert_eq!(lathe.surface(&ray, &hit).normal, [0.0, 0.0, 1.0]);
}

/// The waist of an hourglass that has no radius: a knot lies there, as the promise asks.
#[test]
fn a_waist_of_no_radius() {
    let ordinates = [0.25, 0.083333336, 0.0, 0.0, 0.0, 0.083333336, 0.25];
    let hourglass = |origin, direction| met(&[0.0, 0.5, 1.0], &ordinates, 1.0, origin, direction);
    hourglass([1.644349, 2.7422183, 2.903231], [-0.41108724, -0.68555456, -0.60085124]);
    hourglass([-0.34456694, 0.90732765, -1.2490969], [0.17228347, -0.45366383, 0.8743612]);
}

/// A body that ends on a thread of no radius: what is inside it to within rounding is outside the thread by all there is.
#[test]
fn the_end_of_a_thread() {
    met_unsure(
        4.0 * PROMISE * ROUNDOFF,
        &[0.0, 0.421875, 2.421875, 8.421875],
        &[0.0, 0.0, 0.0, 0.0, 0.9979553, 0.0006713867, 3.0517578e-5, 0.0015716553, 0.0, 0.0],
        0.0,
        [-2.0945234, 0.00023378986, 0.44240683],
        [0.27340698, -3.0517578e-5, -0.0015487671],
    );
}

/// A disc a million times wider than high.
#[test]
fn any_hit_and_all_hits_of_a_sheet() {
    let outline = Outline {
        name: "found",
        knots: vec![2.2962903e-9, 236749.61],
        ordinates: vec![5.0586885e22, 6.770577e22, 6.770577e22, 5.3410435e-8],
        k: 6.7759308e-21,
        base_closed: true,
        top_closed: true,
    };
    let ray = Ray::new([1.399e-41, 0.0, 1.6495023e-33], [1.089e-42, 1.6490775e-33, 1.8183441e-38]);
    let (lathe, ray) = (turned(&outline), ray.expect("finite"));
    assert_eq!(lathe.is_hit(&ray, 0.0), !lathe.hits::<65>(&ray, 0.0).is_empty());
}

/// Another, that is lower than rounding at the distance of the ray's origin.
#[test]
fn the_nearest_hit_and_all_hits_of_a_sheet() {
    let outline = Outline {
        name: "found",
        knots: vec![-1633.7247, 3.0573823e-21],
        ordinates: vec![5.05131e22, 6.770577e22, 6.770577e22, 3.0360317e-21],
        k: 4.749539e-39,
        base_closed: true,
        top_closed: true,
    };
    let ray = Ray::new(
        [2.2904043e-38, -8.38089e-27, 38273630000.0],
        [-1.5002766e-26, -1.5002785e-26, -1.5002785e-26],
    );
    let (lathe, ray) = (turned(&outline), ray.expect("finite"));
    assert_eq!(lathe.nearest(&ray, 0.0), lathe.hits::<65>(&ray, 0.0).first().copied());
}

/// A place much narrower than the segment's largest ordinate: the cubic is known there to units of that ordinate, the hit, found
/// anew, to units of the size.
#[test]
fn a_narrow_place_of_a_wide_segment() {
    let narrow =
        |knots: &[f32], segment: &[f32], origin, direction| met(knots, segment, 1.0, origin, direction);
    narrow(
        &[-0.6152427, -0.15876913],
        &[0.07037023, 0.07037023, 0.5998043, 0.07939239],
        [-0.09009674, 0.1747075, -0.15261519],
        [-0.19044228, 0.06442066, -0.9795824],
    );
    narrow(
        &[0.0016873094, 0.0018696894],
        &[5.654629e-7, 4.1573318e-7, 5.157314e-6, 9.4204256e-7],
        [0.00028825656, 0.0006945444, 0.001687332],
        [-0.41606992, -0.30137932, 0.88148],
    );
}

/// A ball so far behind that the hits' t are no numbers: asked for from there on, nothing is hit, by any.
#[test]
fn any_hit_of_a_ball_beyond_all_numbers() {
    let ball = Lathe::turn(Profile::<1>::sphere(1.0).unwrap());
    let ray = Ray::new([0.0, 1e20, 0.0], [0.0, 1e-20, 0.0]).expect("finite");
    assert_eq!(ball.nearest(&ray, f32::NEG_INFINITY), None);
    assert!(ball.hits::<5>(&ray, f32::NEG_INFINITY).is_empty());
    assert!(!ball.is_hit(&ray, f32::NEG_INFINITY));
}
