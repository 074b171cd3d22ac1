//! Arithmetic without rounding: every finite float is a dyadic number, and sums and products of those are dyadic again.

use dashu_base::Abs;
use dashu_float::{FBig, round::mode::HalfEven};

/// A dyadic number. Precision 0 is dashu's word for "as many bits as it takes".
pub type Exact = FBig<HalfEven, 2>;

/// Bits kept where a quotient or a root must end somewhere: its relative error moves no sign that f64 could tell from zero.
const BITS: usize = 256;

pub fn exact(x: impl Into<f64>) -> Exact {
    let x = Exact::try_from(x.into()).expect("finite");
    x.with_precision(0).value()
}

pub fn float(x: &Exact) -> f64 {
    x.to_f64().value()
}

/// −1, 0, 1.
pub fn sign(x: &Exact) -> i32 {
    match x.cmp(&Exact::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

pub fn quotient(a: &Exact, b: &Exact) -> Exact {
    let [a, b] = [a, b].map(|x| x.clone().with_precision(BITS).value());
    (a / b).with_precision(0).value()
}

fn root(x: &Exact) -> Exact {
    let x = x.clone().with_precision(2 * BITS).value();
    x.sqrt().with_precision(0).value()
}

/// The nearest number with a precision of `bits` bits.
pub fn shortened(x: Exact, bits: usize) -> Exact {
    x.with_precision(bits).value().with_precision(0).value()
}

/// A polynomial, constant term first.
#[derive(Clone, Debug)]
pub struct Polynomial(pub Vec<Exact>);

impl Polynomial {
    pub fn new(c: &[f32]) -> Self {
        Self(c.iter().map(|&c| exact(c)).collect())
    }

    pub fn at(&self, u: &Exact) -> Exact {
        let Some((last, others)) = self.0.split_last() else { return exact(0.0) };
        others.iter().rev().fold(last.clone(), |sum, c| sum * u + c)
    }

    /// `Σ |cⱼ·uʲ|`.
    pub fn size(&self, u: &Exact) -> Exact {
        let absolute = Self(self.0.iter().map(|c| c.clone().abs()).collect());
        absolute.at(&u.clone().abs())
    }

    pub fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self(terms.map(|(j, c)| c * exact(j as f64)).collect())
    }

    /// Where the derivative changes sign strictly between lo and hi, to 2⁻⁶⁰ relative or better; the value there is then off by 2⁻¹²⁰.
    pub fn turns(&self, lo: &Exact, hi: &Exact) -> Vec<Exact> {
        let slope = self.derivative();
        let mut turns = match slope.0.as_slice() {
            [c, b, a] => quadratic(a, b, c),
            [c, b] => quadratic(&exact(0.0), b, c),
            [_] | [] => Vec::new(),
            _ => slope.roots(lo, hi),
        };
        turns.retain(|turn| lo < turn && turn < hi);
        turns
    }

    /// The roots in [lo, hi] at which the sign changes, and lo or hi where one of them is a root: certified by exact signs on both sides,
    /// and off by less than 2⁻⁶⁰ relative.
    pub fn roots(&self, lo: &Exact, hi: &Exact) -> Vec<Exact> {
        self.roots_between(&self.cuts(lo, hi))
    }

    /// lo, the turns between lo and hi, and hi: between two neighbours the polynomial is monotone.
    pub fn cuts(&self, lo: &Exact, hi: &Exact) -> Vec<Exact> {
        let mut cuts = vec![lo.clone()];
        cuts.extend(self.turns(lo, hi));
        cuts.push(hi.clone());
        cuts
    }

    /// The [`roots`](Self::roots) between the first and the last of these cuts.
    pub fn roots_between(&self, cuts: &[Exact]) -> Vec<Exact> {
        let signs: Vec<i32> = cuts.iter().map(|cut| sign(&self.at(cut))).collect();
        let mut roots = Vec::new();
        for (ends, signs) in cuts.windows(2).zip(signs.windows(2)) {
            match signs {
                [0, _] => roots.push(ends[0].clone()),
                [s, t] if s * t < 0 => roots.push(self.bisect(&ends[0], &ends[1])),
                _ => {}
            }
        }
        if let (Some(0), Some(hi)) = (signs.last(), cuts.last()) {
            roots.push(hi.clone());
        }
        roots
    }

    fn bisect(&self, lo: &Exact, hi: &Exact) -> Exact {
        let (mut lo, mut hi) = (lo.clone(), hi.clone());
        let left = sign(&self.at(&lo));
        let half = exact(0.5);
        for _ in 0..300 {
            let width = &hi - &lo;
            let middle = shortened((&lo + &hi) * &half, 96);
            if width <= middle.clone().abs() * exact((-60f64).exp2()) || middle <= lo || middle >= hi {
                break;
            }
            if sign(&self.at(&middle)) == left {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        shortened((&lo + &hi) * &half, 96)
    }
}

/// The simple real roots of `a·x² + b·x + c`, ascending, each by the form that does not cancel.
fn quadratic(a: &Exact, b: &Exact, c: &Exact) -> Vec<Exact> {
    if sign(a) == 0 {
        return if sign(b) == 0 { Vec::new() } else { vec![-quotient(c, b)] };
    }
    let discriminant = b * b - exact(4.0) * a * c;
    if sign(&discriminant) <= 0 {
        return Vec::new();
    }
    let root = root(&discriminant);
    let twice = if sign(b) < 0 { root - b } else { -(root + b) };
    let mut roots = vec![quotient(&(exact(2.0) * c), &twice), quotient(&twice, &(exact(2.0) * a))];
    roots.sort();
    roots
}
