// PAWN, from pawn.svg, "pawn": 8 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.125e-2 mm.
// Mind: a turn at height 41.08000002367358, between the radii 0.00000 and 0.00062, straightened (off by 2.367e-8).
pub static PAWN: Lathe<[Segment; 8]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 3.0, 5.9973936, 6.8, 11.947785, 23.696926, 24.0, 24.0, 27.0, 27.0, 41.08, 41.08,
        ],
        &[
            0.0, 324.0, 324.0, 324.0, 324.0, 323.34207, 313.28973, 273.156, 262.4095, 256.10703,
            225.0, 128.47903, 113.10601, 92.60576, 45.81664, 43.136986, 36.986153, 36.82749,
            36.151535, 36.0, 98.17196, 129.37318, 129.44505, 98.13864, 27.04, 84.1177, 75.10541,
            3.7877714e-7, 0.0,
        ],
    )));
