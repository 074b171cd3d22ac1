// QUEEN, from queen.svg, "queen": 12 segments in 3 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.584e-2 mm.
// Mind: a turn at height 79.74578098865013, between the radii 0.00000 and 0.53935, straightened (off by 4.578e-2).
pub static QUEEN: Solid = {
    const PROFILE_0: Profile<9> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 4.0, 6.357648, 15.194965, 32.667133, 54.0, 54.0, 56.903614, 60.0, 60.0,
                72.723366, 74.0,
            ],
            &[
                0.0, 484.0, 484.0, 484.0, 484.0, 449.42117, 401.28857, 399.62057, 393.3683, 291.79062,
                220.86986, 80.65319, 90.838844, 76.25917, 58.45792, 49.0, 49.0, 144.0, 137.88512,
                156.17593, 134.45197, 111.28574, 121.0, 121.0, 64.0, 59.923412, 108.310684, 174.16483,
                180.77248, 190.04237, 196.0,
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
                72.0, 74.5, 74.5, 79.74578, 79.74578,
            ],
            &[
                81.0, 66.0, 50.73652, 9.000001, 9.0, 17.722683, 16.58154, 0.29090244, 0.0,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 9]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 1]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static LATHE_2: Lathe<[Segment; 2]> = Lathe::turn_beside(PROFILE_2, &PROFILE_0);
    static SHEETS: [Sheet; 3] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
        Sheet::outer(&LATHE_2),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
