//! The rectangle that a picture's solids cover, and what of it a frame must draw again.

use crate::camera::Camera;
use crate::extent::Extent;
use crate::picture::Picture;
use crate::solid::Solid;
use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

impl Camera {
    /// The pixel of a picture that shows a point of the world, or would show it if no solid hid it: what
    /// [`Camera::project`] returns, rounded. The pixel may lie outside the picture. `None` where `project`
    /// returns it.
    ///
    /// ```
    /// use embedded_graphics::prelude::*;
    /// use embedded_lathe::{Camera, valid};
    ///
    /// const FRONT: Camera = valid!(Camera::perspective([0.0, -2.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 0.5));
    /// assert_eq!(FRONT.pixel_of([0.25, 0.0, 0.0], Size::new(80, 41)), Some(Point::new(50, 20)));
    /// ```
    #[must_use]
    pub fn pixel_of(&self, point: [f32; 3], picture: Size) -> Option<Point> {
        let place = self.project(point, picture.width, picture.height)?;
        // A half is rounded up, and what is beyond an `i32` saturates.
        let [x, y] = place.map(|i| {
            let whole = i as i32;
            let rest = i - whole as f32;
            whole.saturating_add(if rest >= 0.5 {
                1
            } else if rest < -0.5 {
                -1
            } else {
                0
            })
        });
        Some(Point::new(x, y))
    }
}

impl Picture<'_> {
    /// A rectangle that holds every pixel of the picture that shows a solid; its size is zero if no pixel
    /// does. See [`Picture::covered_by`].
    #[must_use]
    pub fn covered(&self) -> Rectangle {
        self.rectangle(self.extent(self.scene().solids))
    }

    /// A rectangle that holds every pixel of the picture that shows the solid, or would show it if no other
    /// hid it. The solid need not be one of the scene's. Its size is zero if there is no such pixel.
    ///
    /// The rectangle is proven to hold all of these pixels, and is rarely larger than need be. In two cases
    /// it is the whole picture: if part of the solid lies beside a perspective camera's eye or behind it, and
    /// if the solid is an endless sheet.
    ///
    /// It costs some 35 evaluations of the solid's segments, as much as a few rows of pixels.
    ///
    /// ```
    /// use embedded_graphics::{geometry::Point, prelude::*, primitives::Rectangle};
    /// use embedded_lathe::*;
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// static SCENE: Scene = Scene::new(
    ///     &[Solid::new(&BALL, Rgb::WHITE)],
    ///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 2.0)),
    ///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// );
    ///
    /// let picture = SCENE.picture(80, 60);
    /// assert_eq!(picture.covered_by(&SCENE.solids[0]), Rectangle::new(Point::new(20, 10), Size::new(40, 40)));
    /// ```
    #[must_use]
    pub fn covered_by(&self, solid: &Solid) -> Rectangle {
        self.rectangle(self.extent(core::slice::from_ref(solid)))
    }

    /// The smallest rectangle that holds the [`Solid::extent`] of each of the solids, and so every pixel
    /// whose ray hits one of them. `None` if it is proven that no ray does.
    pub(super) fn extent(&self, solids: &[Solid]) -> Option<Extent> {
        let (width, height) = (self.width(), self.height());
        let extents = solids.iter().filter_map(|solid| solid.extent(&self.scene().camera, width, height));
        extents.reduce(Extent::with)
    }

    /// An extent of the picture as a rectangle of embedded-graphics: its size is zero for `None`.
    fn rectangle(&self, extent: Option<Extent>) -> Rectangle {
        let Some(Extent { left, top, right, bottom }) = extent else {
            return Rectangle::zero();
        };
        match (i32::try_from(left), i32::try_from(top)) {
            (Ok(x), Ok(y)) => Rectangle::new(Point::new(x, y), Size::new(right - left, bottom - top)),
            // The solids begin at a pixel that the `i32` coordinates of embedded-graphics cannot number. The
            // whole picture, whose first pixel is at zero, holds them too.
            _ => Rectangle::new(Point::zero(), Size::new(self.width(), self.height())),
        }
    }
}

/// Finds the rectangle that each frame must draw again: the one that holds what this frame shows and what the
/// frame before it showed.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
/// use embedded_lathe::*;
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(0.2)));
/// static SCENE: Scene = Scene::new(
///     &[],
///     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.0)),
///     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
/// );
///
/// let mut display = MockDisplay::<Gray4>::new();
/// display.set_allow_overdraw(true);
/// // The first frame draws all of the picture.
/// let mut redraw = Redraw::new(display.bounding_box());
/// for frame in 0..10 {
///     let pose = Pose::new([0.05 * frame as f32, 0.0, 0.0], Rotation::IDENTITY, 1.0)?;
///     let solids = [Solid::new(&BALL, Rgb::WHITE).posed(pose)];
///     let picture = SCENE.with_solids(&solids).picture(64, 64).at(Point::zero());
///     let area = redraw.next(picture.covered());
///     assert!(frame == 0 || area.size.width < 20);
///     let Ok(()) = picture.only(&area).draw(&mut display);
/// }
/// # Ok::<(), SceneError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Redraw {
    /// What the last frame covered; before the first frame, what that frame draws in any case.
    last: Rectangle,
}

impl Redraw {
    /// The state before the first frame. The first frame draws at least the rectangle `shown`. Give the whole
    /// picture if the display does not show its background yet.
    #[must_use]
    pub const fn new(shown: Rectangle) -> Self {
        Self { last: shown }
    }

    /// What a frame has to draw: the smallest rectangle that holds `now`, which the frame covers, and what
    /// the frame before it covered. `now` is remembered for the next frame.
    pub fn next(&mut self, now: Rectangle) -> Rectangle {
        let both = envelope(self.last, now);
        self.last = now;
        both
    }
}

/// The smallest rectangle that holds two. If one of them has no pixels, it is the other.
fn envelope(one: Rectangle, other: Rectangle) -> Rectangle {
    let is_empty = |area: &Rectangle| area.size.width == 0 || area.size.height == 0;
    if is_empty(&one) {
        return other;
    }
    if is_empty(&other) {
        return one;
    }
    let start = one.top_left.component_min(other.top_left);
    let span = |start: i32, ends: [(i32, u32); 2]| {
        let [a, b] = ends.map(|(from, len)| i64::from(from) + i64::from(len) - i64::from(start));
        u32::try_from(a.max(b)).unwrap_or(u32::MAX)
    };
    let width = span(start.x, [one, other].map(|area| (area.top_left.x, area.size.width)));
    let height = span(start.y, [one, other].map(|area| (area.top_left.y, area.size.height)));
    Rectangle::new(start, Size::new(width, height))
}
