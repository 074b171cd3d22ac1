//! Any bytes as a drawing, a table or a form: no panic, and what is accepted is proven to be within the tolerance.
//!
//! The first byte chooses the kind and the tolerance. Of outlines that are read only small ones are fitted, with few places
//! for knots: the time goes with the square of both.
#![no_main]

use embedded_lathe_outline::{Fit, body, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|input: (u8, &str)| {
    let (choice, text) = input;
    let options = read::Options { unit: read::Unit::from_name("mm"), straight: choice & 4 > 0, ..Default::default() };
    let drawing = match choice & 3 {
        0 => read::svg(text, &options),
        // Path data alone: most of what an SVG's other bytes may be is the parser's.
        1 => {
            let data = text.replace(['"', '<', '&'], "");
            read::svg(&format!("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"{data}\"/></svg>"), &options)
        }
        2 => read::table(text, &options),
        _ => read::json(text, &options),
    };
    let Ok(drawing) = drawing else { return };
    if drawing.outline.pieces().len() > 40 {
        return;
    }
    let size = drawing.outline.size();
    let tolerance = size * [1e-1, 1e-2, 1e-3][usize::from(choice >> 3) % 3];
    let fit = Fit { places: 40, ..Fit::within(tolerance) };
    if let Ok(body) = body(&drawing.outline, &fit) {
        assert!(body.error <= tolerance, "{} {tolerance}", body.error);
        assert!(body.segments() > 0 || !body.warnings.is_empty());
    }
});
