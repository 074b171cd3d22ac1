//! The generators: every class of ray and outline they promise has come up.

use laboratory::cases::{Case, Family, Outline, case, cases, outline, outlines};
use laboratory::oracle::{self, bands, crossings, robust};
use laboratory::{PROMISE, ROUNDOFF};
use std::collections::HashSet;

const SEED: u64 = 8;
const RAYS: u64 = 400;

fn each(family: Family, mut look: impl FnMut(&Case)) {
    for outline in &outlines() {
        cases(outline, family, SEED, RAYS).for_each(|case| look(&case));
    }
}

/// How many of the family's rays are so.
fn share(family: Family, so: impl Fn(&Case) -> bool) -> f64 {
    let (mut count, mut all) = (0, 0);
    each(family, |case| {
        all += 1;
        count += usize::from(so(case));
    });
    f64::from(count as u32) / f64::from(all)
}

/// The least and the greatest.
fn range(family: Family, value: impl Fn(&Case) -> f64) -> [f64; 2] {
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    each(family, |case| range = [range[0].min(value(case)), range[1].max(value(case))]);
    range
}

fn covers(family: Family, [low, high]: [f64; 2], value: impl Fn(&Case) -> f64) {
    let [least, greatest] = range(family, value);
    assert!(least <= low && high <= greatest, "{family:?}: {least:e} to {greatest:e}");
}

fn length(v: [f32; 3]) -> f64 {
    v.iter().map(|&c| f64::from(c).powi(2)).sum::<f64>().sqrt()
}

fn sizes_away(case: &Case) -> f64 {
    let [x, y, z] = case.cast.origin;
    length([x, y, z - case.outline.middle() as f32]) / case.outline.size()
}

fn on_knot(case: &Case) -> bool {
    case.outline.knots.contains(&case.cast.origin[2])
}

fn start_inside(case: &Case) -> bool {
    case.outline.shape().inside(case.ray().origin)
}

#[test]
fn the_same_seed_and_index_make_the_same_ray() {
    for outline in &outlines() {
        for family in Family::ALL {
            let list: Vec<Case> = cases(outline, family, SEED, 20).collect();
            assert!(list.iter().all(|made| case(outline, family, SEED, made.index).cast == made.cast));
            let different: HashSet<[u32; 3]> = list.iter().map(|c| c.cast.origin.map(f32::to_bits)).collect();
            assert!(different.len() > 15 || family == Family::ThroughAxis, "{family:?} {}", outline.name);
        }
    }
}

#[test]
fn every_case_is_finite_and_points_somewhere() {
    for family in Family::ALL {
        each(family, |case| {
            let numbers = [case.cast.origin, case.cast.direction, [case.cast.t_min; 3]];
            assert!(
                numbers.iter().flatten().all(|c| c.is_finite()) && length(case.cast.direction) > 0.0,
                "{case}"
            );
        });
    }
}

/// Hits, misses, and rays that f32 can be held to, in every family and on every outline.
#[test]
fn families_hit_miss_and_are_mostly_robust() {
    for family in Family::ALL {
        let hits = share(family, |case| !crossings(&case.outline.shape(), &case.ray()).is_empty());
        let sure = share(family, |case| robust(&case.outline.shape(), &case.ray(), case.eps(8.0)));
        let first = share(family, |case| {
            let bands = bands(&case.outline.shape(), &case.ray(), case.eps(8.0));
            bands.complete || !bands.sure.is_empty()
        });
        println!("{family:?}: {hits:.3} hit, {sure:.3} robust, {first:.3} sure of the first");
        let least_sure = match family {
            Family::Horizontal | Family::AxisParallel => 0.75,
            Family::Grazing | Family::Far | Family::Rims => 0.6,
            _ => 0.95,
        };
        let most_hits = if family == Family::Inside { 1.0 } else { 0.99 };
        assert!((0.2..=most_hits).contains(&hits), "{family:?}: {hits} hit");
        assert!(least_sure < sure && sure <= first, "{family:?}: {sure} robust");
    }
    for outline in &outlines() {
        let list = || Family::ALL.into_iter().flat_map(|family| cases(outline, family, SEED, 100));
        let count = |so: &dyn Fn(&Case) -> bool| list().filter(|case| so(case)).count();
        let shape = outline.shape();
        let hit = count(&|case| !crossings(&shape, &case.ray()).is_empty());
        let twice = count(&|case| crossings(&shape, &case.ray()).len() > 1);
        println!("{}: {hit} hit, {twice} more than once, of 1300", outline.name);
        assert!((400..1250).contains(&hit) && twice > 200, "{}: {hit} {twice}", outline.name);
    }
}

