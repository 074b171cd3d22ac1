// QUEEN, from queen.svg, "queen": 11 segments in 3 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
// Mind: a turn at height 79.74578098865013, between the radii 0.00000 and 0.53935, straightened (off by 4.578e-2).
pub static QUEEN: Solid = {
    const PROFILE_0: Profile<8> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 4.0, 6.5309606, 15.39162, 32.667473, 54.0, 54.0, 57.357273, 60.0, 60.0, 74.0,
            ],
            &[
                0.0, 484.0, 484.0, 484.0, 484.0, 446.87924, 399.91208, 397.24133, 387.89127, 288.0825,
                217.79042, 80.7402, 90.7201, 76.30035, 58.494576, 49.0, 49.0, 144.0, 148.9491, 146.5275,
                127.71825, 112.91226, 121.28408, 121.0, 64.0, 56.108837, 121.35783, 196.0,
            ],
        ));
    const PROFILE_1: Profile<1> =
        valid!(Profile::from_squared_radii(
            &[
                72.0, 74.0,
            ],
            &[
                81.0, 111.0, 149.33333, 196.0,
            ],
        ));
    const PROFILE_2: Profile<2> =
        valid!(Profile::from_squared_radii(
            &[
                72.0, 74.5, 79.74578, 79.74578,
            ],
            &[
                81.0, 67.93869, 42.836063, 9.0, 18.917448, 15.374716, 0.29090244, 0.0,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 8]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 1]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static LATHE_2: Lathe<[Segment; 2]> = Lathe::turn_beside(PROFILE_2, &PROFILE_0);
    static SHEETS: [Sheet; 3] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
        Sheet::outer(&LATHE_2),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
