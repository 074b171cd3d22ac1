use super::Text;

/// Appends x as `{x:?}` prints it: the fewest decimal digits from which x is parsed, with an exponent if |x|
/// is 10¹⁶ or more or below 10⁻⁴; `NaN`; `inf` or `-inf`.
///
/// The numbers are computed in f64, at compile time only. Whether x is parsed from a decimal is decided by
/// rounding the decimal's f64 value to f32. That value is off by at most 50 roundings, a relative 10⁻¹⁴. So
/// the decision is wrong only for a decimal that lies within 10⁻¹⁴ of the middle between two f32 numbers.
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

/// The fewest digits from which x is parsed, as an integer that does not end in 0, and the decimal exponent
/// of the first of them: (125, −1) for 0.125. x is positive and finite.
const fn shortest(x: f32) -> (u64, i32) {
    let mut exponent = -45;
    while times_ten_to(1.0, exponent + 1) <= x as f64 {
        exponent += 1;
    }
    let mut count = 1;
    loop {
        let scaled = times_ten_to(x as f64, count - 1 - exponent);
        let nearest = (scaled + 0.5) as u64;
        // If x is a power of two, the f32 numbers below it lie closer together than those above. So another
        // number may be parsed from the nearest decimal, if that is below x, and x still from the next one
        // up.
        let next = if nearest as f64 > scaled { nearest - 1 } else { nearest + 1 };
        if is_parsed_from(x, nearest, exponent - count + 1) || count == 9 {
            return without_zeros(nearest, count, exponent);
        }
        if is_parsed_from(x, next, exponent - count + 1) {
            return without_zeros(next, count, exponent);
        }
        count += 1;
    }
}

/// Whether x is parsed from `digits·10^exponent`: here the exponent is that of the last digit.
const fn is_parsed_from(x: f32, digits: u64, exponent: i32) -> bool {
    times_ten_to(digits as f64, exponent) as f32 == x
}

/// The digits without the zeros at their end, and the exponent of the first digit. `exponent` is that of the
/// first of `count` digits; if rounding up has made them a power of ten of one digit more, the result is one
/// larger.
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

/// Appends the digits with a point after the first, unless that is the only one, and with `e` and the
/// exponent of the first digit: `1.25e-7`.
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

/// Appends the digits with a point where the exponent of the first digit puts it, and with zeros so that
/// there is at least one digit on each side of the point: `0.125`, `30.0`.
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

/// The i-th digit from the left in ASCII, counted from 0; `0` for an i before the first or after the last.
const fn digit(digits: u64, i: i32) -> u8 {
    let last = digits.ilog10() as i32;
    if i < 0 || i > last { b'0' } else { b'0' + (digits / 10_u64.pow((last - i) as u32) % 10) as u8 }
}
