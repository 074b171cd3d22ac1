// WINE_GLASS, from wine-glass.svg, "glass": 15 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static WINE_GLASS: Solid = {
    const PROFILE_0: Profile<11> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 1.6, 4.990992, 8.518121, 14.8076105, 42.0, 48.836964, 55.1827, 60.0, 87.52302,
                110.03478, 110.60711,
            ],
            &[
                0.0, 919.79517, 943.7055, 982.0503, 900.0, 124.91611, 123.69114, 75.03095, 24.417227,
                24.029997, 19.727371, 12.055038, 15.297483, 14.415897, 10.60439, 9.094557, 11.56,
                14.225492, 11.572082, 39.355766, 65.143234, 140.48042, 268.6377, 365.9269, 479.65402,
                576.0, 1021.8793, 1028.1823, 1004.775, 985.62964, 932.4951, 835.2922, 832.821, 846.69604,
                800.89,
            ],
        ));
    const PROFILE_1: Profile<4> =
        valid!(Profile::from_squared_radii(
            &[
                53.6, 54.053555, 86.1488, 109.8215, 110.60711,
            ],
            &[
                0.0, 0.0, 14.041362, 25.613657, 844.5106, 916.99084, 911.36365, 907.21313, 822.77637,
                766.663, 764.80084, 749.07855, 800.89,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 11]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 4]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
