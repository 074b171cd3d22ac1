// BELL, from bell.svg, "bell": 11 segments in 3 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static BELL: Solid = {
    const PROFILE_0: Profile<4> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 18.5625, 38.953667, 45.042904, 46.0,
            ],
            &[
                1444.0, 1001.1345, 915.2888, 849.176, 776.5502, 825.3505, 577.60443, 503.6222, 442.02386,
                159.97649, 115.644745, 103.36638, 0.0,
            ],
        ));
    const PROFILE_1: Profile<5> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 27.993532, 44.23774, 49.361397, 50.0, 56.0, 56.0,
            ],
            &[
                1444.0, 1936.0, 1253.5792, 1060.75, 1018.2138, 993.53076, 969.35443, 683.6681, 593.5585,
                518.9667, 221.25809, 184.15225, 168.11768, 100.0, 94.90427, 121.74688, 59.32547, 49.0,
            ],
        ));
    const PROFILE_2: Profile<2> =
        valid!(Profile::from_squared_radii(
            &[
                49.4, 49.4, 54.571957, 56.0,
            ],
            &[
                0.0, 16.0, 18.038292, 10.642292, 20.72093, 23.503773, 19.323784, 49.0,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 4]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 5]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static LATHE_2: Lathe<[Segment; 2]> = Lathe::turn_beside(PROFILE_2, &PROFILE_0);
    static SHEETS: [Sheet; 3] = [
        Sheet::inner(&LATHE_0),
        Sheet::outer(&LATHE_1),
        Sheet::inner(&LATHE_2),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
