//! The lm3s6965evb's panel: an SSD0323, 128×64 in 16 grays, on SSI0.

use core::{convert::Infallible, ops::RangeInclusive, ptr::with_exposed_provenance_mut};
use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};

const WIDTH: u32 = 128;
const HEIGHT: u32 = 64;

/// A register of the chip, by its address.
///
/// Only those that QEMU's board looks at are written: a real one wants its clock gates and pin functions set as well.
#[derive(Clone, Copy)]
struct Register(usize);

impl Register {
    fn write(self, value: u32) {
        // SAFETY: every `Register` below is one of the LM3S6965's, and belongs to this driver.
        unsafe { with_exposed_provenance_mut::<u32>(self.0).write_volatile(value) }
    }

    fn read(self) -> u32 {
        // SAFETY: as above.
        unsafe { with_exposed_provenance_mut::<u32>(self.0).read_volatile() }
    }
}

// A GPIO port's data register repeats at 256 addresses; bits 9..2 of the address say which pins an access touches.
const SELECT_DIRECTION: Register = Register(0x4000_7400); // port D
const SELECT: Register = Register(0x4000_7000 + (0x01 << 2));
const DATA_DIRECTION: Register = Register(0x4000_6400); // port C
const DATA: Register = Register(0x4000_6000 + (0x80 << 2));
const SSI_CR0: Register = Register(0x4000_8000);
const SSI_CR1: Register = Register(0x4000_8004);
const SSI_DR: Register = Register(0x4000_8008);
const SSI_SR: Register = Register(0x4000_800c);
const SSI_CPSR: Register = Register(0x4000_8010);

const RECEIVED: u32 = 1 << 2; // in SR

// The SSD0323's commands; their operands follow, as commands too.
const COLUMNS: u8 = 0x15;
const ROWS: u8 = 0x75;
const ON: u8 = 0xaf;

/// The panel. Two pixels share a byte and it cannot be read back, so the driver remembers what it shows.
pub struct Panel<'a> {
    shadow: &'a mut [[u8; 64]; 64],
}

impl<'a> Panel<'a> {
    /// Sets up the bus, clears the panel and turns it on.
    pub fn new(shadow: &'a mut [[u8; 64]; 64]) -> Self {
        SELECT_DIRECTION.write(0x01);
        DATA_DIRECTION.write(0x80);
        SELECT.write(0x01);
        SSI_CPSR.write(2); // divide the clock by 2
        SSI_CR0.write(7); // 8 bits a transfer
        SSI_CR1.write(2); // enable, as master

        let mut panel = Panel { shadow };
        let Ok(()) = panel.clear(Gray4::BLACK);
        send(&[ON], false);
        panel
    }
}

/// Sends bytes, as data or as commands.
fn send(bytes: &[u8], data: bool) {
    DATA.write(if data { 0x80 } else { 0 });
    for &byte in bytes {
        SSI_DR.write(byte.into());
        while SSI_SR.read() & RECEIVED == 0 {}
        SSI_DR.read(); // each byte out brings one in, and a full queue of them would stop the bus
    }
}

/// Opens a window, in bytes by rows: the data that follow fill it line by line.
fn window(columns: &RangeInclusive<usize>, rows: &RangeInclusive<usize>) {
    send(&[COLUMNS, *columns.start() as u8, *columns.end() as u8], false);
    send(&[ROWS, *rows.start() as u8, *rows.end() as u8], false);
}

/// Pixel `x` of a line: the high nibble is the left one.
fn put(line: &mut [u8; 64], x: usize, color: Gray4) {
    let shift = if x & 1 == 0 { 4 } else { 0 };
    if let Some(byte) = line.get_mut(x / 2) {
        *byte = *byte & !(15 << shift) | color.luma() << shift;
    }
}

impl OriginDimensions for Panel<'_> {
    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT)
    }
}

impl DrawTarget for Panel<'_> {
    type Color = Gray4;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            if let (Ok(x), Ok(y)) = (usize::try_from(at.x), usize::try_from(at.y))
                && let Some(line) = self.shadow.get_mut(y)
                && x < WIDTH as usize
            {
                put(line, x, color);
                window(&(x / 2..=x / 2), &(y..=y));
                send(line.get(x / 2..=x / 2).unwrap_or_default(), true);
            }
        }
        Ok(())
    }

    /// One window, each line sent as soon as it is complete.
    fn fill_contiguous<I: IntoIterator<Item = Gray4>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        let seen = area.intersection(&self.bounding_box());
        let Some(last) = seen.bottom_right() else { return Ok(()) };
        let (left, top) = (seen.top_left.x as usize, seen.top_left.y as usize);
        let (right, bottom) = (last.x as usize, last.y as usize);

        // Colors hidden before the first pixel seen, and between one line seen and the next.
        let hidden = seen.top_left - area.top_left;
        let mut skip = hidden.y as usize * area.size.width as usize + hidden.x as usize;
        let between = (area.size.width - seen.size.width) as usize;

        let columns = left / 2..=right / 2;
        window(&columns, &(top..=bottom));
        let mut colors = colors.into_iter();
        for line in self.shadow.iter_mut().take(bottom + 1).skip(top) {
            if skip > 0 {
                colors.nth(skip - 1);
            }
            for (x, color) in (left..=right).zip(&mut colors) {
                put(line, x, color);
            }
            send(line.get(columns.clone()).unwrap_or_default(), true);
            skip = between;
        }
        Ok(())
    }
}
