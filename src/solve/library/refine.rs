use crate::cubic::Cubic;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::lesser;
use crate::solve::{Fall, Piece};

/// How many steps [`refine`] takes before it bisects. From a fair seed two or three are enough. From a bad
/// one, towards three roots that are nearly one, a Newton step leaves 2/3 of the distance: it would take 125
/// steps from 2³¹ to 2⁻⁴².
const NEWTON_LIMIT: u32 = 32;

/// The root of `g` in a piece, by Newton's method in a bracket, from any seed, NaN too: a bad seed costs
/// time, never accuracy. It is meant for a [`Solver`](crate::solve::Solver) whose closed form is inaccurate,
/// and takes the `g` and the `piece` that the solver was given: `g` is above zero where the piece begins.
/// [`Piece`] has an example.
///
/// Cost: from a fair seed two or three steps, each with a division; 64 at most.
///
/// The sign of `g` at each u narrows the bracket, and a step that would leave the bracket goes to its middle
/// instead. A Newton step goes from u to `u − d`, `d = g(u)/g′(u)`, where the value of `g` is exactly
/// `d²·(g″(u)/2 − c3·d)`.
///
/// Let a unit be 2⁻²⁴ of the sum of the terms' magnitudes at u, [`Cubic::size`]: a root of which the value is
/// n units is exact for coefficients that differ by n units of 2⁻²⁴, relative. Two values end the search:
///
/// - The computed value at u is below two units. That is half of
///   [`BACKWARD_ERROR`](crate::solve::BACKWARD_ERROR); the other half is left for the rounding of the value.
/// - The value after a step is below an eighth of a unit, and the step at most half of u. Then each term is
///   at least an eighth of what it was, so that the value is below one unit of the new sum.
///
/// Beside a critical point the slope is mostly rounding: no step is longer than half the distance to that
/// point.
///
/// After 32 steps the search goes on with the middle one of all f32 numbers in the bracket, again and again,
/// unless a value ends it. A bracket has fewer than 2³² of them, so that after 32 more steps there is none
/// left, and one end of the bracket is returned.
#[inline(never)]
#[must_use]
pub fn refine(g: &Cubic, piece: &Piece, seed: f32) -> f32 {
    search(g, piece, seed).0
}

/// The root that [`refine`] returns, and how many steps it took.
#[inline(always)]
fn search(g: &Cubic, piece: &Piece, seed: f32) -> (f32, u32) {
    let [c0, _, c2, c3] = g.c;
    // A critical point limits steps only if it bounds the crossing's bracket.
    let top = if piece.fall == Fall::Straight { f32::NEG_INFINITY } else { piece.maximum(g) };
    let (mut lo, mut hi) = (if piece.lo < top && top < piece.hi { top } else { piece.lo }, piece.hi);
    // If c0 is zero, g and its rounding shrink together as u → 0, so that the search might approach a root at
    // 0 for long. So that root, simple or multiple, is returned at once. Where the bracket begins at 0 it is
    // not the root in question, since g is positive there, except if that is the maximum.
    if c0 == 0.0 && (lo < 0.0 || top == 0.0) && lo <= 0.0 && 0.0 <= hi {
        return (0.0, 0);
    }
    let maximum = if top <= lo { top } else { f32::NEG_INFINITY };
    let minimum = if piece.minimum >= hi { piece.minimum } else { f32::INFINITY };
    let mut u = seed;
    let mut steps = 0;
    loop {
        if !(lo < u && u < hi) {
            u = 0.5 * lo + 0.5 * hi;
            if !(lo < u && u < hi) {
                break;
            }
        }
        steps += 1;
        let value = g.at(u);
        let rounding = UNIT_ROUNDOFF * g.size(u);
        let step = value / g.slope(u);
        let reach = 0.5 * lesser(u - maximum, minimum - u);
        let far = step.abs() > reach;
        let rest = step * step * (c2 + 3.0 * c3 * u - c3 * step);
        let last = !far && rest.abs() <= 0.125 * rounding;
        // Not `<=`, which is true where both sides are infinite, as they may be for large u.
        if value.abs() < 2.0 * rounding || value == 0.0 {
            u -= if last { step } else { 0.0 };
            break;
        }
        if value > 0.0 {
            lo = u;
        } else {
            hi = u;
        }
        u = if !far {
            u - step
        } else if step > 0.0 {
            u - reach
        } else {
            u + reach
        };
        if last && step.abs() <= 0.5 * u.abs() {
            break;
        }
        if steps >= NEWTON_LIMIT {
            u = middle_of_all(lo, hi);
        }
    }
    (u, steps)
}

