//! What there is to see.

use crate::camera::Camera;
use crate::color::Background;
use crate::light::Light;
use crate::solid::Solid;

/// Solids, a camera, a light and a background. All of it can be a `static`, in flash.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::Gray4;
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static SCENE: Scene = Scene {
///     solids: &[Solid::new(&BALL, Rgb::WHITE)],
///     camera: valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     light: valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
///     background: Background::Plain(Rgb::BLACK),
/// };
///
/// let mut display = MockDisplay::<Gray4>::new();
/// SCENE.draw(&mut display)?;
/// assert_eq!(display.get_pixel((0, 0).into()), Some(Gray4::new(0)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a> {
    /// What is seen, in any order. Of two at the same distance, the first; where one only touches the other, either.
    ///
    /// Solids that a plane parts cost what each costs alone. Of two that none parts, one goes ray by ray.
    pub solids: &'a [Solid<'a>],
    /// From where.
    pub camera: Camera,
    /// In what light.
    pub light: Light,
    /// Before what.
    pub background: Background,
}
