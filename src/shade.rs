//! What color a visible point of a solid has: its color in ambient light and, by Lambert's law, in direct
//! light, plus Phong's highlight with a coefficient of ½.

use crate::arithmetic::{Gloss, Seen, Share, ToLight, Views};
use crate::color::{Paint, Rgb, Shades, most_shades};
use crate::light::Light;
use crate::solid::Solid;

/// A solid's material in the scene's light: the quantities of its color that are the same for every pixel.
pub(crate) struct Finish {
    /// The direction to the light, in the solid's own space.
    pub to_light: ToLight,
    /// The share of light that falls everywhere.
    ambient: Share,
    /// Four times the color.
    color: Shades,
}

/// The direction to a light, in a solid's own space.
#[inline(always)]
pub(crate) const fn to_light(solid: &Solid, light: &Light) -> ToLight {
    ToLight::new(solid.direction_into(light.towards), light.direct)
}

impl Finish {
    /// The material of a solid in a light, for a display of colors C; the color is the solid's, or a sheet's
    /// own. `known` is the direction to the light in the solid's own space, if that is known.
    #[inline(always)]
    pub fn new<C: Paint>(solid: &Solid, color: &Rgb, light: &Light, known: Option<ToLight>) -> Self {
        let color = color.shades(most_shades::<C>()).times_four();
        let to_light = known.unwrap_or_else(|| to_light(solid, light));
        Self { to_light, ambient: light.everywhere, color }
    }

    /// The color of a visible point without a highlight. `to_light` is [`Finish::to_light`], or the mirror
    /// image of that where a pixel is the mirror image of another.
    #[inline(always)]
    pub fn matt(&self, seen: &Seen, to_light: &ToLight) -> Shades {
        self.diffuse(seen.cosine(to_light).share(to_light))
    }

    /// The color where the light has that share.
    #[inline(always)]
    fn diffuse(&self, light: Share) -> Shades {
        self.color.quarter(self.ambient.with(light)).rounded()
    }

    /// The color of a visible point with its highlight. `column` is that of the ray that sees it; only the
    /// highlight depends on it. `to_light` is as in [`Finish::matt`].
    #[inline(always)]
    pub fn shades<C: Paint>(
        &self,
        column: u32,
        seen: &Seen,
        to_light: &ToLight,
        views: &Views,
        gloss: &Gloss,
    ) -> Shades {
        let cosine = seen.cosine(to_light);
        let diffuse = self.diffuse(cosine.share(to_light));
        let share = views.highlight(column, seen, cosine, to_light, gloss);
        diffuse.with_up_to(
            most_shades::<C>().quarter(share),
            const { most_shades::<C>().quarter(Share::of_one(1.0)).rounded() },
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lathe::Lathe;
    use crate::profile::Profile;
    use crate::vector::vector;

    /// White in light that falls along the normal, from many directions, with gradients of many lengths.
    #[test]
    fn no_channel_exceeds_its_shades() {
        let ball = Lathe::turn(Profile::sphere(1.0).unwrap());
        let solid = Solid::new(&ball, Rgb::WHITE);
        let mut most = 0;
        for number in 0..4096 {
            let angle = number as f32 * 0.7;
            let towards = [libm::cosf(angle), libm::sinf(angle), libm::sinf(angle * 0.3)];
            let light = Light::new(towards, [0.0, 0.15, 0.99, 1.0][number % 4]).unwrap();
            let finish = Finish::new::<Rgb>(&solid, &Rgb::WHITE, &light, None);
            let seen = Seen::new(vector(towards) * (1.0 + number as f32 / 512.0));
            let [red, _, _] = finish.matt(&seen, &finish.to_light).units();
            most = most.max(red);
        }
        let all = 128 * Shades::ONE;
        assert!(most <= all && most > all - all / 500_000, "{most} of {all}");
    }
}
