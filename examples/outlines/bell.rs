// BELL, from bell.svg, "bell": 9 segments in 3 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static BELL: Solid = {
    const PROFILE_0: Profile<3> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 21.913948, 40.329777, 46.0,
            ],
            &[
                1444.0, 938.48395, 877.6792, 821.42206, 774.1452, 800.1621, 521.4488, 435.6331, 374.2163,
                0.0,
            ],
        ));
    const PROFILE_1: Profile<4> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 27.575146, 44.442513, 50.0, 56.0, 56.0,
            ],
            &[
                1444.0, 1936.0, 1268.9337, 1065.8579, 1020.05695, 992.0411, 978.8048, 672.5117, 571.5938,
                498.04703, 100.0, 92.89032, 126.29446, 56.604755, 49.0,
            ],
        ));
    const PROFILE_2: Profile<2> =
        valid!(Profile::from_squared_radii(
            &[
                49.4, 49.4, 54.822845, 56.0,
            ],
            &[
                0.0, 16.0, 19.601103, 8.644108, 22.426933, 25.418816, 25.082636, 49.0,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 3]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 4]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static LATHE_2: Lathe<[Segment; 2]> = Lathe::turn_beside(PROFILE_2, &PROFILE_0);
    static SHEETS: [Sheet; 3] = [
        Sheet::inner(&LATHE_0),
        Sheet::outer(&LATHE_1),
        Sheet::inner(&LATHE_2),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
