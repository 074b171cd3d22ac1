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
                0.0, 0.0, 4.0, 66.0, 79.760185, 81.67489, 105.58, 118.0, 118.0, 124.0, 124.0, 128.0,
                128.0,
            ],
            &[
                324.0, 629.6574, 796.2309, 784.0, 784.0, 784.0, 789.09125, 789.09125, 789.09125,
                671.43646, 472.11392, 444.37857, 405.7352, 379.3706, 50.20799, 101.82359, 101.82359,
                101.82359, 100.0, 100.0, 144.0, 144.0, 144.0, 144.0, 100.0, 100.0, 100.0, 100.0, 64.0,
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
