use super::refine;
use crate::cubic::Cubic;
use crate::math::{Math, Native};
use crate::solve::{Fall, Piece, Solver};
use core::marker::PhantomData;

/// Cardano's formula, held in its monotone piece and refined.
///
/// With `X = 3·c3·u + c2`, the cubic becomes `X³ − 3·D·X + N = 0`, `D = c2² − 3·c3·c1`,
/// `N = 2·c2³ − 9·c3·c2·c1 + 27·c3²·c0`:
///
/// - no turning point, or the root beyond the outer ones where only it is real: one cube root, `X = z + D/z`,
///   `z³ = −(N ± √(N² − 4·D³))/2`, the sign that adds;
/// - three real roots: `X = 2·√D·cos(θ)`, `cos(3θ) = −N/(2·√D³)`, θ by the piece.
///
/// (Cardano 1545, Viète 1591.) Going back divides by c3, and `X − c2` cancels as c3 → 0: where that throws
/// the seed out of the piece it is the quadratic's, `c0 + c1·u + c2·u²`, in the form that does not cancel.
/// What else the formula loses beside a double root, and what rough functions lose anywhere, the refinement
/// restores.
///
/// Sound for every finite cubic over every backend; see the [module](crate::solve) for the bound.
///
/// ```
/// use embedded_lathe::{Cubic, math::Libm, solve::Cardano};
///
/// let roots = Cubic::new([0.0, -1.0, 0.0, 1.0]).roots_by::<Cardano<Libm>>(-2.0, 2.0);
/// assert_eq!(roots, [-1.0, 0.0, 1.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cardano<M = Native>(PhantomData<M>);

impl<M: Math> Solver for Cardano<M> {
    type Math = M;

    fn root(g: &Cubic, piece: &Piece) -> f32 {
        let u = cubic::<M>(g, piece);
        refine(g, piece, if piece.lo < u && u < piece.hi { u } else { quadratic::<M>(g, piece) })
    }
}

fn cubic<M: Math>(g: &Cubic, piece: &Piece) -> f32 {
    let [c0, c1, c2, c3] = g.c;
    let d = c2 * c2 - 3.0 * c3 * c1;
    let n = c2 * (2.0 * c2 * c2 - 9.0 * c3 * c1) + 27.0 * c3 * c3 * c0;
    let x = if 4.0 * d * d * d > n * n {
        let root_d = M::sqrt(d);
        let theta = M::acos((-n / (2.0 * root_d * d)).clamp(-1.0, 1.0)) / 3.0;
        2.0 * root_d * M::cos(theta + turn(piece, c3))
    } else {
        let square = n * n - 4.0 * d * d * d;
        let root = M::sqrt(if square > 0.0 { square } else { 0.0 });
        let z = M::cbrt(-0.5 * if n < 0.0 { n - root } else { n + root });
        z + d / z
    };
    (x - c2) / (3.0 * c3)
}

/// Which of the three angles belongs to the piece. X falls with θ; u rises with X if c3 > 0. A cubic that
/// falls between its turning points has c3 > 0.
fn turn(piece: &Piece, c3: f32) -> f32 {
    const THIRD: f32 = 2.094_395_2;
    match piece.fall {
        _ if c3 > 0.0 => -THIRD, // cos(θ − 120°), θ in [0, 60°]: the middle root
        Fall::ToMinimum => 0.0,
        _ => THIRD,
    }
}

/// The root of `c0 + c1·u + c2·u²` in the piece: beside the turning point, on the piece's side of it.
fn quadratic<M: Math>(g: &Cubic, piece: &Piece) -> f32 {
    let [c0, c1, c2, _] = g.c;
    let square = c1 * c1 - 4.0 * c2 * c0;
    let root = M::sqrt(if square > 0.0 { square } else { 0.0 });
    let sum = -0.5 * if c1 < 0.0 { c1 - root } else { c1 + root };
    let (one, other) = (c0 / sum, sum / c2);
    if piece.lo <= one && one <= piece.hi { one } else { other }
}
