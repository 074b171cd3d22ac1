// BOWL, from bowl.svg, "bowl": 8 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static BOWL: Solid = {
    const PROFILE_0: Profile<5> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 3.0, 6.913614, 23.864643, 36.047577, 37.2,
            ],
            &[
                0.0, 324.0, 324.0, 324.0, 324.0, 877.44543, 1006.60706, 1207.1423, 2075.7202, 2441.5425,
                2704.7617, 2893.941, 3034.0571, 3014.9116, 3013.1006, 3050.8203, 2894.44,
            ],
        ));
    const PROFILE_1: Profile<3> =
        valid!(Profile::from_squared_radii(
            &[
                7.0, 8.1115, 36.185375, 37.2,
            ],
            &[
                0.0, 0.0, 135.45276, 219.28131, 2336.5935, 2610.7544, 2777.9612, 2784.0042, 2748.5518,
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
