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

    /// The part of this rectangle that lies in another. If the two do not overlap, the result has no pixels,
    /// and its four edges still lie within the other's.
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

    /// The smallest rectangle that holds both. Neither may be empty.
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
    /// A rectangle of a picture outside of which no pixel shows the solid. `None` if it is proven that no
    /// pixel shows it, or if the picture has no pixels.
    ///
    /// The rays of a column of pixels lie in a plane, and so do those of a row. At the left edge, the columns
    /// whose planes are proven to have all of the solid on their right are left out, and likewise at the
    /// other three edges. How many they are is found by bisection, with some 8 planes for each edge of a
    /// picture of 240 pixels. If a part of the solid may lie beside the eye of a perspective camera or behind
    /// it, the rectangle is the whole picture.
    pub(crate) fn extent(&self, camera: &Camera, width: u32, height: u32) -> Option<Extent> {
        if width == 0 || height == 0 {
            return None;
        }
        let local = LocalCamera::new(self, camera);
        let back = cross(local.right, local.up);
        if local.is_behind(back * -1.0, local.eye) {
            return None;
        }
        if camera.is_perspective() && !local.is_behind(back, local.eye) {
            return Some(Extent { left: 0, top: 0, right: width, bottom: height });
        }
        let LocalCamera { right: x, up: y, .. } = local;
        let left = local.clear(width, width, x, y * -1.0);
        let right = local.clear(width, width, x * -1.0, y);
        let top = local.clear(height, width, y * -1.0, x * -1.0);
        let bottom = local.clear(height, width, y, x);
        let extent = Extent { left, top, right: width - right, bottom: height - bottom };
        (!extent.is_empty()).then_some(extent)
    }
}

/// A solid, and the vectors of a [`Camera`] in the solid's own space.
struct LocalCamera<'a> {
    solid: &'a Solid<'a>,
    eye: F32x3,
    forward: F32x3,
    right: F32x3,
    up: F32x3,
    is_perspective: bool,
    /// A length by which the origins of the rays may be wrong, in units of 2⁻²⁴.
    rough: f32,
}

impl<'a> LocalCamera<'a> {
    /// The camera, moved to the solid's own space. Only the eye's vector is scaled with the pose: the others
    /// keep their lengths in the world.
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

    /// Whether all sheets of the solid are proven to lie behind the plane through `point`, on the side that
    /// `normal` points away from: see [`Lathe::is_behind`](crate::Lathe).
    fn is_behind(&self, normal: F32x3, point: F32x3) -> bool {
        self.solid.sheets().all(|sheet| sheet.lathe().is_behind(normal, point, self.rough))
    }

    /// How many lines of pixels, counted from one edge of the picture, are proven to show no part of the
    /// solid. The lines are columns or rows; there are `lines` of them. If the n-th line has all of the solid
    /// on its far side from the edge, so have the lines before it: the largest such n is found by bisection.
    ///
    /// `across` is the vector from the middle of the picture away from that edge, a half-width long. `along`
    /// is a vector along the lines, in the sense in which the cross product of the rays' direction and
    /// `along` points to the edge.
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

    /// Whether all of the solid is proven to lie on the inner side of a line of pixels, so that no ray of the
    /// line hits it. `offset` is the vector from the middle of the picture to the line, `along` a vector
    /// along it. The cross product of the rays' direction and `along` points to the outer side.
    fn is_inside_of(&self, offset: F32x3, along: F32x3) -> bool {
        let (direction, point) = if self.is_perspective {
            (self.forward + offset, self.eye)
        } else {
            (self.forward, self.eye + offset * (1.0 / self.solid.pose().scale()))
        };
        self.is_behind(cross(direction, along), point)
    }
}
