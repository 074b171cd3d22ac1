// BOTTLE, from bottle.svg, "bottle": 10 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 7.686e-2 mm.
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
            0.0, 0.0, 1.6616383, 4.0, 66.0, 75.90126, 82.21644, 103.78, 118.0, 118.0, 124.0, 124.0,
            128.0, 128.0,
        ],
        &[
            324.0, 609.14136, 732.5602, 736.63715, 753.66425, 777.6259, 786.1575, 786.1575, 786.1575,
            781.4469, 781.4469, 781.4469, 739.68414, 624.546, 551.10913, 444.3529, 359.7965, 71.07359,
            101.0687, 101.0687, 101.0687, 100.0, 100.0, 144.0, 144.0, 144.0, 144.0, 100.0, 100.0,
            100.0, 100.0, 64.0,
        ],
    )));
pub static BOTTLE: [Solid; 2] = [
    Solid::new(&BOTTLE_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&BOTTLE_2, Rgb::new(0.85, 0.45, 0.3)),
];
