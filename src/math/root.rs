//! A square root for machines without one, in little code.

/// Returns √x, correctly rounded, and so with the bits of the hardware's root; NaN for x < 0 and for NaN.
///
/// The root's 25 bits are found one by one. The last one decides the rounding: no root is half way between
/// two numbers of 24 bits, for its square would have 49 bits or 50.
#[inline(never)]
// Where the machine has a root, only the test uses this one.
#[allow(dead_code)]
pub(super) fn root(x: f32) -> f32 {
    const ONE: u32 = 1 << 23;
    let bits = x.to_bits();
    // Zero, infinity and NaN; of negative numbers all.
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
    // Then from 1 to 4, in units of 2⁻²⁴, and its power of two is even. The root's first bit is set.
    rest = (rest << (1 + ((exponent + 1) & 1))) - 2 * ONE;
    let (mut twice, mut bit) = (4 * ONE, ONE);
    loop {
        rest <<= 1;
        // (root + bit)² − root² is bit·(2·root + bit).
        let more = twice + bit;
        if more <= rest {
            rest -= more;
            twice = more + bit;
        }
        bit >>= 1;
        if bit == 0 {
            break;
        }
    }
    // Rounded to the nearest. The root's first bit adds 1 to the exponent, in which 127 is that of 1.
    let exponent = ((exponent - 127) >> 1) + 126;
    f32::from_bits(((exponent as u32) << 23) + ((twice + 2) >> 2))
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
        // All exponents, both signs; and all numbers of two octaves.
        (0..u32::MAX).step_by(997).for_each(check);
        (1_f32.to_bits()..4_f32.to_bits()).step_by(3).for_each(check);
        for x in [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::from_bits(1)] {
            check(x.to_bits());
        }
    }
}
