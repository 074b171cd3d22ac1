//! A display that remembers every call and every pixel, and may fail.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use std::collections::HashMap;

#[derive(Clone)]
pub struct Recorder {
    area: Rectangle,
    /// The rectangles of all calls of `fill_contiguous`, in order.
    pub calls: Vec<Rectangle>,
    /// What each pixel shows that was ever written, also beyond the display's edges.
    pub shown: HashMap<(i32, i32), Rgb565>,
    /// The pixels written, in order, with those that were written twice.
    pub written: Vec<(i32, i32)>,
    /// After how many pixels the display fails.
    fails_after: usize,
    has_failed: bool,
}

impl Recorder {
    pub fn new(area: Rectangle) -> Self {
        let (calls, shown, written) = Default::default();
        Self { area, calls, shown, written, fails_after: usize::MAX, has_failed: false }
    }

    pub fn of_size(width: u32, height: u32) -> Self {
        Self::new(Rectangle::new(Point::zero(), Size::new(width, height)))
    }

    pub fn failing_after(self, pixels: usize) -> Self {
        Self { fails_after: pixels, ..self }
    }

    /// Forgets the calls and the order of the pixels, but not what is shown.
    #[allow(dead_code)]
    pub fn next_frame(&mut self) {
        self.calls.clear();
        self.written.clear();
    }

    #[allow(dead_code)]
    pub fn at(&self, x: i32, y: i32) -> Option<Rgb565> {
        self.shown.get(&(x, y)).copied()
    }

    fn put(&mut self, at: Point, color: Rgb565) -> Result<(), &'static str> {
        assert!(!self.has_failed, "drawn after an error");
        if self.written.len() == self.fails_after {
            self.has_failed = true;
            return Err("cable");
        }
        self.shown.insert((at.x, at.y), color);
        self.written.push((at.x, at.y));
        Ok(())
    }
}

impl Dimensions for Recorder {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Recorder {
    type Color = Rgb565;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        pixels.into_iter().try_for_each(|Pixel(at, color)| self.put(at, color))
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Self::Error> {
        assert!(!self.has_failed, "a call after an error");
        self.calls.push(*area);
        area.points().zip(colors).try_for_each(|(at, color)| self.put(at, color))
    }
}
