//! Two row buffers: one is sent to the display while the next row is computed into the other.
//!
//! ```text
//! cargo run --example two_rows
//! ```
//!
//! Here the DMA is a thread. On a board it is the HAL's: a transfer takes the SPI and a `&'static mut` buffer, and gives both
//! back. With Embassy, `join(spi.write(sent), async { picture.bytes_of_row(0, y, computed) })` does the same.

mod bus;
mod frame;
#[allow(dead_code)]
#[path = "../scenes/mod.rs"]
mod scenes;

use bus::Bus;
use frame::Frame;

const WIDTH: usize = 240;

fn main() {
    // On a board: two `StaticCell`s.
    let [mut sent, mut computed] = [(); 2].map(|()| &mut *Box::leak(Box::new([0; 2 * WIDTH])));
    let mut bus = Bus::new();
    let mut frame = Frame::new(scenes::STILL_LIFE.picture(WIDTH as u32, WIDTH as u32));
    let mut is_row = frame.next_row(sent);
    while is_row {
        bus.start(sent);
        // While that row is on its way. Here the frame could be left, and taken up again after other work.
        is_row = frame.next_row(computed);
        sent = bus.finish();
        std::mem::swap(&mut sent, &mut computed);
    }
    println!("{} bytes arrived", bus.close().len());
}
