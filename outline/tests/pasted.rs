//! The numbers beside the drawings of `examples/outlines`, as whoever pastes them has them: they compile, and what is
//! drawn of them has the drawing's silhouette.

mod measure;

use embedded_lathe::Solid;
use embedded_lathe_outline::read::{self, Options};
use std::path::Path;

/// In millimeters, as their comments say.
const TOLERANCE: f64 = 0.1;

macro_rules! pasted {
    ($($name:ident $file:literal),*) => {
        $(mod $name {
            use embedded_lathe::{Lathe, Profile, Rgb, Segment, Solid, valid};
            #[allow(unused_imports)] // of those with one sheet
            use embedded_lathe::Sheet;
            include!(concat!("../../examples/outlines/", $file));
        })*
    };
}

pasted!(
    wine_glass "wine-glass.rs", bottle "bottle.rs", pawn "pawn.rs", queen "queen.rs", bulb_glass "bulb-glass.rs",
    bulb_base "bulb-base.rs", bowl "bowl.rs", bell "bell.rs", knob "knob.rs", ring "ring.rs", vase "vase.rs"
);

/// File, path, and the solid with its number of sheets.
const SOLIDS: [(&str, &str, &Solid, usize); 11] = [
    ("wine-glass", "glass", &wine_glass::WINE_GLASS, 2),
    ("bottle", "bottle", &bottle::BOTTLE, 2),
    ("pawn", "pawn", &pawn::PAWN, 1),
    ("queen", "queen", &queen::QUEEN, 3),
    ("bulb", "glass", &bulb_glass::BULB_GLASS, 1),
    ("bulb", "base", &bulb_base::BULB_BASE, 1),
    ("bowl", "bowl", &bowl::BOWL, 2),
    ("bell", "bell", &bell::BELL, 3),
    ("knob", "knob", &knob::KNOB, 2),
    ("ring", "ring", &ring::RING, 2),
    ("vase", "vase", &vase::VASE, 2),
];

#[test]
fn each_is_one_solid_with_the_silhouette_of_its_drawing() {
    for (file, path, solid, sheets) in SOLIDS {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../examples/outlines/{file}.svg"));
        let options = Options { name: Some(path.into()), ..Options::default() };
        let outline = read::read(&file, &options).expect(path).outline;
        assert_eq!(solid.sheets().count(), sheets, "{path}");
        let [inside, beside] = measure::silhouette(solid, &outline, TOLERANCE, path);
        assert!(inside > 2000 && beside > 2000, "{path}: {inside} pixels show it, {beside} do not");
    }
}
