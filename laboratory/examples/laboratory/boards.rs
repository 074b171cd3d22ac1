//! Frames a second on some boards, computed from the record, a core's clock and the speed of its bus.

use crate::csv::{CYCLES, INSTRUCTIONS, recorded};
use std::error::Error;
use std::fmt::Write;

struct Board {
    name: &'static str,
    core: &'static str,
    /// Clocks of the core and of the bus to the display, in MHz: the fastest that the data sheets allow.
    clock: f64,
    bus: f64,
    /// What the record counts for such a core.
    machine: &'static str,
    /// What is appended there to the names of scenes of 240×240 pixels.
    large: &'static str,
    column: usize,
}

const BOARDS: [Board; 5] = [
    Board { name: "STM32F405", core: "Cortex-M4F", clock: 168.0, bus: 42.0, ..FPU },
    Board { name: "nRF52840", core: "Cortex-M4F", clock: 64.0, bus: 32.0, ..FPU },
    Board { name: "RP2350", core: "Cortex-M33 with FPU", clock: 150.0, bus: 75.0, ..FPU },
    Board { name: "RP2040", core: "Cortex-M0+", clock: 133.0, bus: 62.5, ..SOFT },
    Board { name: "ESP32-C3", core: "rv32imc", clock: 160.0, bus: 80.0, machine: "rv32imc", ..SOFT },
];

const FPU: Board =
    Board { name: "", core: "", clock: 0.0, bus: 0.0, machine: "m4f", large: "", column: CYCLES };
const SOFT: Board = Board { machine: "m0", large: " 240x240", column: INSTRUCTIONS, ..FPU };

const SCENES: [&str; 3] = ["vase", "tilted vase", "bowl"];

/// Pixels of a frame, and bits of one.
const PIXELS: f64 = 240.0 * 240.0;
const BITS: f64 = 16.0;

impl Board {
    /// Frames a second: one row is computed while another is sent, so that the slower of both counts.
    fn frames(&self, scene: &str) -> Result<f64, Box<dyn Error>> {
        let computed = recorded(self.machine, &format!("{scene}{}", self.large), self.column)? / self.clock;
        let sent = BITS / self.bus;
        Ok(1e6 / (PIXELS * computed.max(sent)))
    }
}

pub fn table() -> Result<String, Box<dyn Error>> {
    let mut text =
        "| board | core, MHz | bus, MHz | vase | tilted vase | bowl | the bus allows |\n".to_owned();
    text.push_str("|---|---|--:|--:|--:|--:|--:|\n");
    for board in &BOARDS {
        let Board { name, core, clock, bus, .. } = board;
        write!(text, "| {name} | {core}, {clock} | {bus} |")?;
        for scene in SCENES {
            let about = if board.column == CYCLES { "" } else { "< " };
            write!(text, " {about}{:.1} |", board.frames(scene)?)?;
        }
        writeln!(text, " {:.1} |", 1e6 / (PIXELS * BITS / bus))?;
    }
    Ok(text)
}
