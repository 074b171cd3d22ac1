// BOWL, from bowl.svg, "bowl": 10 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.440e-2 mm.
pub static BOWL_1: Lathe<[Segment; 5]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 3.0, 3.0, 10.052524, 34.766747, 36.0, 37.2, 37.2,
        ],
        &[
            0.0, 324.0, 324.0, 324.0, 324.0, 381.8756, 1094.8871, 1350.2034, 1628.716, 2604.71,
            2924.5107, 3005.5557, 3009.5999, 3022.4878, 3025.0, 3025.0, 3019.3054, 2919.124, 2869.756,
        ],
    )));
pub static BOWL_2: Lathe<[Segment; 5]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            7.0, 7.1044893, 8.184292, 25.490576, 36.0, 37.2,
        ],
        &[
            0.0, 0.0, 4.2053823, 8.839908, 56.733532, 158.25385, 239.60551, 1543.4506, 2114.7507,
            2438.6702, 2635.3735, 2732.0747, 2766.76, 2766.76, 2771.4946, 2869.756,
        ],
    )));
pub static BOWL: [Solid; 2] = [
    Solid::new(&BOWL_1, Rgb::new(0.85, 0.45, 0.3)),
    Solid::new(&BOWL_2, Rgb::new(0.85, 0.45, 0.3)),
];
