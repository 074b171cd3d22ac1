// RING, from ring.svg, "ring": 8 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 5.483e-2 mm.
pub static RING_1: Lathe<[Segment; 4]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 1.6940846, 6.0, 10.364419, 12.000368,
        ],
        &[
            1115.0929, 946.5747, 927.41425, 892.2389, 802.8324, 784.0, 784.0, 794.07544, 817.26544,
            907.8523, 941.8076, 960.3792, 1114.8302,
        ],
    )));
pub static RING_2: Lathe<[Segment; 4]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 2.5791845, 9.419098, 12.0, 12.0, 12.000368, 12.000368,
        ],
        &[
            1115.0929, 1199.7026, 1366.8911, 1373.3358, 1398.2389, 1464.2811, 1464.2734, 1398.2887,
            1373.3906, 1367.3633, 1199.3685, 1156.0, 1155.3022, 1155.0013, 1151.8221, 1114.8302,
        ],
    )));
pub static RING: [Solid; 2] = [
    Solid::new(&RING_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&RING_2, Rgb::new(0.85, 0.45, 0.3)),
];
