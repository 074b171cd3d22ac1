// RING, from ring.svg, "ring": 7 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static RING: Solid = {
    const PROFILE_0: Profile<3> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 5.1003256, 10.694348, 12.000368,
            ],
            &[
                1085.8853, 805.5923, 807.85895, 793.1019, 776.91656, 793.9604, 936.0882, 969.2704,
                978.8326, 1151.8221,
            ],
        ));
    const PROFILE_1: Profile<4> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 5.5090165, 11.083276, 12.0, 12.000368,
            ],
            &[
                1085.8853, 1215.2572, 1458.1914, 1430.9741, 1436.2339, 1441.5559, 1464.0061, 1315.012,
                1290.5089, 1271.3324, 1156.0, 1154.6057, 1153.2164, 1151.8221,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 3]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 4]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::inner(&LATHE_0),
        Sheet::outer(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
