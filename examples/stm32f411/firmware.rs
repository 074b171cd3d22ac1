//! The program: the display, then frame after frame, each one's time logged.

use crate::scenes;
use core::f32::consts::TAU;
use cortex_m_rt::entry;
use defmt::{info, unwrap};
use defmt_rtt as _;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_hal_bus::spi::ExclusiveDevice;
use embedded_lathe::{Pose, Rotation, Solid};
use mipidsi::{Builder, interface::SpiInterface, models::ST7789, options::ColorInversion};
use panic_probe as _;
use stm32f4xx_hal::{
    gpio::Speed,
    pac::{CorePeripherals, Peripherals},
    prelude::*,
    rcc::Config,
    spi::{Mode, Phase, Polarity, Spi},
};

/// Steps of a turn.
const FRAMES: u32 = 72;

#[entry]
fn main() -> ! {
    static mut BUFFER: [u8; 480] = [0; 480]; // a row of pixels on their way to the display

    let core = unwrap!(CorePeripherals::take());
    let chip = unwrap!(Peripherals::take());

    let mut rcc = chip.RCC.freeze(Config::hse(25.MHz()).sysclk(100.MHz()));
    let mut delay = chip.TIM5.delay_us(&mut rcc);
    let mut cycles = core.DWT;
    let mut trace = core.DCB;
    trace.enable_trace();
    cycles.enable_cycle_counter();

    let pins = chip.GPIOA.split(&mut rcc);
    let clock = pins.pa5.into_alternate().speed(Speed::VeryHigh);
    let data = pins.pa7.into_alternate().speed(Speed::VeryHigh);
    let select = pins.pa4.into_push_pull_output();
    let command = pins.pa3.into_push_pull_output();
    let reset = pins.pa2.into_push_pull_output();

    let mode = Mode { polarity: Polarity::IdleHigh, phase: Phase::CaptureOnSecondTransition };
    let bus = Spi::new(
        chip.SPI1,
        (Some(clock), None::<stm32f4xx_hal::gpio::Pin<'A', 6>>, Some(data)),
        mode,
        50.MHz(),
        &mut rcc,
    );
    let device = unwrap!(ExclusiveDevice::new_no_delay(bus, select).ok());
    let mut display = unwrap!(
        Builder::new(ST7789, SpiInterface::new(device, command, BUFFER))
            .display_size(240, 240)
            .invert_colors(ColorInversion::Inverted)
            .reset_pin(reset)
            .init(&mut delay)
            .ok()
    );
    unwrap!(display.clear(Rgb565::BLACK).ok());

    let mut row = [Rgb565::BLACK; 240];
    for n in (0..FRAMES).cycle() {
        let start = cycles.cyccnt.read();
        let solids = [unwrap!(leaning(n))];
        let scene = scenes::VASE_SCENE.with_solids(&solids);
        unwrap!(scene.draw_by_rows(&mut display, &mut row).ok());
        info!("frame {}: {} cycles", n, cycles.cyccnt.read().wrapping_sub(start));
    }
    unreachable!()
}

/// The vase, leaning, swung about the upright through its middle: spin about its own axis would not show.
fn leaning(n: u32) -> Option<Solid<'static>> {
    let turn = Rotation::about_x(0.5).then(Rotation::about_z(n as f32 * (TAU / FRAMES as f32)));
    let foot = turn.apply([0.0, 0.0, -0.5]);
    let pose = Pose::new([foot[0], foot[1], foot[2] + 0.5], turn, 1.0).ok()?;
    Some(Solid::new(&scenes::VASE, scenes::CLAY).posed(pose))
}
