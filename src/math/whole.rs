use super::minmax::{greater, lesser};

/// `x as u32`, bit by bit, by operations that wide registers have for several numbers at once: their own conversion is
/// to numbers with a sign.
///
/// Beside 2²³ there is no room for less than one: what is added to it is rounded to a whole number, which stands in the
/// lowest bits. So it goes for the multiples of 2⁹, and for what is left, to which nothing is lost. Rounded up, it is one
/// too many; and so is 2³², of which nothing remains.
#[inline(always)]
pub(crate) fn whole(x: f32) -> u32 {
    const MOST: f32 = 4_294_967_296.0;
    const ROUND: f32 = 8_388_608.0;
    // For what may be negative.
    const EITHER: f32 = 1.5 * ROUND;
    let cut = lesser(greater(0.0, x), MOST);
    let high = cut * (1.0 / 512.0) + ROUND;
    let left = cut - (high - ROUND) * 512.0;
    let low = left + EITHER;
    let too_many = u32::from(low - EITHER > left) + u32::from(cut == MOST);
    (high.to_bits() << 9).wrapping_add(low.to_bits()).wrapping_sub(EITHER.to_bits() + too_many)
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn is_what_the_language_makes_of_it() {
        let around = [0.5, 1.0, 256.0, 512.0, 8_388_608.0, 16_777_216.0, 2_147_483_648.0, 4_294_967_296.0f32];
        let around = around.into_iter().flat_map(|x| x.to_bits() - 1000..x.to_bits() + 1000);
        for x in (0..u32::MAX).step_by(997).chain(around).map(f32::from_bits) {
            assert_eq!(whole(x), x as u32, "{x:e}");
        }
    }
}
