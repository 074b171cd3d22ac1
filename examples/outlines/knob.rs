// KNOB, from knob.svg, "knob": 4 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 7.062e-2 mm.
pub static KNOB_1: Lathe<[Segment; 3]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 4.0, 4.0, 16.236664, 20.0, 20.0,
        ],
        &[
            0.0, 576.0, 576.0, 576.0, 576.0, 324.0, 324.0, 330.09833, 321.28003, 318.568, 312.296,
            216.53773, 30.864271,
        ],
    )));
pub static KNOB_2: Lathe<[Segment; 1]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            18.8, 20.0,
        ],
        &[
            0.0, 16.00001, 11.694146, 30.864271,
        ],
    )));
pub static KNOB: [Solid; 2] = [
    Solid::new(&KNOB_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&KNOB_2, Rgb::new(0.85, 0.45, 0.3)),
];
