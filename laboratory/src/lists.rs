//! How wrong a list of roots is: not each root by itself, but that these are the roots, and all of them.
//!
//! "The roots in [lo, hi] are these" is made true by a change of the coefficients if, for the cubic so
//! changed, every root listed is one, and between them its signs alternate. The change is measured as in
//! [`judge`](crate::judge), in units of 2⁻²⁴ of each coefficient. Four figures come of it:
//!
//! - `alone`: what makes each root by itself a root, and each stretch between two by itself of its sign. A
//!   lower bound.
//! - `double`: what makes two equal ones a double root, to the exact least.
//! - `joint`: what makes all of them the roots of one cubic, to the exact least. Not to be asked for: where
//!   c2 = 0 no three floats whose sum is not zero are, though they be the nearest to the roots. But what
//!   keeps it keeps all.
//! - [`is_certain`]: whether a cubic is known that differs by no more than a given number of units and has the
//!   listed number of roots in [lo, hi].
//!
//! The least relative change δ of all coefficients cⱼ that meets linear conditions `Σⱼ aᵢⱼ·c̃ⱼ = 0` is by
//! duality the largest `|Σᵢ λᵢ·gᵢ| / Σⱼ |cⱼ|·|Σᵢ λᵢ·aᵢⱼ|` over all λ, gᵢ what the given cⱼ leave of a
//! condition. For one condition that is |g|/size. For two it is largest where a term of the denominator
//! vanishes, between which it is a ratio of linear functions. Three roots leave a cubic but one factor to
//! choose.

use crate::UNITS;
use crate::exact::{Exact, Polynomial, exact, float, quotient, sign};
use dashu_base::Abs;

/// What a list of roots is off by.
#[derive(Clone, Copy, Debug)]
pub struct ListVerdict {
    pub alone: f64,
    pub double: f64,
    pub joint: f64,
}

/// Judges a list of roots of the cubic `Σ c[j]·uʲ` in [lo, hi].
pub fn judge_list(g: &Polynomial, [lo, hi]: [&Exact; 2], roots: &[Exact]) -> ListVerdict {
    let inside = roots.iter().all(|root| lo <= root && root <= hi);
    if !(inside && roots.is_sorted()) {
        return ListVerdict { alone: f64::INFINITY, double: f64::INFINITY, joint: f64::INFINITY };
    }
    let residual = roots.iter().map(|root| ratio(&g.at(root), &g.size(root))).fold(0.0, f64::max);
    let mut places = vec![lo.clone(), hi.clone()];
    places.extend(g.turns(lo, hi));
    // By how much the signs between the roots are wrong if they begin with plus, and if with minus.
    let wrong = [1, -1].map(|start| {
        let places = places.iter().filter(|place| !roots.contains(place));
        let off = places.map(|place| {
            let before = roots.iter().filter(|root| *root < place).count();
            let wanted = if before % 2 == 0 { start } else { -start };
            let value = g.at(place);
            if sign(&value) * wanted < 0 { ratio(&value, &g.size(place)) } else { 0.0 }
        });
        off.fold(0.0, f64::max)
    });
    let joint = match roots {
        [] | [_] => residual,
        [p, q] => pair(g, p, q),
        [p, q, r] => triple(g, [p, q, r]),
        _ => f64::INFINITY,
    };
    let equal = roots.windows(2).filter(|pair| pair[0] == pair[1]);
    let double = equal.map(|equal| pair(g, &equal[0], &equal[1])).fold(0.0, f64::max);
    let alone = residual.max(wrong[0].min(wrong[1]));
    ListVerdict { alone: UNITS * alone, double: UNITS * double, joint: UNITS * joint }
}

fn ratio(value: &Exact, size: &Exact) -> f64 {
    if sign(size) > 0 { float(&quotient(&value.clone().abs(), size)) } else { 0.0 }
}

/// Powers 1, u, u², u³.
fn powers(u: &Exact) -> [Exact; 4] {
    let one = exact(1.0);
    let square = u * u;
    [one, u.clone(), square.clone(), &square * u]
}