#[test]
fn random_and_unnormalised_reach_their_lengths() {
    covers(Family::Unnormalised, [2e-3, 500.0], |case| length(case.cast.direction));
    let [least, greatest] = range(Family::Random, |case| length(case.cast.direction));
    assert!(0.999_999 < least && greatest < 1.000_001);
    covers(Family::Random, [0.02, 0.98], |case| case.cast.steepness());
}

#[test]
fn cameras_stand_level_and_above() {
    let at_eye_level =
        share(Family::Camera, |c| (f64::from(c.cast.origin[2]) - c.outline.middle()).abs() < 1e-3);
    assert!((0.4..0.6).contains(&at_eye_level), "{at_eye_level}");
    covers(Family::Camera, [1.6, 4.8], sizes_away);
    assert!(range(Family::Camera, |case| length(case.cast.direction))[1] > 1.05);
}

#[test]
fn near_horizontal_rays_reach_every_power_of_ten() {
    covers(Family::NearHorizontal, [1.1e-8, 0.09], |case| case.cast.steepness());
    for power in -8..-1 {
        let tenth = share(Family::NearHorizontal, |c| c.cast.steepness().log10().floor() as i32 == power);
        assert!(tenth > 0.1, "1e{power}: {tenth}");
    }
    assert!((0.4..0.6).contains(&share(Family::NearHorizontal, |case| case.cast.direction[2] > 0.0)));
}

#[test]
fn horizontal_rays_run_at_knots_and_beside_them() {
    for family in [Family::Horizontal, Family::AxisParallel] {
        assert_eq!(share(family, |case| case.cast.direction[2] == 0.0), 1.0);
        assert!(share(family, on_knot) > 0.25);
        let beside = share(family, |case| {
            let z = case.cast.origin[2];
            case.outline.knots.iter().any(|&knot| z == knot.next_up() || z == knot.next_down())
        });
        assert!(beside > 0.25, "{beside}");
        let ends = share(family, |c| {
            [c.outline.knots.first(), c.outline.knots.last()].contains(&Some(&c.cast.origin[2]))
        });
        let joins = share(family, on_knot) - ends;
        assert!(ends > 0.1 && joins > 0.05, "{ends} {joins}");
    }
}

#[test]
fn axis_parallel_and_vertical_rays_are_so_exactly() {
    let only = |axis: usize, c: &Case| (0..3).all(|i| (c.cast.direction[i] != 0.0) == (i == axis));
    for (axis, family) in [(0, Family::AxisParallel), (1, Family::AxisParallel), (2, Family::Vertical)] {
        for sign in [1.0, -1.0] {
            let so = share(family, |case| only(axis, case) && case.cast.direction[axis] == sign);
            assert!(so > 0.2, "{axis} {sign}: {so}");
        }
    }
    assert_eq!(share(Family::Vertical, |case| only(2, case)), 1.0);
    let on_axis = share(Family::Vertical, |case| case.cast.origin[..2] == [0.0, 0.0]);
    assert!((0.08..0.2).contains(&on_axis), "{on_axis}");
}

/// Past the silhouette on both sides: with the tolerance grown from a ten-millionth to a hundredth, more and more is doubtful.
#[test]
fn grazing_rays_pass_at_every_distance() {
    let doubtful = |part: f64| {
        share(Family::Grazing, |c| !robust(&c.outline.shape(), &c.ray(), part * c.outline.size()))
    };
    let shares = [1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2].map(doubtful);
    assert!(shares.is_sorted() && shares[0] < 0.1 && shares[5] > 0.9, "{shares:?}");
    assert!(shares.windows(2).skip(1).all(|pair| pair[1] - pair[0] > 0.1), "{shares:?}");
    // To a silhouette on the outside, half hit: two crossings or none, at the place aimed at.
    let sphere = outline("sphere");
    let hits = cases(&sphere, Family::Grazing, SEED, RAYS)
        .filter(|c| !crossings(&sphere.shape(), &c.ray()).is_empty());
    assert!((150..250).contains(&hits.count()));
}

