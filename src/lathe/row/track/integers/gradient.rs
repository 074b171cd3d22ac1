//! The normals of a segment's wall in integers.

use super::shift::Shift;
use crate::arithmetic::integers::{Direction, Numbers, Seen, Wall, fixed, high, inverse_root, square};

/// What the normals of a segment's wall are computed from where a root is tracked; and the length of the last
/// normal, from which the search for the next one's length begins.
pub(super) struct Gradient {
    /// The multiplications that bring x and y, and the derivative of f, to the unit of the gradient:
    /// 2^(block − 28), or, where the derivative would exceed 2²⁹ of these, the least power of two in which
    /// it does not.
    xy: Shift,
    z: Shift,
    /// √k in units of 2⁻³¹; zero if k is 1.
    squash: i32,
    /// Whether the wall is seen from inside.
    is_inside: bool,
    /// The last pixel's gradient was multiplied by 2^zoom to be the `along` of a [`Direction`].
    zoom: u32,
    /// The `per_length` of that [`Direction`]; zero before the first pixel.
    per_length: i32,
    /// By how much `per_length` changed at the last pixel; zero at the first one.
    change: i32,
}

/// A gradient is multiplied by 2¹⁰ at most. Where it is shorter still, the row does not decide the pixel.
const MOST_ZOOM: u32 = 10;

impl Gradient {
    /// What belongs to the wall of a segment, seen from outside or from inside. `root_squash` is √k.
    pub fn new(wall: &Wall, numbers: Numbers, root_squash: f32, is_inside: bool) -> Self {
        let &Wall { a: [_, a1, a2, a3], block, height } = wall;
        let (block, height) = (i32::from(block), i32::from(height));
        // −½·dF/dz is the derivative over v times −2^(−1 − height). Where |v| ≤ 1/2 it is at most this:
        let most = a1.unsigned_abs() + a2.unsigned_abs() + a3.unsigned_abs();
        let left = 1 + block - height;
        let less = (32 - most.leading_zeros() as i32 + left - 29).max(0);
        Self {
            xy: Shift::left(28 - block - less - numbers.p),
            z: Shift::left(left - less),
            squash: if root_squash == 1.0 { 0 } else { fixed(root_squash, 31) },
            is_inside,
            zoom: 0,
            per_length: 0,
            change: 0,
        }
    }

    /// What is seen at a point of the wall, given its x, scaled by √k, and its y, both times −1 if the wall
    /// is seen from inside, and the derivative of f over v. `None` if the gradient is too short.
    ///
    /// Half the gradient of `k·x² + y² − F` in object space is `(k·x, y, −F′/2)`, of which √k·x is the given
    /// x. It points outwards; if the wall is seen from inside, its signs are changed.
    #[inline(always)]
    pub fn seen(&mut self, x: i32, y: i32, slope: i32) -> Option<Seen> {
        let mut x = self.xy.of(x);
        if self.squash != 0 {
            x = high(x << 1, self.squash);
        }
        let z = self.z.of(slope);
        let along = [x, self.xy.of(y), if self.is_inside { z } else { -z }];
        // Less than 2⁶⁰: x² + y² is at most 2⁵⁸, and so is z².
        let square = square(along);
        let (high, low) = ((square >> 32) as u32, square as u32);
        loop {
            let most = (1 << 28) >> (2 * self.zoom);
            if high >= most {
                self.zoom = self.zoom.checked_sub(1)?;
            } else if high < (most >> 4) + (most >> 8) {
                if self.zoom == MOST_ZOOM {
                    return None;
                }
                self.zoom += 1;
            } else {
                break;
            }
        }
        let guess = self.per_length.wrapping_add(self.change).max(1 << 29);
        let square = high << (2 + 2 * self.zoom) | low >> (30 - 2 * self.zoom);
        let per_length = inverse_root(square as i32, guess);
        self.change = if self.per_length == 0 { 0 } else { per_length - self.per_length };
        self.per_length = per_length;
        Some(Seen { direction: Direction { along: along.map(|x| x << self.zoom), per_length } })
    }
}
