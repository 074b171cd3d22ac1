// KNOB, from knob.svg, "knob": 4 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static KNOB: Solid = {
    const PROFILE_0: Profile<3> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 4.0, 4.0, 16.56618, 20.0, 20.0,
            ],
            &[
                0.0, 576.0, 576.0, 576.0, 576.0, 324.0, 311.10458, 341.10123, 319.17996, 313.18976,
                319.18268, 205.5655, 36.0,
            ],
        ));
    const PROFILE_1: Profile<1> =
        valid!(Profile::from_squared_radii(
            &[
                18.8, 20.0,
            ],
            &[
                0.0, 13.555179, 11.770419, 36.0,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 3]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 1]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