#[test]
fn rims_are_missed_by_little_and_by_much() {
    let doubtful =
        |part: f64| share(Family::Rims, |c| !robust(&c.outline.shape(), &c.ray(), part * c.outline.size()));
    let shares = [1e-8, 1e-6, 1e-4, 1e-2].map(doubtful);
    assert!(shares.is_sorted() && shares[0] < 0.05 && shares[3] > 0.5, "{shares:?}");
}

#[test]
fn inside_is_inside() {
    assert!(share(Family::Inside, start_inside) > 0.99);
    let leaves_first = share(Family::Inside, |c| {
        crossings(&c.outline.shape(), &c.ray()).first().is_some_and(|hit| !hit.enters)
    });
    assert!(leaves_first > 0.8, "{leaves_first}");
}

#[test]
fn far_is_far() {
    covers(Family::Far, [15.0, 29_000.0], sizes_away);
    let list: Vec<Outline> = outlines();
    let farthest = cases(&list[0], Family::Far, SEED, RAYS).map(|case| sizes_away(&case));
    assert!(farthest.filter(|&sizes| sizes > 10_000.0).count() > 30);
}

#[test]
fn through_the_axis_to_the_last_bit() {
    let exactly = share(Family::ThroughAxis, |case| {
        let ([x, y, _], [a, b, _]) = (case.cast.origin, case.cast.direction);
        let t = -x / a;
        x + t * a == 0.0 && y + t * b == 0.0
    });
    assert_eq!(exactly, 1.0);
    assert!(share(Family::ThroughAxis, |case| case.cast.direction[2] == 0.0) > 0.2);
}

/// On the surface to within rounding, on both sides of it, with the own crossing cut off by t_min, mostly.
#[test]
fn from_the_surface_starts_there() {
    let touching = share(Family::FromSurface, |case| {
        let start = oracle::Ray { t_min: 0.0, ..case.ray() };
        let height = f64::from(case.cast.origin[2]).abs() * ROUNDOFF;
        !robust(&case.outline.shape(), &start, case.eps(PROMISE) + height)
    });
    assert!(touching > 0.98, "{touching}");
    let within = share(Family::FromSurface, start_inside);
    assert!((0.1..0.9).contains(&within), "{within}");
    let part = |case: &Case| f64::from(case.cast.t_min) / case.outline.size();
    covers(Family::FromSurface, [1.1e-4, 0.9e-2], part);
}

/// The outlines are what their names say.
#[test]
fn outlines_are_what_they_say() {
    let all = outlines();
    for outline in &all {
        assert!(outline.knots.is_sorted_by(|a, b| a < b), "{outline:?}");
        assert_eq!(outline.ordinates.len(), 3 * outline.knots.len() - 2, "{outline:?}");
        assert!(outline.ordinates.iter().all(|&b| b >= 0.0), "{outline:?}");
        assert_eq!(all.iter().filter(|other| other.name == outline.name).count(), 1, "{outline:?}");
    }
    for name in ["cylinder", "pipe", "cone", "sphere", "paraboloid", "hyperboloid", "pawn"] {
        for piece in outline(name).ordinates.windows(4).step_by(3) {
            assert_eq!(piece[3] - piece[0] - 3.0 * (piece[2] - piece[1]), 0.0, "{name}");
        }
    }
    let inner = |name: &str| {
        let shape = outline(name).shape();
        (1..shape.segments()).filter(|&knot| shape.creased(knot)).count()
    };
    let creases = ["lantern", "pawn", "vase", "bottle"].map(inner);
    assert_eq!(creases, [3, 2, 0, 0]);
    assert!((8..=11).contains(&inner("wander")));
    // A rounded pole is no crease, a conical one is.
    let top = |name: &str| {
        let shape = outline(name).shape();
        shape.creased(shape.segments())
    };
    assert!(!top("sphere") && !top("dome") && !top("pawn") && top("cone") && top("horn") && top("cylinder"));
    assert!([0.0, 1e-3, 0.3, 0.5, 1.0].iter().all(|&k| all.iter().any(|outline| outline.k == k)));
    let wander = outline("wander").shape();
    let heights: Vec<f64> = wander.knots.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (low, high) = heights.iter().fold((f64::MAX, 0.0_f64), |(low, high), &h| (low.min(h), high.max(h)));
    assert!(heights.len() == 16 && high > 15.0 * low, "{heights:?}");
    let ends = |base, top| all.iter().any(|outline| outline.base_closed == base && outline.top_closed == top);
    assert!(ends(true, true) && ends(true, false) && ends(false, true) && ends(false, false));
}
