use super::{Piece, Solver};
use crate::cubic::Cubic;
use crate::math::{Math, Native};
use core::marker::PhantomData;

/// Split at the turning points, then a bent parabola. The crate's default.
///
/// At a distance d from the turning point, `|g| = height − bend·d² + c3·d³`. Without the last term the root
/// is at `e = √(height/bend)`; with it at `e·Φ(b)`, `Φ²·(1 − b·Φ) = 1`, `b = c3·e/bend`. Towards the other
/// turning point b runs up to `√6/9` (at the point of inflection, where the other takes over), away from it
/// down without bound. A polynomial of four terms gives Φ within 1.1 % over [−1, √6/9]; below, the cubic term
/// rules and the seed comes from the point of inflection.
///
/// Sound for every finite cubic; see the [module](super) for the bound.
///
/// ```
/// use embedded_lathe::{Cubic, math::Micromath, solve::Split};
///
/// let g = Cubic::new([-0.25, 0.0, 1.0, 0.0]); // u² − 1/4
/// let root = g.first_root_by::<Split<Micromath>>(0.0, 1.0).unwrap();
/// assert!((root - 0.5).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Split<M = Native>(PhantomData<M>);

impl<M: Math> Solver for Split<M> {
    type Math = M;

    #[inline(always)]
    fn seed(g: &Cubic, piece: &Piece) -> f32 {
        let Piece { maximum, minimum, bend, .. } = *piece;
        let rises = maximum.height < minimum.height;
        let height = if rises { maximum.height } else { minimum.height };
        let e = M::sqrt(height / bend);
        let b = g.c[3] * e / bend;
        // Nor if there is no turning point: then b is not a number.
        if b >= -1.0 {
            let d = e * phi(b);
            if rises { maximum.at + d } else { minimum.at - d }
        } else {
            from_inflection(*g)
        }
    }
}

/// Φ on [−1, √6/9], `1 + b·(p1 + b·(p2 + b·p3))`, least largest relative error 1.05 %. One at b = 0: a
/// quadratic's root needs no more.
fn phi(b: f32) -> f32 {
    1.0 + b * (0.570_35 + b * (0.669_61 + b * 0.352_28))
}

/// A seed where the cubic term rules. About the point of inflection i, with v = u − i:
/// `c3·v³ + m·v + g(i) = 0`. With `z = ∛(−g(i)/c3)` and `μ = m/(3·c3)`, `z − μ/z` is close while z² is the
/// larger (it is what remains of Cardano's two cube roots), and `−g(i)/m` where μ is.
///
/// Apart, since it is rare: in line, its five divisions are reckoned whether they are wanted or not.
#[cold]
#[inline(never)]
fn from_inflection(g: Cubic) -> f32 {
    let [_, c1, c2, c3] = g.c;
    let i = -c2 / (3.0 * c3);
    let m = c1 + c2 * i;
    let ratio = -g.at(i) / c3;
    let mu = m / (3.0 * c3);
    let z = cbrt(ratio);
    if z * z > 1.8 * mu { i + (z - mu / z) } else { i + ratio / (3.0 * mu) }
}

/// The cube root within 4 %: a third of the exponent, read as an integer.
fn cbrt(x: f32) -> f32 {
    const SIGN: u32 = 0x8000_0000;
    let bits = x.to_bits();
    f32::from_bits((bits & SIGN) | ((bits & !SIGN) / 3 + 0x2a51_4067))
}
