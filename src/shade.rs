//! What color a visible point of a solid has: its color in ambient light and, by Lambert's law, in direct
//! light, plus Phong's highlight with a coefficient of ½.

use crate::color::{Paint, Rgb, Shades, Share, most_shades};
use crate::lathe::Seen;
use crate::light::Light;
use crate::math::rsqrt;
use crate::solid::Solid;
use crate::vector::{F32x3, Vector};

/// A solid's material in the scene's light: the quantities of its color that are the same for every pixel.
pub(crate) struct Finish {
    /// The exponent of the highlight, or zero if the solid is matt.
    shininess: u8,
    /// The direction to the light, in the solid's own space. Its length is [`Share::UNITS`], so that its dot
    /// product with a unit normal is the cosine in the fixed-point units of a [`Share`].
    pub to_light: F32x3,
    /// The color where no direct light falls, plus the half shade that [`Paint::shade`] expects.
    ambient: Shades,
    /// What direct light adds to the color where it falls along the surface normal.
    direct: Shades,
}

impl Finish {
    /// The material of a solid in a light, for a display of colors C; the color is the solid's, or a sheet's
    /// own.
    #[inline(always)]
    pub fn new<C: Paint>(solid: &Solid, color: &Rgb, light: &Light) -> Self {
        let color = color.shades(&most_shades::<C>());
        let ambient = color.dimmed(Share::of_one(light.ambient));
        Self {
            shininess: solid.shininess(),
            to_light: solid.direction_into(light.towards) * Share::UNITS,
            ambient: ambient.rounded(),
            direct: color.without(ambient),
        }
    }

    /// The color of a visible point. `column` is that of the ray that sees it; only the highlight depends on
    /// it. `to_light` is [`Finish::to_light`], or the mirror image of that where a pixel is the mirror image
    /// of another.
    // Not `inline(always)`: in a build for size, flash should contain the function only once. In a build for
    // speed the compiler inlines it, or the counts in docs/instructions.csv would be higher.
    #[inline]
    pub fn shades<C: Paint>(&self, column: u32, seen: &Seen, to_light: &F32x3, views: &Views) -> Shades {
        // In the units of a share. Where the surface faces away from the light the cosine is negative:
        // `Share::new` makes it zero.
        let cosine = seen.per_length * seen.gradient.dot(*to_light);
        let diffuse = self.ambient.with(self.direct.dimmed(Share::new(cosine)));
        if self.shininess == 0 {
            return diffuse;
        }
        let white = const { Shades::of(most_shades::<C>()) };
        let share = self.specular(seen.pairs(), cosine, to_light, views, column);
        diffuse.with_up_to(white.dimmed(share), const { Shades::of(most_shades::<C>()).rounded() })
    }

    /// The share of white that the highlight adds, given [`Seen::pairs`] of what is seen, the cosine between
    /// its normal and the direction to the light, in the units of a share, that direction, and the column whose
    /// ray sees the point.
    #[cold]
    fn specular(
        &self,
        seen: [(f32, f32); 2],
        cosine: f32,
        to_light: &F32x3,
        views: &Views,
        column: u32,
    ) -> Share {
        let Seen { gradient, per_length } = Seen::of_pairs(seen);
        if !(cosine > 0.0) {
            return Share::NONE;
        }
        let view = views.first + views.step * column as f32;
        // r·v, where r is the light's direction mirrored at the normal, and v the direction towards the eye.
        // It has the right sign before v is made a unit vector.
        let twice = 2.0 * cosine * per_length;
        let rv = to_light.dot(view) - twice * gradient.dot(view);
        if !(rv > 0.0) {
            return Share::NONE;
        }
        let rv = rv * (rsqrt(view.dot(view)) * (1.0 / Share::UNITS));
        Share::of_one(Light::highlight(self.shininess, rv))
    }
}

/// The directions of a row's rays, in a solid's own space: `first` that of column 0, `step` the difference
/// from one column to the next.
#[derive(Clone, Copy)]
pub(crate) struct Views {
    pub first: F32x3,
    pub step: F32x3,
}
