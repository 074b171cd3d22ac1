//! What a picture shows: solids, the camera and the light that they are seen with, and the background.

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
/// static SCENE: Scene = Scene::new(
///     &[Solid::new(&BALL, Rgb::WHITE)],
///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
/// );
///
/// let mut display = MockDisplay::<Gray4>::new();
/// SCENE.draw(&mut display)?;
/// assert_eq!(display.get_pixel((0, 0).into()), Some(Gray4::new(0)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// # Animation
///
/// Segments, and everything else that does not move, stay in flash. A program copies the scene to a variable,
/// and the solids that move to an array (about 80 bytes for each solid). Between two frames it changes these
/// copies. For each frame [`Scene::with_solids`] puts the two together: it copies the camera and the light,
/// and borrows the array.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::Gray4;
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(0.3)));
/// static SCENE: Scene = Scene::new(
///     &[Solid::new(&BALL, Rgb::WHITE), Solid::new(&BALL, Rgb::gray(0.3))],
///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
/// );
///
/// let mut scene = SCENE;
/// let mut solids = [scene.solids[0], scene.solids[1]];
/// for frame in 0..10 {
///     // Numbers that are computed at run time may be wrong: then a constructor returns an error.
///     let angle = 0.6 * frame as f32;
///     let pose = Pose::new([0.5 * angle.cos(), 0.5 * angle.sin(), 0.0], Rotation::IDENTITY, 1.0)?;
///     solids[0] = solids[0].posed(pose).colored(Rgb::gray(0.5 + 0.05 * frame as f32));
///     let eye = [0.0, -5.0, 0.1 * frame as f32];
///     scene.camera = Camera::orthographic(eye, [0.0; 3], [0.0, 0.0, 1.0], 1.2)?;
///
///     let mut display = MockDisplay::<Gray4>::new();
///     let Ok(()) = scene.with_solids(&solids).draw(&mut display);
/// }
/// # Ok::<(), SceneError>(())
/// ```
///
/// What a frame changes is often a small part of the picture: [`Redraw`](crate::Redraw) says which rectangle
/// to draw again.
///
/// # More to come
///
/// A scene is made by [`Scene::new`], not as a literal. Later versions may add fields; `new` will set each so
/// that the picture stays as it was before the field existed.
///
/// ```compile_fail,E0639
/// # use embedded_lathe::*;
/// fn literal<'a>(solids: &'a [Solid<'a>], camera: Camera, light: Light) -> Scene<'a> {
///     Scene { solids, camera, light, background: Background::default() }
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Scene<'a> {
    /// The solids, in any order. Where two of them are at the same distance, the first in the slice is seen;
    /// at a point where two only touch, either may be seen.
    ///
    /// If the renderer finds a plane that separates two solids, the two cost as much as each of them alone,
    /// added up. If it finds none, it compares their distances pixel by pixel: then each costs a little more
    /// than alone, and the picture takes 4 bytes of stack for each pixel of a row, 960 at most.
    pub solids: &'a [Solid<'a>],
    /// The camera that sees them.
    pub camera: Camera,
    /// The light that falls on them.
    pub light: Light,
    /// What is seen where no solid is.
    pub background: Background,
}

impl<'a> Scene<'a> {
    /// A scene before a black background.
    #[must_use]
    pub const fn new(solids: &'a [Solid<'a>], camera: Camera, light: Light) -> Self {
        Self { solids, camera, light, background: Background::BLACK }
    }

    /// This scene with other solids.
    #[must_use]
    pub const fn with_solids<'b>(self, solids: &'b [Solid<'b>]) -> Scene<'b> {
        let Self { camera, light, background, .. } = self;
        Scene { solids, camera, light, background }
    }

    /// This scene seen by another camera.
    #[must_use]
    pub const fn with_camera(self, camera: Camera) -> Self {
        Self { camera, ..self }
    }

    /// This scene in another light.
    #[must_use]
    pub const fn with_light(self, light: Light) -> Self {
        Self { light, ..self }
    }

    /// This scene before another background.
    #[must_use]
    pub const fn with_background(self, background: Background) -> Self {
        Self { background, ..self }
    }
}
