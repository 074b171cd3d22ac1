// BOTTLE, from bottle.svg, "bottle": 9 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static BOTTLE: Solid = {
    const PROFILE_0: Profile<1> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 8.0,
            ],
            &[
                324.0, 180.0, 72.0, 0.0,
            ],
        ));
    const PROFILE_1: Profile<8> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 4.62, 66.0, 80.020805, 81.67316, 105.58, 118.0, 118.0, 124.0, 124.0, 128.0,
                128.0,
            ],
            &[
                324.0, 631.36487, 815.8336, 781.3135, 781.3135, 781.3135, 789.22504, 789.22504, 789.22504,
                664.2413, 460.92615, 436.96548, 402.0572, 379.30698, 50.148113, 101.87166, 101.87166,
                101.87166, 100.0, 100.0, 144.0, 144.0, 144.0, 144.0, 100.0, 100.0, 100.0, 100.0, 64.0,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 1]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 8]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::inner(&LATHE_0),
        Sheet::outer(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
