// WINE_GLASS, from wine-glass.svg, "glass": 14 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static WINE_GLASS: Solid = {
    const PROFILE_0: Profile<10> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 1.6, 5.509179, 10.0, 42.0, 49.333332, 55.898262, 60.0, 88.38464, 110.04413,
                110.60711,
            ],
            &[
                0.0, 900.0, 972.59155, 964.1796, 900.0, 80.6786, 92.08227, 55.200836, 12.831856,
                20.530159, 16.0, 10.311111, 8.658667, 11.56, 15.597279, 9.825959, 46.03874, 78.45706,
                175.7605, 312.59048, 398.08124, 493.96524, 576.0, 1032.8871, 1031.6498, 1002.18097,
                979.69415, 931.3632, 837.7054, 835.271, 822.10876, 800.89,
            ],
        ));
    const PROFILE_1: Profile<4> =
        valid!(Profile::from_squared_radii(
            &[
                53.6, 54.053555, 81.09369, 109.816055, 110.60711,
            ],
            &[
                0.0, 0.0, 14.041362, 25.613657, 715.53143, 871.7004, 908.59656, 947.7881, 832.2953,
                764.3166, 762.44434, 769.77783, 800.89,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 10]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 4]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
