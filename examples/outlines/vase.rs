// VASE, from vase.svg, "vase": 16 segments in 2 sheets.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static VASE: Solid = {
    const PROFILE_0: Profile<9> =
        valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 4.869545, 11.13178, 27.818794, 42.547928, 54.01653, 71.26301, 77.87553, 85.0,
                86.5,
            ],
            &[
                0.0, 247.61871, 334.82108, 308.31418, 289.66537, 265.683, 218.66592, 211.67468, 193.0451,
                276.6649, 458.84018, 619.6409, 792.27814, 832.4852, 863.7919, 841.2257, 747.69995,
                607.05585, 236.78253, 142.11125, 105.81308, 94.51962, 101.32525, 108.65778, 161.587,
                240.25, 219.58333, 200.25, 182.25,
            ],
        ));
    const PROFILE_1: Profile<7> =
        valid!(Profile::from_squared_radii(
            &[
                4.5, 4.5, 11.941778, 22.234375, 43.488174, 59.380474, 62.842663, 76.94196, 86.5,
            ],
            &[
                0.0, 49.0, 126.395164, 135.38225, 140.70064, 148.05638, 152.89777, 201.28516, 301.20316,
                629.54333, 673.1422, 705.7428, 608.6307, 400.6473, 355.33746, 298.6407, 256.931, 87.07394,
                50.77794, 51.991318, 52.813873, 92.509026, 182.25,
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
