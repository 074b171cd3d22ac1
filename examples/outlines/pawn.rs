// PAWN, from pawn.svg, "pawn": 6 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
// Mind: a turn at height 41.08000002367358, between the radii 0.00000 and 0.00062, straightened (off by 2.367e-8).
pub static PAWN: Solid = {
    static LATHE: Lathe<[Segment; 6]> =
        Lathe::turn(valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 6.205124, 8.430838, 15.61189, 24.0, 24.0, 27.0, 27.0, 41.08, 41.08,
            ],
            &[
                0.0, 324.0, 314.82767, 362.9046, 260.18393, 223.33908, 180.13332, 157.61263, 84.95177,
                75.76741, 62.352535, 46.68276, 40.194054, 36.0, 98.26236, 126.692505, 134.72682, 95.83766,
                27.04, 84.1177, 75.10806, 3.787771e-7, 0.0,
            ],
        )));
    Solid::new(&LATHE, Rgb::new(0.85, 0.45, 0.3))
};
