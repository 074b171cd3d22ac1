//! A display that takes colors and shows nothing.

use core::{convert::Infallible, hint::black_box, marker::PhantomData};
use embedded_graphics::{prelude::*, primitives::Rectangle};

pub struct Sink<C> {
    size: Size,
    color: PhantomData<C>,
}

impl<C> Sink<C> {
    pub fn new(width: u32, height: u32) -> Self {
        Self { size: Size::new(width, height), color: PhantomData }
    }
}

impl<C> OriginDimensions for Sink<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor> DrawTarget for Sink<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|pixel| {
            black_box(pixel);
        });
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        _: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        colors.into_iter().for_each(|color| {
            black_box(color);
        });
        Ok(())
    }
}
