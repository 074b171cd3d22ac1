// QUEEN, from queen.svg, "queen": 13 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.306e-2 mm.
// Mind: a turn at height 79.74578098865013, between the radii 0.00000 and 0.53935, straightened (off by 4.578e-2).
pub static QUEEN_1: Lathe<[Segment; 10]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 4.0, 6.0, 17.425983, 24.0, 54.0, 54.0, 56.607212, 58.373684, 60.0, 60.0,
            68.66937, 74.0,
        ],
        &[
            0.0, 484.0, 484.0, 484.0, 484.0, 454.66666, 426.66666, 400.0, 400.0, 248.00244, 175.10431,
            133.16187, 110.956696, 100.0, 66.666664, 49.0, 49.0, 144.0, 144.0, 151.59402, 137.55989,
            128.05128, 120.5821, 120.5821, 120.5821, 121.0, 121.0, 64.0, 64.0, 78.85631, 116.00738,
            138.85083, 171.12373, 196.0,
        ],
    )));
pub static QUEEN_2: Lathe<[Segment; 1]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            72.0, 74.0,
        ],
        &[
            81.0, 111.0, 149.33333, 196.0,
        ],
    )));
pub static QUEEN_3: Lathe<[Segment; 2]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            72.0, 74.5, 74.5, 79.74578, 79.74578,
        ],
        &[
            81.0, 66.0, 46.992107, 12.064456, 9.0, 17.722683, 15.452577, 1.1608627, 0.0,
        ],
    )));
pub static QUEEN: [Solid; 3] = [
    Solid::new(&QUEEN_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&QUEEN_2, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&QUEEN_3, Rgb::new(0.85, 0.45, 0.3)),
];
