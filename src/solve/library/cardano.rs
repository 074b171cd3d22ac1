use super::refine::refine;
use crate::cubic::Cubic;
use crate::math::{Math, Native};
use crate::solve::{Fall, Piece, Solver};
use core::marker::PhantomData;

/// Cardano's formula, and [`refine`](fn@refine) from the root that it gives. A tag, of which no value exists.
///
/// With `X = 3·c3·u + c2`, the cubic becomes `X³ − 3·D·X + N = 0`, `D = c2² − 3·c3·c1`,
/// `N = 2·c2³ − 9·c3·c2·c1 + 27·c3²·c0`:
///
/// - if there is one real root, it is `X = y + D/y` with `y³ = −(N ± √(N² − 4·D³))/2`, where ± is the sign of
///   N, so that the sum does not cancel;
/// - if there are three, each is `X = 2·√D·cos(θ)` for an angle θ with `cos(3θ) = −N/(2·√D³)`, and the angle
///   is taken whose root lies in the piece.
///
/// (Cardano 1545, Viète 1591.) The root is `u = (X − c2)/(3·c3)`, a difference that cancels as c3 → 0. If
/// that u lies outside the piece, the root of `c0 + c1·u + c2·u²` is taken, by the form that does not cancel.
/// The formula also loses accuracy beside a double root. Over a backend whose functions are inaccurate it is
/// inaccurate everywhere. In all of these cases [`refine`](fn@refine) restores full accuracy.
///
/// Sound for every finite cubic over every backend; see the [module](crate::solve) for the bound.
///
/// ```
/// use embedded_lathe::{Cubic, math::Libm, solve::Cardano};
///
/// let roots = Cubic::new([0.0, -1.0, 0.0, 1.0]).roots_by::<Cardano<Libm>>(-2.0, 2.0);
/// assert_eq!(roots, [-1.0, 0.0, 1.0]);
/// ```
#[derive(Debug)]
pub struct Cardano<M = Native>(PhantomData<M>);

impl<M: Math> Solver for Cardano<M> {
    type Math = M;

    fn root(g: &Cubic, piece: &Piece) -> f32 {
        let u = cubic::<M>(g, piece);
        refine(g, piece, if piece.lo < u && u < piece.hi { u } else { quadratic::<M>(g, piece) })
    }
}

/// The root of `g` by Cardano's formula. It may lie outside the piece, and it is infinite or NaN if c3 is
/// zero.
fn cubic<M: Math>(g: &Cubic, piece: &Piece) -> f32 {
    let [c0, c1, c2, c3] = g.c;
    let d = c2 * c2 - 3.0 * c3 * c1;
    let n = c2 * (2.0 * c2 * c2 - 9.0 * c3 * c1) + 27.0 * c3 * c3 * c0;
    let x = if 4.0 * d * d * d > n * n {
        let root_d = M::sqrt(d);
        let theta = M::acos((-n / (2.0 * root_d * d)).clamp(-1.0, 1.0)) / 3.0;
        2.0 * root_d * M::cos(theta + third(piece, c3))
    } else {
        let square = n * n - 4.0 * d * d * d;
        let root = M::sqrt(if square > 0.0 { square } else { 0.0 });
        let y = M::cbrt(-0.5 * if n < 0.0 { n - root } else { n + root });
        y + d / y
    };
    (x - c2) / (3.0 * c3)
}

/// The angle to be added to θ, which is in [0, 60°], so that the root in the piece results: −120°, 0 or 120°.
///
/// Of the three roots X, 2·√D·cos(θ) is the largest, 2·√D·cos(θ + 120°) the smallest, and
/// 2·√D·cos(θ − 120°) the middle one. If c3 > 0, u rises with X, and the cubic falls from its maximum to its
/// minimum: the piece holds the middle root. If c3 < 0, u falls as X rises. Then the piece holds the smallest
/// root u, which is that of the largest X, if the cubic falls to its minimum, and the largest u if it falls
/// from its maximum.
fn third(piece: &Piece, c3: f32) -> f32 {
    const THIRD: f32 = 2.0 * core::f32::consts::FRAC_PI_3;
    match piece.fall {
        _ if c3 > 0.0 => -THIRD,
        Fall::ToMinimum => 0.0,
        _ => THIRD,
    }
}

/// The root of `c0 + c1·u + c2·u²` that lies in the piece. If neither does, the result is one of the two, or
/// NaN.
fn quadratic<M: Math>(g: &Cubic, piece: &Piece) -> f32 {
    let [c0, c1, c2, _] = g.c;
    let square = c1 * c1 - 4.0 * c2 * c0;
    let root = M::sqrt(if square > 0.0 { square } else { 0.0 });
    let sum = -0.5 * if c1 < 0.0 { c1 - root } else { c1 + root };
    let (one, other) = (c0 / sum, sum / c2);
    if piece.lo <= one && one <= piece.hi { one } else { other }
}
