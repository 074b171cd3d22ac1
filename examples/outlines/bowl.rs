// BOWL, from bowl.svg, "bowl": 8 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static BOWL: Solid = {
    const PROFILE_0: Profile<5> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 3.0, 8.0172205, 28.207525, 36.119987, 37.2,
            ],
            &[
                0.0, 324.0, 324.0, 324.0, 324.0, 989.77985, 1135.7506, 1367.7424, 2301.3245, 2663.8345,
                2872.369, 2954.0923, 3045.6262, 3014.046, 3009.7354, 3004.4207, 2894.44,
            ],
        ));
    const PROFILE_1: Profile<3> =
        valid!(Profile::from_squared_radii(
            &[
                7.0, 8.170855, 36.193188, 37.2,
            ],
            &[
                0.0, 0.0, 144.46204, 232.70668, 2344.686, 2603.811, 2778.3586, 2784.6301, 2791.9153,
                2894.44,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 5]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 3]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
