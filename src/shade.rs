//! What color a visible point of a solid has: Lambert's diffuse share of its color, and half of Phong's
//! highlight.

use crate::color::{Paint, Shades, Share, most_shades};
use crate::lathe::Seen;
use crate::light::Light;
use crate::math::rsqrt;
use crate::solid::Solid;
use crate::vector::{F32x3, Vector};

/// A solid's material in the scene's light: what of the color is the same for every pixel.
pub(crate) struct Finish {
    /// The exponent of the highlight, or zero if the solid is matt.
    shininess: u8,
    /// The direction to the light, in the solid's own space. Its length is [`Share::UNITS`], so that the
    /// cosine comes out of the dot product in the fixed-point units of a [`Share`].
    pub to_light: F32x3,
    /// The color where no direct light falls. It carries the bias of half a shade that [`Paint::shade`]
    /// expects.
    ambient: Shades,
    /// What direct light adds where it falls at a right angle.
    direct: Shades,
}

impl Finish {
    /// The material of a solid in a light, for a display of colors C.
    #[inline(always)]
    pub fn new<C: Paint>(solid: &Solid, light: &Light) -> Self {
        let color = solid.color().shades(most_shades::<C>());
        let ambient = color.dimmed(Share::of_one(light.ambient));
        Self {
            shininess: solid.shininess(),
            to_light: solid.direction_into(light.towards) * Share::UNITS,
            ambient: ambient.rounded(),
            direct: color.without(ambient),
        }
    }

    /// The color of a visible point, seen in a column, with the light in direction `to_light`, as long as
    /// that of the material: the material's own, or its mirror image.
    // Not always in line: where flash counts, it stands once. Where speed does, the record of instructions
    // shows whether the compiler decides otherwise.
    #[inline]
    pub fn shades<C: Paint>(&self, column: u32, seen: &Seen, to_light: &F32x3, views: &Views) -> Shades {
        // A negative cosine, a surface that faces away from the light, saturates to zero.
        let cosine = seen.per_length * seen.gradient.dot(*to_light);
        let diffuse = self.ambient.with(self.direct.dimmed(Share::new(cosine)));
        if self.shininess == 0 {
            return diffuse;
        }
        let white = const { Shades::of(most_shades::<C>()) };
        let share = self.specular(seen.gradient * seen.per_length, to_light, views, column);
        diffuse.with_up_to(white.dimmed(share), const { Shades::of(most_shades::<C>()).rounded() })
    }

    /// The share of white that the highlight adds, given the unit normal, the light's direction, and the
    /// column whose ray sees the point.
    #[cold]
    fn specular(&self, normal: F32x3, to_light: &F32x3, views: &Views, column: u32) -> Share {
        let view = views.first + views.step * column as f32;
        let nl = normal.dot(*to_light);
        // r·v, where r is the light's direction mirrored by the surface, and v is against the view.
        let rv = to_light.dot(view) - 2.0 * nl * normal.dot(view);
        let rv = rv * (rsqrt(view.dot(view)) * (1.0 / Share::UNITS));
        Share::of_one(Light::highlight(self.shininess, nl, rv))
    }
}

/// The directions of a row's rays, in a solid's own space: `first` that of column 0, `step` the difference
/// from one column to the next.
#[derive(Clone, Copy)]
pub(crate) struct Views {
    pub first: F32x3,
    pub step: F32x3,
}
