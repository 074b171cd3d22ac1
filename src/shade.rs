//! What color a visible point of a solid has: its color in ambient light and, by Lambert's law, in direct
//! light, plus Phong's highlight with a coefficient of ½.

use crate::arithmetic::{Seen, Share, ToLight, Views};
use crate::color::{Paint, Rgb, Shades, most_shades};
use crate::light::Light;
use crate::solid::Solid;

/// A solid's material in the scene's light: the quantities of its color that are the same for every pixel.
pub(crate) struct Finish {
    /// The exponent of the highlight, or zero if the solid is matt.
    shininess: u8,
    /// The direction to the light, in the solid's own space.
    pub to_light: ToLight,
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
            to_light: ToLight::new(solid.direction_into(light.towards)),
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
    pub fn shades<C: Paint>(&self, column: u32, seen: &Seen, to_light: &ToLight, views: &Views) -> Shades {
        let cosine = seen.cosine(to_light);
        let diffuse = self.ambient.with(self.direct.dimmed(cosine.share()));
        if self.shininess == 0 {
            return diffuse;
        }
        let white = const { Shades::of(most_shades::<C>()) };
        let share = views.highlight(column, seen.pairs(), cosine, to_light, self.shininess);
        diffuse.with_up_to(white.dimmed(share), const { Shades::of(most_shades::<C>()).rounded() })
    }
}
