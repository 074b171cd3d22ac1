//! The normals of a segment's wall in integers.

use super::shift::Shift;
use crate::arithmetic::integers::{Direction, Numbers, Seen, Wall, fixed, high, inverse_root, square};
use crate::math::cold_path;

/// What the normals of a segment's wall are computed from where a root is tracked; and how far the last one was
/// magnified, as most often the next one is.
pub(super) struct Gradient {
    /// The multiplication that brings x and y to the unit of the gradient: 2^(block − 28), or, where the
    /// derivative of f would exceed 2²⁹ of these, the least power of two in which it does not.
    xy: Shift,
    /// a1, a2 and 3·a3 in that unit, where the gradient's z is a1 + 2·a2·v + 3·a3·v².
    z: [i32; 3],
    /// √k in units of 2⁻³¹; zero if k is 1.
    squash: i32,
    /// The last pixel's gradient was multiplied by 2^zoom to be the `along` of a [`Direction`].
    zoom: u32,
}

/// A gradient is multiplied by 2⁹ at most. Where it is shorter still, the row does not decide the pixel.
const MOST_ZOOM: u32 = 9;

impl Gradient {
    /// What belongs to the wall of a segment, seen from outside or from inside. `root_squash` is √k.
    pub fn new(wall: &Wall, numbers: Numbers, root_squash: f32, is_inside: bool) -> Self {
        let (block, height) = (i32::from(wall.block), i32::from(wall.height));
        // −½·dF/dz is the derivative over v times −2^(−1 − height).
        let left = 1 + block - height;
        let less = (3 - wall.steepest().leading_zeros() as i32 + left).max(0);
        let z = Shift::left(left - less);
        let [_, a1, a2, a3] = wall.a.map(|a| z.of(if is_inside { a } else { -a }));
        Self {
            xy: Shift::left(28 - block - less - numbers.p),
            z: [a1, a2, 3 * a3],
            squash: if root_squash.to_bits() == 1.0_f32.to_bits() { 0 } else { fixed(root_squash, 31) },
            zoom: 0,
        }
    }

    /// What is seen at a point of the wall, given its x, scaled by √k, and its y, both times −1 if the wall
    /// is seen from inside, and its v. `None` if the gradient is too short.
    ///
    /// Half the gradient of `k·x² + y² − F` in object space is `(k·x, y, −F′/2)`, of which √k·x is the given
    /// x. It points outwards; if the wall is seen from inside, its signs are changed.
    #[inline(always)]
    pub fn seen(&mut self, x: i32, y: i32, v: i32) -> Option<Seen> {
        let mut x = self.xy.of(x);
        if self.squash != 0 {
            x = high(x << 1, self.squash);
        }
        let [z0, z1, z2] = self.z;
        let z = (high((high(z2, v) + z1) << 1, v) << 1) + z0;
        let along = [x, self.xy.of(y), z];
        // Less than 2⁶⁰: x² + y² is at most 2⁵⁸, and so is z². Times 4^zoom it is 2⁵⁸ or more.
        let square = square(along);
        let (high, low) = ((square >> 32) as u32, square as u32);
        if (high >> (26 - 2 * self.zoom)).wrapping_sub(1) > 2 {
            cold_path();
            let zoom = (high.leading_zeros() - 4) >> 1;
            if zoom > MOST_ZOOM {
                return None;
            }
            self.zoom = zoom;
        }
        let zoom = self.zoom;
        let square = high << (2 + 2 * zoom) | low >> (30 - 2 * zoom);
        let direction =
            Direction { along: along.map(|x| x << zoom), per_length: inverse_root(square as i32) };
        Some(Seen { direction })
    }
}