/// The middle one of all f32 numbers from a to b, or of the two in the middle the smaller one.
#[cold]
#[inline(never)]
fn middle_of_all(a: f32, b: f32) -> f32 {
    // The order of the bits of positive numbers is that of the numbers; that of negative ones is the reverse.
    let ordered = |bits: i32| if bits < 0 { bits ^ i32::MAX } else { bits };
    let [a, b] = [a, b].map(|x| i64::from(ordered(x.to_bits() as i32)));
    f32::from_bits(ordered((a + b).div_euclid(2) as i32) as u32)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{NEWTON_LIMIT, search};
    use crate::cubic::Cubic;
    use crate::math::{Micromath, Native};
    use crate::solve::isolate::Crossings;
    use crate::solve::{BACKWARD_ERROR, Cardano, Piece, Solver};
    use core::cell::Cell;
    use rand::rngs::ChaCha8Rng;
    use rand::{Rng, RngExt, SeedableRng};

    /// The most steps: until the search bisects, and then as many as halve 2³² numbers to one.
    const REFINE_LIMIT: u32 = NEWTON_LIMIT + 32;

    std::thread_local! {
        /// Which seed [`Seeded`] takes, from 0 to 8, and as a fraction the point of the piece that is the
        /// last one.
        static SEED: Cell<(u32, f32)> = const { Cell::new((0, 0.0)) };
        /// How many steps it took.
        static STEPS: Cell<u32> = const { Cell::new(0) };
    }

    /// [`super::refine`] from seeds good and bad.
    struct Seeded;

    impl Solver for Seeded {
        type Math = Native;

        fn root(g: &Cubic, piece: &Piece) -> f32 {
            let (lo, hi) = (piece.lo, piece.hi);
            let (kind, share) = SEED.get();
            let seed = match kind {
                0 => f32::NAN,
                1 => lo,
                2 => hi,
                3 => lo.next_up(),
                4 => hi.next_down(),
                5 => piece.maximum(g),
                6 => 0.999 * hi,
                7 => Cardano::<Micromath>::root(g, piece),
                _ => lo + share * (hi - lo),
            };
            let (root, steps) = search(g, piece, seed);
            STEPS.set(steps);
            root
        }
    }

    /// The greatest number of steps of any root of a cubic in [lo, hi], and the greatest value left, in
    /// units.
    fn worst_of(g: &Cubic, lo: f32, hi: f32) -> (u32, f64) {
        let (mut steps, mut units) = (0, 0.0_f64);
        let start = g.at(lo);
        if start == 0.0 {
            return (steps, units);
        }
        let mut crossings = Crossings::new(g, lo, hi, start > 0.0);
        while let Some(u) = crossings.next::<Seeded>() {
            let [c0, c1, c2, c3] = g.c.map(f64::from);
            let (u, largest) = (f64::from(u), g.c.iter().fold(0.0, |most, c| f32::max(most, c.abs())));
            let value = (((c3 * u + c2) * u + c1) * u + c0).abs();
            let size = c0.abs() + ((c3 * u).abs() + c2.abs()) * u * u + (c1 * u).abs();
            if value > f64::from(largest) * (-106_f64).exp2() {
                units = units.max(value / size * 24_f64.exp2());
            }
            steps = steps.max(STEPS.get());
        }
        (steps, units)
    }

    /// A cubic that is solved as it is, with coefficients over up to 120 binary orders: any, or near one with
    /// a double or a triple root.
    fn cubic(rng: &mut impl Rng) -> Cubic {
        let orders = [2.0_f32, 20.0, 60.0, 120.0][rng.random_range(0..4)];
        let any: [f32; 4] =
            core::array::from_fn(|_| rng.random_range(-1.0_f32..1.0) * rng.random_range(-orders..1.0).exp2());
        let [a, b, k, _] = any;
        let mut c = match rng.random_range(0..4) {
            0 => [a * a * b, a * (a * k - 2.0 * b), b - 2.0 * a * k, k],
            1 => [-a * a * a * k, 3.0 * a * a * k, -3.0 * a * k, k],
            _ => any,
        };
        c[rng.random_range(0..4)] *= 1.0 + f32::EPSILON * [0.0, 1.0, -2.0, 4.0][rng.random_range(0..4)];
        let largest = c.iter().fold(1e-37_f32, |most, c| most.max(c.abs()));
        let scale = rng.random_range(-19.0_f32..19.0).exp2();
        Cubic::new(c.map(|c| c / largest * scale))
    }

    /// What [`worst_of`] returns for the worst of `count` random cubics, in intervals of all lengths up to
    /// 2³¹.
    fn worst_of_random(count: u32) -> (u32, f64) {
        let mut rng = ChaCha8Rng::seed_from_u64(160);
        (0..count).fold((0, 0.0), |(most, worst), _| {
            let g = cubic(&mut rng);
            let mut end = || rng.random_range(-60.0_f32..30.0).exp2();
            let (before, beyond) = (-end(), end());
            let lo = [0.0, before, -30_f32.exp2(), before * beyond.min(1.0)][rng.random_range(0..4)];
            SEED.set((rng.random_range(0..9), rng.random_range(0.0..1.0)));
            let (steps, units) = worst_of(&g, lo, beyond);
            assert!(units <= BACKWARD_ERROR.into(), "{g:?} in [{lo}, {beyond}], {:?}: {units}", SEED.get());
            (most.max(steps), worst.max(units))
        })
    }

    #[test]
    fn any_seed_will_do() {
        let (steps, units) = worst_of_random(300_000);
        assert!(48 < steps && steps <= REFINE_LIMIT && 2.0 < units, "{steps} steps, {units} units");
    }

    /// Three roots that are nearly one, and both ends far away: without bisection it takes over 160 steps.
    #[test]
    fn the_slowest_found() {
        SEED.set((0, 0.0));
        let g = Cubic::new([-5.375_375_7e-18, -1.303_252_6e-10, -0.001_053_235_5, -2_837.273]);
        let (steps, units) = worst_of(&g, -1_073_741_800.0, 1_061_958.0);
        assert!(48 <= steps && steps <= REFINE_LIMIT && units <= BACKWARD_ERROR.into(), "{steps}, {units}");
    }

    /// The figure of the doc of [`BACKWARD_ERROR`].
    #[test]
    #[ignore = "sixty million cubics take two minutes"]
    fn sixty_million_cubics() {
        let (steps, units) = worst_of_random(60_000_000);
        assert!(steps <= REFINE_LIMIT && (3.1..=3.2).contains(&units), "{steps} steps, {units} units");
    }
}
