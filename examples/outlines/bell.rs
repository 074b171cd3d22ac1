// BELL, from bell.svg, "bell": 12 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.466e-2 mm.
pub static BELL_1: Lathe<[Segment; 5]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 10.092076, 28.0, 40.563652, 45.30441, 46.0,
        ],
        &[
            1444.0, 1188.3341, 1076.0317, 992.84186, 845.2252, 807.87726, 784.0, 752.73047, 709.19147,
            511.7269, 437.2158, 371.46332, 126.09098, 90.08855, 75.123825, 0.0,
        ],
    )));
pub static BELL_2: Lathe<[Segment; 5]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 16.610338, 41.630974, 50.0, 50.0, 53.59829, 56.0, 56.0,
        ],
        &[
            1444.0, 1936.0, 1570.5725, 1281.8116, 1157.4707, 970.1724, 1098.9607, 797.7924, 697.0561,
            599.4825, 126.65768, 100.0, 100.0, 102.75098, 97.841255, 94.56422, 90.86368, 56.08206,
            41.940403,
        ],
    )));
pub static BELL_3: Lathe<[Segment; 2]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            49.4, 49.4, 53.63364, 56.0,
        ],
        &[
            0.0, 16.0, 16.0, 14.501897, 17.079636, 18.520443, 17.200191, 41.940403,
        ],
    )));
pub static BELL: [Solid; 3] = [
    Solid::new(&BELL_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&BELL_2, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&BELL_3, Rgb::new(0.85, 0.45, 0.3)),
];
