// BOTTLE, from bottle.svg, "bottle": 10 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 7.755e-2 mm.
pub static BOTTLE_1: Lathe<[Segment; 1]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 8.0,
        ],
        &[
            324.0, 180.0, 72.0, 0.0,
        ],
    )));
pub static BOTTLE_2: Lathe<[Segment; 9]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 2.4188585, 8.066328, 66.0, 78.124504, 82.216576, 103.78, 118.0, 118.0, 124.0,
            124.0, 128.0, 128.0,
        ],
        &[
            324.0, 616.1486, 759.50415, 756.84436, 769.81934, 800.113, 780.9574, 780.9574, 780.9574,
            786.9975, 786.9975, 786.9975, 704.7662, 537.4402, 480.96692, 414.59222, 359.8015,
            71.078415, 101.072365, 101.072365, 101.072365, 100.0, 100.0, 144.0, 144.0, 144.0, 144.0,
            100.0, 100.0, 100.0, 100.0, 64.0,
        ],
    )));
pub static BOTTLE: [Solid; 2] = [
    Solid::new(&BOTTLE_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&BOTTLE_2, Rgb::new(0.85, 0.45, 0.3)),
];
