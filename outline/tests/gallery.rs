//! The drawings of `examples/outlines`: the numbers beside them are those that come out, and compile.

use embedded_lathe::{Lathe, Solid};
use embedded_lathe_outline::{
    Body, Fit, Origin, Outline, body, png,
    read::{self, Options},
    source,
};
use std::{fs, path::PathBuf};

/// File, path, name: in millimeters, within a tenth of one.
const GALLERY: [(&str, &str, &str); 10] = [
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

/// As whoever pastes them has them: errors would stop the compilation.
mod pasted {
    macro_rules! pasted {
        ($($name:ident $file:literal),*) => {
            $(pub mod $name {
                #[allow(unused_imports)]
                use embedded_lathe::{Lathe, Profile, Rgb, Segment, Solid, valid};
                include!(concat!("../../examples/outlines/", $file));
            })*
        };
    }
    pasted!(
        wine_glass "wine-glass.rs", bottle "bottle.rs", pawn "pawn.rs", queen "queen.rs", bulb_glass "bulb-glass.rs",
        bulb_base "bulb-base.rs", bowl "bowl.rs", bell "bell.rs", knob "knob.rs", ring "ring.rs"
    );
}

#[test]
fn what_is_pasted_is_as_large_as_the_drawing() {
    assert_eq!(pasted::knob::KNOB.len(), 2);
    let [outside, inside] = &pasted::wine_glass::WINE_GLASS;
    assert!((outside.lathe().largest_radius() - 31.86).abs() < 0.2 && inside.lathe().largest_radius() < 31.5);
    assert_eq!(pasted::bottle::BOTTLE[1].lathe().heights(), [0.0, 128.0]);
    let several: [&[Solid]; 3] = [&pasted::ring::RING, &pasted::bell::BELL, &pasted::bowl::BOWL];
    let one: [&Lathe; 4] = [
        &pasted::pawn::PAWN,
        &pasted::bulb_glass::BULB_GLASS,
        &pasted::bulb_base::BULB_BASE,
        pasted::queen::QUEEN[0].lathe(),
    ];
    let all = several.into_iter().flatten().map(Solid::lathe).chain(one);
    assert_eq!(all.filter(|lathe| lathe.segments() > 0).count(), 11);
}
