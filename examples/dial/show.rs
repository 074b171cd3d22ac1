//! A knob among text on a 128×64 panel: the firmware draws it there, `laboratory/tests/panel.rs` on the host, and both must agree.

use crate::scenes::dial::{DIAL, dial};
use core::f32::consts::TAU;
use embedded_graphics::{
    mono_font::{MonoTextStyle, MonoTextStyleBuilder, ascii::FONT_6X10},
    pixelcolor::Gray4,
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use embedded_lathe::{Redraw, Rgb};

/// Steps of a turn.
pub const STEPS: u32 = 24;

/// Where the knob's picture is.
const KNOB: Rectangle = Rectangle::new(Point::new(60, 0), Size::new(68, 64));

const WORDS: MonoTextStyle<Gray4> = MonoTextStyleBuilder::new()
    .font(&FONT_6X10)
    .text_color(Gray4::new(12))
    .background_color(Gray4::new(0))
    .build();

/// What is on the panel, frame by frame.
pub struct Screen {
    redraw: Redraw,
    /// The rectangle that the last frame drew of the knob's picture.
    pub changed: Rectangle,
}

impl Screen {
    /// Before the first frame, which draws all of the knob's picture.
    pub const fn new() -> Self {
        Self { redraw: Redraw::new(KNOB), changed: KNOB }
    }

    /// Draws frame n: the knob turned by n steps, and the angle in words. Only the first frame draws more than the number and
    /// the pointer, where it is and where it was. `None` if the display fails.
    pub fn draw<D: DrawTarget<Color = Gray4>>(&mut self, n: u32, display: &mut D) -> Option<()> {
        let step = n % STEPS;
        let mut solids = dial(step as f32 * (TAU / STEPS as f32)).ok()?;
        solids[1] = solids[1].colored(Rgb::gray(0.1));
        let picture = DIAL.with_solids(&solids).picture_of(KNOB.size).at(KNOB.top_left);
        self.changed = self.redraw.next(moved(picture.picture().covered_by(&solids[1])));
        picture.only(&self.changed).draw(display).ok()?;

        if n == 0 {
            Text::new("Volume", Point::new(6, 24), WORDS).draw(display).ok()?;
            Text::new("degrees", Point::new(6, 48), WORDS).draw(display).ok()?;
        }
        let degrees = step * 360 / STEPS;
        let digits = [degrees / 100, degrees / 10 % 10, degrees % 10].map(|digit| b'0' + digit as u8);
        Text::new(str::from_utf8(&digits).ok()?, Point::new(6, 36), WORDS).draw(display).ok()?;
        Some(())
    }
}

/// A rectangle of the knob's picture, on the panel.
fn moved(area: Rectangle) -> Rectangle {
    Rectangle::new(area.top_left + KNOB.top_left, area.size)
}
