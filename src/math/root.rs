//! A square root for machines without one, in little code and without a table.

/// Returns √x, correctly rounded, and so with the bits of the hardware's root; NaN for x < 0 and for NaN.
///
/// Newton's method finds one over the root, to 13 bits, and by that the root in two steps, to 16 bits and to
/// 24. What that leaves to the exact square decides whether the next number is nearer. All products have 32
/// bits: wider ones are slow on an ARMv6-M.
#[inline(never)]
// Where the machine has a root, only the test uses this one.
#[allow(dead_code)]
pub(super) fn root(x: f32) -> f32 {
    const ONE: u32 = 1 << 23;
    let bits = x.to_bits();
    // Zeros, +∞, NaN and all negative numbers.
    if bits.wrapping_sub(1) >= f32::INFINITY.to_bits() - 1 {
        return if bits > (-0.0_f32).to_bits() { f32::NAN } else { x };
    }
    // x is rest·2^(exponent − 150), in which a subnormal number has the exponent 1.
    let (mut exponent, mut rest) = ((bits >> 23) as i32, bits);
    if exponent > 0 {
        rest = (bits & (ONE - 1)) | ONE;
    } else {
        while rest < ONE {
            rest <<= 1;
            exponent -= 1;
        }
        exponent += 1;
    }
    // x divided by an even power of two, so that it is from 1/4 to less than 1, in units of 2⁻³².
    let x = rest << (7 + ((exponent + 1) & 1));
    let high = x >> 16;
    // 1/√x, in units of 2⁻¹⁴: from 2.17 − 1.25·x, which is within 9.3 %, by three Newton steps
    // y ← y·(3 − x·y²)/2.
    let mut y = 35_553 - (high >> 2) - (high >> 4);
    for _ in 0..3 {
        y = (y * ((3 << 14) - ((high * ((y * y) >> 13)) >> 17))) >> 15;
    }
    // √x in units of 2⁻¹⁶, and in units of 2⁻²⁴: nowhere more than the nearest, and at most one less, as the
    // test finds for all x.
    let root = (high * y) >> 14;
    let rest = x.wrapping_sub(root * root) as i32;
    let root = (root << 8) as i32 + (((rest >> 6) * y as i32) >> 17);
    // One more is nearer if x is more than (root + ½)².
    let rest = (x << 16).wrapping_sub(root.wrapping_mul(root) as u32) as i32;
    let root = root + i32::from(rest > root);
    // The root's first bit adds 1 to the exponent, in which 127 is that of 1.
    let exponent = ((exponent - 127) >> 1) + 126;
    f32::from_bits(((exponent as u32) << 23) + root as u32)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::root;

    #[test]
    fn is_that_of_the_hardware() {
        let check = |bits: u32| {
            let x = f32::from_bits(bits);
            let (a, b) = (root(x), f32::sqrt(x));
            assert!(a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(), "{x:e}: {a:e}, {b:e}");
        };
        // All exponents, both signs; and all numbers of two octaves, which is all that differs.
        (0..u32::MAX).step_by(997).for_each(check);
        (1_f32.to_bits()..4_f32.to_bits()).for_each(check);
        for x in [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::from_bits(1)] {
            check(x.to_bits());
        }
    }
}
