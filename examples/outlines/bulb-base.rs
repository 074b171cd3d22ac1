// BULB_BASE, from bulb.svg, "base": 3 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.346e-2 mm.
pub static BULB_BASE: Solid = {
    static LATHE: Lathe<[Segment; 3]> =
        Lathe::turn(valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 1.0362222, 4.0, 14.0, 14.0,
            ],
            &[
                0.0, 36.0, 36.0, 56.018345, 86.72397, 174.54745, 168.83705, 184.96, 184.96, 184.96,
                184.96, 169.0,
            ],
        )));
    Solid::new(&LATHE, Rgb::new(0.85, 0.45, 0.3))
};
