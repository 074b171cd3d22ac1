//! The program: a whole turn, or as many steps as are asked for.

use crate::{
    bare::exit,
    host,
    panel::Panel,
    show::{STEPS, Screen},
};
use cortex_m::{Peripherals, delay::Delay};
use cortex_m_rt::entry;

core::arch::global_asm!(include_str!("../oled/memory.s"));

const CLOCK_HZ: u32 = 12_500_000;

#[entry]
fn main() -> ! {
    static mut SHADOW: [[u8; 64]; 64] = [[0; 64]; 64];
    let mut panel = Panel::new(SHADOW);
    let mut screen = Screen::new();

    let mut buffer = [0; 64];
    let mut words = host::arguments(&mut buffer);
    if let (Some(_), Some(last)) = (words.next(), words.next()) {
        for n in 0..=host::number(last) {
            if screen.draw(n, &mut panel).is_none() {
                exit(false);
            }
        }
        host::say(b"drawn\n");
        loop {
            cortex_m::asm::wfi();
        }
    }

    host::say(b"A knob turns on the board's panel, 128 by 64 pixels in 16 grays; its pointer alone is drawn again.\n");
    host::say(host::WHERE_TO_LOOK);
    if let Some(core) = Peripherals::take() {
        let mut delay = Delay::new(core.SYST, CLOCK_HZ);
        for n in 0..=2 * STEPS {
            screen.draw(n, &mut panel);
            delay.delay_ms(80);
        }
    }
    exit(true)
}
