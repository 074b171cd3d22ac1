// PAWN, from pawn.svg, "pawn": 5 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
// Mind: a turn at height 41.08000002367358, between the radii 0.00000 and 0.00062, straightened (off by 2.367e-8).
pub static PAWN: Solid = {
    static LATHE: Lathe<[Segment; 5]> =
        Lathe::turn(valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 6.8, 15.754943, 24.0, 24.0, 27.0, 27.0, 41.08, 41.08,
            ],
            &[
                0.0, 324.0, 304.59933, 380.60416, 225.0, 85.49717, 77.897644, 61.60098, 46.596203,
                40.122528, 36.0, 97.59746, 124.99471, 138.77007, 92.51358, 27.04, 89.45677, 69.805046,
                3.7877712e-7, 0.0,
            ],
        )));
    Solid::new(&LATHE, Rgb::new(0.85, 0.45, 0.3))
};
