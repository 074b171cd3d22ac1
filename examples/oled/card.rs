//! A picture that tries the panel's driver, with nothing of the library in it.

use embedded_graphics::{
    pixelcolor::Gray4,
    prelude::*,
    primitives::{Circle, Line, PrimitiveStyle, Rectangle},
};

/// All grays, a border, rectangles with odd edges and over the display's, and single pixels.
pub fn card<D: DrawTarget<Color = Gray4>>(n: i32, display: &mut D) -> Result<(), D::Error> {
    let all = display.bounding_box();
    display.fill_contiguous(&all, (0..64 * 128).map(|i| Gray4::new(((i / 8) % 16) as u8)))?;
    all.into_styled(PrimitiveStyle::with_stroke(Gray4::WHITE, 1)).draw(display)?;

    let steps = |k: u32| (0..k).map(|i| Gray4::new((i % 16) as u8));
    for at in [(-5, -3), (3 + n, 31), (121, 58), (-200, 5), (64, -7), (64, 64), (117, 20)] {
        display.fill_contiguous(&Rectangle::new(at.into(), Size::new(13, 9)), steps(13 * 9))?;
    }
    display.fill_contiguous(&Rectangle::new(Point::new(81, 41), Size::new(7, 5)), steps(17))?;
    display.fill_solid(&Rectangle::new(Point::new(99, 7), Size::new(5, 11)), Gray4::new(3))?;
    display.fill_contiguous(&Rectangle::new(Point::new(-40, -20), Size::new(300, 25)), steps(300 * 25))?;

    Circle::new(Point::new(50 + n, 20), 25)
        .into_styled(PrimitiveStyle::with_stroke(Gray4::new(9), 1))
        .draw(display)?;
    Line::new(Point::new(-9, 70), Point::new(140, -3))
        .into_styled(PrimitiveStyle::with_stroke(Gray4::BLACK, 1))
        .draw(display)
}
