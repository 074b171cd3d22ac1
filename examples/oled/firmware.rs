//! The program: all frames in turn, or up to the one asked for.

use crate::{bare::exit, host, panel::Panel, show};
use cortex_m::{Peripherals, delay::Delay};
use cortex_m_rt::entry;

core::arch::global_asm!(include_str!("memory.s"));

const CLOCK_HZ: u32 = 12_500_000;

#[entry]
fn main() -> ! {
    static mut SHADOW: [[u8; 64]; 64] = [[0; 64]; 64];
    let mut panel = Panel::new(SHADOW);

    let mut buffer = [0; 64];
    let mut words = host::arguments(&mut buffer);
    if let (Some(name), Some(last)) = (words.next(), words.next()) {
        for n in 0..=host::number(last) {
            if show::draw(name, n, &mut panel).is_none() {
                exit(false);
            }
        }
        host::say(b"drawn\n");
        loop {
            cortex_m::asm::wfi();
        }
    }

    host::say(show::TITLE);
    host::say(host::WHERE_TO_LOOK);
    if let Some(core) = Peripherals::take() {
        let mut delay = Delay::new(core.SYST, CLOCK_HZ);
        for name in show::NAMES {
            for n in 0..show::FRAMES {
                show::draw(name, n, &mut panel);
                delay.delay_ms(40);
            }
        }
    }
    exit(true)
}
