//! Rows as a display's bus takes them: bytes.

use crate::color::{Paint, Rgb, Shades};
use crate::picture::Picture;
use embedded_graphics_core::pixelcolor::{Rgb565, raw::ToBytes};

/// A pixel as most color displays take it: `Rgb565`, its high byte first.
impl Paint for [u8; 2] {
    const SHADES: Rgb = Rgb565::SHADES;

    #[inline]
    fn shade(shades: Shades, x: u32, y: u32) -> Self {
        Rgb565::shade(shades, x, y).to_be_bytes()
    }
}

impl Picture<'_> {
    /// Writes the pixels of row y from column x on into `bytes`, two bytes each: `Rgb565`, the high byte
    /// first, as most color displays take it. They are as many as the row has there, or as there is room for;
    /// what is left of `bytes` stays as it is.
    ///
    /// So a row goes to a display by DMA without a copy. While one buffer is sent, the next row is computed
    /// into another: `examples/two_rows` shows how. A row depends on no other row, so a frame can be left
    /// between two rows and taken up again later, or its rows shared between two cores.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, raw::ToBytes};
    /// use embedded_lathe::*;
    /// # static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// # static SCENE: Scene = Scene::new(
    /// #     &[Solid::new(&BALL, Rgb::WHITE)],
    /// #     valid!(Camera::orthographic([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 1.2)),
    /// #     valid!(Light::new([-1.0, -1.0, 1.0], 0.1)),
    /// # );
    ///
    /// let picture = SCENE.picture(240, 240);
    /// let mut buffer = [0; 480];
    /// picture.bytes_of_row(0, 120, &mut buffer);
    ///
    /// let mut row = [Rgb565::default(); 240];
    /// picture.row(120, &mut row);
    /// assert_eq!(buffer[200..202], row[100].to_be_bytes());
    /// ```
    pub fn bytes_of_row(&self, x: u32, y: u32, bytes: &mut [u8]) {
        self.part_of_row(x, y, bytes.as_chunks_mut::<2>().0);
    }
}
