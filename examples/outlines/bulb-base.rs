// BULB_BASE, from bulb.svg, "base": 3 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.574e-2 mm.
pub static BULB_BASE: Solid = {
    static LATHE: Lathe<[Segment; 3]> =
        Lathe::turn(valid!(Profile::from_squared_radii(
            &[
                0.0, 0.0, 0.9615817, 4.0, 14.0, 14.0,
            ],
            &[
                0.0, 36.0, 32.94256, 55.531162, 83.97228, 173.84091, 168.431, 184.96, 184.96, 184.96,
                184.96, 169.0,
            ],
        )));
    Solid::new(&LATHE, Rgb::new(0.85, 0.45, 0.3))
};
