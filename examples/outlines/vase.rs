// VASE, from vase.svg, "vase": 16 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static VASE: Solid = {
    const PROFILE_0: Profile<9> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 5.1459084, 10.5093155, 27.359365, 42.553936, 52.871803, 70.898445, 78.97878,
                85.0, 86.5,
            ],
            &[
                0.0, 248.08685, 338.1207, 308.10587, 286.22766, 263.4247, 228.28654, 217.36649, 183.05928,
                265.22333, 446.4717, 609.9129, 788.6276, 830.04443, 858.1685, 849.7442, 779.02637,
                655.4732, 258.51685, 149.83391, 101.11742, 87.40874, 108.21488, 123.71898, 178.08636,
                240.25, 219.58333, 200.25, 182.25,
            ],
        ));
    const PROFILE_1: Profile<7> =
        valid!(Profile::from_squared_radii(
            &[
                4.5, 4.5, 18.192326, 30.890125, 45.138805, 59.91761, 63.158733, 78.137634, 86.5,
            ],
            &[
                0.0, 49.0, 183.13696, 127.76716, 157.70734, 185.47284, 275.44403, 401.86215, 543.7207,
                670.3349, 679.984, 689.99207, 574.7583, 379.58405, 336.78058, 288.44644, 249.9406,
                71.985214, 42.24112, 55.75378, 63.29758, 103.25724, 182.25,
            ],
        ));
    static LATHE_0: Lathe<[Segment; 9]> = Lathe::turn(PROFILE_0);
    static LATHE_1: Lathe<[Segment; 7]> = Lathe::turn_beside(PROFILE_1, &PROFILE_0);
    static SHEETS: [Sheet; 2] = [
        Sheet::outer(&LATHE_0),
        Sheet::inner(&LATHE_1),
    ];
    valid!(Solid::body(&SHEETS, Rgb::new(0.85, 0.45, 0.3)))
};
