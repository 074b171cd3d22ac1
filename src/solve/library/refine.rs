use crate::cubic::Cubic;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::lesser;
use crate::solve::{Fall, Piece};

/// The most steps of [`refine`]. The slowest cubics have three roots that are nearly one, and towards those a
/// Newton step leaves 2/3 of the distance. The longest interval that is not rescaled has the length 2³¹, and
/// the smallest such roots that do not count as zero are ∛2⁻¹⁰⁶ = 2⁻³⁵. The search ends at two units or
/// less, 2·2⁻²⁴·8 of the cubic term, and so when the distance is 2⁻⁷ of such a root: (2⁻⁷)³ = 2⁻²¹. From 2³¹
/// to 2⁻⁴² it takes 125 steps. There rounding may throw a step to the other side of the roots, from where it
/// takes as many again; after that 24 halvings are enough: 2·125 + 24 = 274. Of the test
/// `sixty_million_cubics` none takes more than 268.
const REFINE_LIMIT: u32 = 274;

/// The root of `g` in a piece, by Newton's method in a bracket, from any seed, NaN too: a bad seed costs
/// time, never accuracy. It is meant for a [`Solver`](crate::solve::Solver) whose closed form is inaccurate,
/// and takes the `g` and the `piece` that the solver was given: `g` is above zero where the piece begins.
/// [`Piece`] has an example.
///
/// Cost: from a fair seed two or three steps, each with a division; 274 at most.
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
/// point. From a bad seed many steps could be cut so, each halving the distance. So a cut step whose number
/// is a multiple of four goes to the bracket's middle.
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
    while steps < REFINE_LIMIT {
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
        } else if steps % 4 == 0 {
            0.5 * lo + 0.5 * hi
        } else if step > 0.0 {
            u - reach
        } else {
            u + reach
        };
        if last && step.abs() <= 0.5 * u.abs() {
            break;
        }
    }
    (u, steps)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{REFINE_LIMIT, search};
    use crate::cubic::Cubic;
    use crate::math::{Micromath, Native};
    use crate::solve::isolate::Crossings;
    use crate::solve::{BACKWARD_ERROR, Cardano, Piece, Solver};
    use core::cell::Cell;
    use rand::rngs::ChaCha8Rng;
    use rand::{Rng, RngExt, SeedableRng};

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
        assert!(140 < steps && steps <= REFINE_LIMIT && 2.0 < units, "{steps} steps, {units} units");
    }

    /// Three roots that are nearly one, and both ends far away: one step goes from one side to the other.
    #[test]
    fn the_slowest_found() {
        SEED.set((0, 0.0));
        let g = Cubic::new([-5.375_375_7e-18, -1.303_252_6e-10, -0.001_053_235_5, -2_837.273]);
        let (steps, units) = worst_of(&g, -1_073_741_800.0, 1_061_958.0);
        assert!(160 < steps && steps <= REFINE_LIMIT && units <= BACKWARD_ERROR.into(), "{steps}, {units}");
    }

    /// The figures of the docs of [`REFINE_LIMIT`] and [`BACKWARD_ERROR`].
    #[test]
    #[ignore = "sixty million cubics take two minutes"]
    fn sixty_million_cubics() {
        let (steps, units) = worst_of_random(60_000_000);
        assert!((250..=268).contains(&steps) && (3.2..=3.4).contains(&units), "{steps} steps, {units} units");
    }
}
