//! Which columns and rows of a picture a solid can be seen in.

use crate::camera::Camera;
use crate::solid::Solid;
use crate::vector::{F32x3, cross, one_norm};

/// A rectangle of pixels: the columns from `left` to before `right`, the rows from `top` to before `bottom`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Extent {
    pub left: u32,
    pub top: u32,
    pub right: u32,
    pub bottom: u32,
}

impl Extent {
    /// Whether it has no pixels.
    pub fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// What of it lies in another; without pixels, but inside the other, if the two do not overlap.
    pub fn cut_to(self, other: Self) -> Self {
        let columns = |i: u32| i.max(other.left).min(other.right);
        let rows = |i: u32| i.max(other.top).min(other.bottom);
        Self {
            left: columns(self.left),
            top: rows(self.top),
            right: columns(self.right),
            bottom: rows(self.bottom),
        }
    }

    /// The smallest rectangle that holds both.
    pub fn with(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }
}

impl Solid<'_> {
    /// A rectangle of a picture outside of which no pixel shows the solid; `None` if no pixel shows it.
    ///
    /// The rays of a column lie in a plane, and so do those of a row. The first column of the rectangle is the
    /// one after the last whose plane is proven to have the solid on its right, and so on: found by bisection,
    /// with some 8 planes for each side of a picture of 240 pixels. If the eye of a perspective camera may
    /// have a part of the solid beside it or behind, the rectangle is the whole picture.
    pub(crate) fn extent(&self, camera: &Camera, width: u32, height: u32) -> Option<Extent> {
        if width == 0 || height == 0 {
            return None;
        }
        let seen = Seen::new(self, camera);
        let back = cross(seen.right, seen.up);
        if seen.is_behind(back * -1.0, seen.eye) {
            return None;
        }
        if camera.is_perspective() && !seen.is_behind(back, seen.eye) {
            return Some(Extent { left: 0, top: 0, right: width, bottom: height });
        }
        let Seen { right: x, up: y, .. } = seen;
        let left = seen.clear(width, width, x, y * -1.0);
        let right = seen.clear(width, width, x * -1.0, y);
        let top = seen.clear(height, width, y * -1.0, x * -1.0);
        let bottom = seen.clear(height, width, y, x);
        let extent = Extent { left, top, right: width - right, bottom: height - bottom };
        (!extent.is_empty()).then_some(extent)
    }
}

/// A solid, and a camera in the solid's own space.
struct Seen<'a> {
    solid: &'a Solid<'a>,
    eye: F32x3,
    forward: F32x3,
    right: F32x3,
    up: F32x3,
    is_perspective: bool,
    /// A length by which the origins of the rays may be wrong, in units of 2⁻²⁴.
    rough: f32,
}

impl<'a> Seen<'a> {
    fn new(solid: &'a Solid<'a>, camera: &Camera) -> Self {
        let is_perspective = camera.is_perspective();
        Self {
            solid,
            eye: solid.pose().point_into(camera.eye),
            forward: solid.direction_into(camera.forward),
            right: solid.direction_into(camera.right),
            up: solid.direction_into(camera.up),
            is_perspective,
            rough: if is_perspective { 0.0 } else { one_norm(camera.eye) / solid.pose().scale() },
        }
    }

    /// Whether the solid is proven to lie behind a plane: see [`Lathe::is_behind`](crate::Lathe).
    fn is_behind(&self, normal: F32x3, point: F32x3) -> bool {
        self.solid.sheets().all(|sheet| sheet.lathe().is_behind(normal, point, self.rough))
    }

    /// How many columns or rows are proven to be clear of the solid, counted from one edge of the picture: the
    /// largest number whose last line is, found by bisection. `lines` is how many there are. `across` is the
    /// vector from the middle of the picture away from that edge, a half-width long; `along` is a vector along
    /// the lines whose product with the direction of the rays points to that edge.
    #[inline(never)]
    fn clear(&self, lines: u32, width: u32, across: F32x3, along: F32x3) -> u32 {
        let (mut least, mut most) = (0, lines);
        while least < most {
            let middle = least + (most - least).div_ceil(2);
            // The line's place, counted in half-widths from the middle, negative on this edge's side.
            let place = (2.0 * (middle - 1) as f32 + 1.0 - lines as f32) / width as f32;
            if self.is_inside_of(across * place, along) {
                least = middle;
            } else {
                most = middle - 1;
            }
        }
        least
    }

    /// Whether no ray of a column or a row hits the solid, since all of the solid lies on that side of them
    /// which the product of the rays' direction and `along` points away from. `offset` is the vector from the
    /// middle of the picture to that line of pixels, `along` a vector along the line.
    fn is_inside_of(&self, offset: F32x3, along: F32x3) -> bool {
        let (direction, point) = if self.is_perspective {
            (self.forward + offset, self.eye)
        } else {
            (self.forward, self.eye + offset * (1.0 / self.solid.pose().scale()))
        };
        self.is_behind(cross(direction, along), point)
    }
}
