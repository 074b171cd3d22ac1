//! The larger and the smaller of two numbers on a machine without an FPU: as in `minmax.rs`, but each is a
//! function of two dozen instructions that compares the numbers' bits. The comparison of floats by software
//! takes as many, and code at each place where it is called.

const INFINITY: i32 = f32::INFINITY.to_bits() as i32;

/// The larger of two numbers, and `a` if either is NaN.
#[inline(never)]
pub(crate) const fn greater(a: f32, b: f32) -> f32 {
    if is_less(a, b) { b } else { a }
}

/// The smaller of two numbers, and `a` if either is NaN.
#[inline(never)]
pub(crate) const fn lesser(a: f32, b: f32) -> f32 {
    if is_less(b, a) { b } else { a }
}

/// Whether a < b.
#[inline(always)]
const fn is_less(a: f32, b: f32) -> bool {
    let (a, b) = (ordered(a), ordered(b));
    // Of numbers, none is beyond the infinities.
    a < b && a >= -INFINITY && b <= INFINITY
}

/// An integer for each number, such that the integers of two numbers compare as the numbers do. That of NaN
/// is beyond that of an infinity, on either side.
#[inline(always)]
const fn ordered(x: f32) -> i32 {
    let bits = x.to_bits() as i32;
    // −0 is 0, too.
    if bits < 0 { i32::MIN - bits } else { bits }
}

#[cfg(test)]
mod tests {
    use crate::math::minmax;

    #[test]
    fn compares_as_floats_do() {
        let numbers = [0.0, 1e-45, 1e-38, 0.1, 1.0, 1.000_000_1, 3e38, f32::INFINITY, f32::NAN];
        let numbers = || numbers.into_iter().flat_map(|x| [x, -x]);
        for (a, b) in numbers().flat_map(|a| numbers().map(move |b| (a, b))) {
            assert_eq!(super::greater(a, b).to_bits(), minmax::greater(a, b).to_bits(), "{a} {b}");
            assert_eq!(super::lesser(a, b).to_bits(), minmax::lesser(a, b).to_bits(), "{a} {b}");
        }
    }
}
