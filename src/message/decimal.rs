use super::Text;

/// Writes a number as core does for debugging: the fewest digits that only it is read from, with an exponent
/// from 10¹⁶ on and below 10⁻⁴.
///
/// In f64, which only the compiler computes with. A decimal of p digits is the number's own if it is read
/// back as it: its f64, off by at most 50 roundings or 10⁻¹⁴, is then the f32 itself when rounded, unless the
/// decimal lies as near to the middle between two f32 as that.
pub(super) const fn push(text: &mut Text, x: f32) {
    if x.is_nan() {
        return text.push_all("NaN");
    }
    if x.is_sign_negative() {
        text.push(b'-');
    }
    let x = x.abs();
    if x == f32::INFINITY {
        return text.push_all("inf");
    }
    if x == 0.0 {
        return text.push_all("0.0");
    }
    let (digits, exponent) = shortest(x);
    if x >= 1e16 || x < 1e-4 {
        with_exponent(text, digits, exponent);
    } else {
        without_exponent(text, digits, exponent);
    }
}

/// The number as `d.ddd·10^exponent`, its digits together an integer that does not end in 0.
const fn shortest(x: f32) -> (u64, i32) {
    let mut exponent = -45;
    while times_ten_to(1.0, exponent + 1) <= x as f64 {
        exponent += 1;
    }
    let mut count = 1;
    loop {
        let scaled = times_ten_to(x as f64, count - 1 - exponent);
        let nearest = (scaled + 0.5) as u64;
        // Below a power of two numbers lie closer: the nearest decimal may be another's, and the next one up
        // this one's.
        let next = if nearest as f64 > scaled { nearest - 1 } else { nearest + 1 };
        if is_of(x, nearest, exponent - count + 1) || count == 9 {
            return without_zeros(nearest, count, exponent);
        }
        if is_of(x, next, exponent - count + 1) {
            return without_zeros(next, count, exponent);
        }
        count += 1;
    }
}

/// Whether `digits·10^exponent` is read back as x.
const fn is_of(x: f32, digits: u64, exponent: i32) -> bool {
    times_ten_to(digits as f64, exponent) as f32 == x
}

/// The digits, `count` of them or, rounded up to a power of ten, one more, without the zeros at their end;
/// and the exponent.
const fn without_zeros(mut digits: u64, count: i32, exponent: i32) -> (u64, i32) {
    let exponent = exponent + (digits.ilog10() as i32 + 1 - count);
    while digits.is_multiple_of(10) {
        digits /= 10;
    }
    (digits, exponent)
}

/// `x·10^exponent`.
const fn times_ten_to(x: f64, exponent: i32) -> f64 {
    let (mut power, mut i) = (1.0, 0);
    while i < exponent.unsigned_abs() {
        power *= 10.0;
        i += 1;
    }
    if exponent < 0 { x / power } else { x * power }
}

const fn with_exponent(text: &mut Text, digits: u64, exponent: i32) {
    let (last, mut i) = (digits.ilog10() as i32, 0);
    while i <= last {
        if i == 1 {
            text.push(b'.');
        }
        text.push(digit(digits, i));
        i += 1;
    }
    text.push(b'e');
    if exponent < 0 {
        text.push(b'-');
    }
    text.push_count(exponent.unsigned_abs() as usize);
}

const fn without_exponent(text: &mut Text, digits: u64, exponent: i32) {
    let end = exponent - digits.ilog10() as i32;
    let mut power = if exponent > 0 { exponent } else { 0 };
    while power >= end || power >= -1 {
        if power == -1 {
            text.push(b'.');
        }
        text.push(digit(digits, exponent - power));
        power -= 1;
    }
}

/// The i-th digit from the left, the first being the 0-th, and zero before and after them.
const fn digit(digits: u64, i: i32) -> u8 {
    let last = digits.ilog10() as i32;
    if i < 0 || i > last { b'0' } else { b'0' + (digits / 10_u64.pow((last - i) as u32) % 10) as u8 }
}
