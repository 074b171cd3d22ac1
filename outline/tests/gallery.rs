//! The drawings of `examples/outlines`: the numbers beside them are those that come out.

use embedded_lathe_outline::{
    Body, Fit, Origin, Outline, body, png,
    read::{self, Options},
    source,
};
use std::{fs, path::PathBuf};

/// File, path, name: in millimeters, within a tenth of one.
const GALLERY: [(&str, &str, &str); 11] = [
    ("wine-glass", "glass", "wine-glass"),
    ("bottle", "bottle", "bottle"),
    ("pawn", "pawn", "pawn"),
    ("queen", "queen", "queen"),
    ("bulb", "glass", "bulb-glass"),
    ("bulb", "base", "bulb-base"),
    ("bowl", "bowl", "bowl"),
    ("bell", "bell", "bell"),
    ("knob", "knob", "knob"),
    ("ring", "ring", "ring"),
    ("vase", "vase", "vase"),
];

const TOLERANCE: f64 = 0.1;

fn folder(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

fn made((file, path, name): (&str, &str, &str)) -> (Outline, Body, String) {
    let options = Options { name: Some(path.into()), ..Options::default() };
    let drawing = read::read(&folder(&format!("examples/outlines/{file}.svg")), &options).expect(file);
    let body = body(&drawing.outline, &Fit::within(TOLERANCE)).expect(file);
    let origin = Origin::named(name, format!("{file}.svg, {path:?}"), drawing.unit);
    let text = source(&body, &origin);
    (drawing.outline, body, text)
}

#[test]
fn numbers_beside_the_drawings_are_theirs() {
    for entry in GALLERY {
        let (_, body, text) = made(entry);
        let beside =
            fs::read_to_string(folder(&format!("examples/outlines/{}.rs", entry.2))).unwrap_or_default();
        assert!(
            body.error <= TOLERANCE && text == beside,
            "{}: `cargo test --test gallery -- --ignored` writes it anew",
            entry.2
        );
    }
}

#[test]
#[ignore = "writes examples/outlines/*.rs and docs/outlines/*.png"]
fn write() {
    fs::create_dir_all(folder("docs/outlines")).unwrap();
    for entry in GALLERY {
        let (outline, body, text) = made(entry);
        fs::write(folder(&format!("examples/outlines/{}.rs", entry.2)), text).unwrap();
        fs::write(folder(&format!("docs/outlines/{}.png", entry.2)), png(&body, &outline, 320).unwrap())
            .unwrap();
    }
}
