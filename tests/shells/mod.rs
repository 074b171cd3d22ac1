//! Shells at random: bodies of which no sheet hides another from outside.

use crate::random::even;
use embedded_lathe::{Lathe, Profile, Segment};
use rand::RngExt;
use rand::rngs::ChaCha8Rng;

/// Knots and squared radii.
type Outline = (Vec<f32>, Vec<f32>);

/// Lathes of an outer sheet and of its hollows: one from above, which goes through to the base or ends above
/// one from below, if there is such a one. Rims are rings of either sheet, or edges.
pub fn random_shell(rng: &mut ChaCha8Rng) -> Vec<Lathe<[Segment; 2]>> {
    let mut squares = |from, to| [(); 7].map(|()| even(rng, from, to)).to_vec();
    let [outer, hollow, foot] = [squares(0.22, 0.6), squares(0.0, 0.18), squares(0.0, 0.18)];
    let (is_tube, has_foot) = (rng.random_ratio(1, 3), rng.random());
    let mut outer = (vec![0.0, even(rng, 0.1, 0.9), 1.0], outer);
    let mut hollow = (vec![if is_tube { 0.0 } else { even(rng, 0.4, 0.7) }, 0.8, 1.0], hollow);
    let mut foot = (vec![0.0, 0.2, 0.3], foot);
    join(rng, &mut outer, &mut hollow, true);
    if is_tube {
        join(rng, &mut outer, &mut hollow, false);
    } else {
        step(&mut hollow, false, 0.0);
        step(&mut foot, true, 0.0);
        if has_foot {
            join(rng, &mut outer, &mut foot, false);
        } else {
            step(&mut outer, false, 0.0);
        }
    }
    let profile =
        |(knots, squares): Outline| Profile::<2>::from_squared_radii(&knots, &squares).expect("a sheet");
    let outer = profile(outer);
    let mut lathes = vec![Lathe::turn(outer), Lathe::turn_beside(profile(hollow), &outer)];
    if has_foot && !is_tube {
        lathes.push(Lathe::turn_beside(profile(foot), &outer));
    }
    lathes
}

/// Gives an outline a step to a squared radius at its upper end, or at its lower one.
fn step((knots, squares): &mut Outline, is_upper: bool, square: f32) {
    let (last, all) = if is_upper { (knots.len() - 1, squares.len()) } else { (0, 0) };
    knots.insert(last, knots[last]);
    squares.insert(all, square);
}

/// Joins a hollow to the outer sheet at an end, by a ring of either, or where both have one radius.
fn join(rng: &mut ChaCha8Rng, outer: &mut Outline, hollow: &mut Outline, is_upper: bool) {
    let end = |(_, squares): &Outline| squares[if is_upper { squares.len() - 1 } else { 0 }];
    match rng.random_range(0..3) {
        0 => step(outer, is_upper, end(hollow)),
        1 => step(hollow, is_upper, end(outer)),
        _ => hollow.1[if is_upper { 6 } else { 0 }] = end(outer),
    }
}