/// What makes p and q roots of one cubic.
fn pair(g: &Polynomial, p: &Exact, q: &Exact) -> f64 {
    let first = powers(p);
    // The second condition is the divided difference, which for p = q is the derivative.
    let second: [Exact; 4] = [exact(0.0), exact(1.0), p + q, p * p + p * q + q * q];
    let left = |condition: &[Exact; 4]| g.0.iter().zip(condition).fold(exact(0.0), |sum, (c, a)| sum + c * a);
    let [one, other] = [left(&first), left(&second)];
    let least = |[l, m]: [&Exact; 2]| {
        let value = l * &one + m * &other;
        let terms = g.0.iter().zip(first.iter().zip(&second));
        let size = terms.fold(exact(0.0), |sum, (c, (a, b))| sum + (c * (l * a + m * b)).abs());
        match (sign(&value), sign(&size)) {
            (0, _) => 0.0,
            (_, 0) => f64::INFINITY,
            _ => float(&quotient(&value.abs(), &size)),
        }
    };
    let vanishing = first.iter().zip(&second).map(|(a, b)| least([b, &-a]));
    vanishing.chain([least([&exact(1.0), &exact(0.0)])]).fold(0.0, f64::max)
}

/// What makes p, q and r the roots of one cubic, `t·(u − p)·(u − q)·(u − r)`: the best t.
fn triple(g: &Polynomial, [p, q, r]: [&Exact; 3]) -> f64 {
    let product = [-(p * q * r), p * q + q * r + r * p, -(p + q + r), exact(1.0)];
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for (c, product) in g.0.iter().zip(&product) {
        if sign(c) == 0 {
            if sign(product) != 0 {
                return f64::INFINITY;
            }
            continue;
        }
        // In units of the leading one's, so that f64 has them: to its own rounding, 2⁻²⁹ of a unit.
        let share = float(&quotient(&(product * &g.0[3]), c));
        (least, most) = (least.min(share), most.max(share));
    }
    if least <= 0.0 { 1.0 } else { (most - least) / (most + least) }
}

/// Whether a cubic is known whose coefficients differ by `units` at most, and that has `count` roots in
/// [lo, hi].
///
/// Looked at are those whose c1, c2 and c3 differ by multiples of a quarter of `units`, each with every
/// constant term that makes a difference: between two values for which an end of the interval or a critical
/// point is a root.
pub fn is_certain(g: &Polynomial, [lo, hi]: [&Exact; 2], count: usize, units: f64) -> bool {
    const STEPS: i32 = 9;
    let mut numbers: Vec<i32> = (0..STEPS.pow(3)).collect();
    // From the given one outwards.
    numbers
        .sort_by_key(|number| (0..3).map(|j| (number / STEPS.pow(j) % STEPS - STEPS / 2).abs()).sum::<i32>());
    numbers.into_iter().any(|number| {
        let change = |j: u32| match j {
            0 => exact(0.0),
            _ => exact(f64::from(number / STEPS.pow(j - 1) % STEPS - STEPS / 2) * 0.25 * units / UNITS),
        };
        let near = Polynomial((0..).zip(&g.0).map(|(j, c)| c * (exact(1.0) + change(j))).collect());
        let cuts = near.cuts(lo, hi);
        levels(&near, &cuts, units).any(|level| count_roots(&level, &cuts) == count)
    })
}

/// The cubic with constant terms that differ by `units` at most: one for each number of roots that they can
/// bring. All have the same cuts.
fn levels(g: &Polynomial, cuts: &[Exact], units: f64) -> impl Iterator<Item = Polynomial> {
    let most = g.0[0].clone().abs() * exact(units / UNITS);
    let least = -&most;
    let mut lifts = vec![least.clone(), most.clone()];
    lifts.extend(cuts.iter().map(|place| -g.at(place)));
    lifts.retain(|lift| &least <= lift && lift <= &most);
    lifts.sort();
    let half = exact(0.5);
    let between: Vec<Exact> = lifts.windows(2).map(|pair| (&pair[0] + &pair[1]) * &half).collect();
    [exact(0.0)].into_iter().chain(between).chain(lifts).map(|lift| {
        let mut lifted = g.clone();
        lifted.0[0] = &g.0[0] + lift;
        lifted
    })
}

/// The number of roots at which the sign changes between the first and the last cut, and at these two.
fn count_roots(g: &Polynomial, cuts: &[Exact]) -> usize {
    let signs: Vec<i32> = cuts.iter().map(|cut| sign(&g.at(cut))).collect();
    let ends = [signs.first(), signs.last()].iter().filter(|sign| **sign == Some(&0)).count();
    ends + signs.windows(2).filter(|pair| pair[0] * pair[1] < 0).count()
}
