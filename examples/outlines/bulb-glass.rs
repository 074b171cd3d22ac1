// BULB_GLASS, from bulb.svg, "glass": 4 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.700e-2 mm.
pub static BULB_GLASS: Solid = {
    static LATHE: Lathe<[Segment; 4]> =
        Lathe::turn(valid!(Profile::from_squared_radii(
            &[
                0.0, 9.590152, 19.303808, 35.998356, 48.0,
            ],
            &[
                169.0, 157.10135, 248.79875, 384.0619, 521.06696, 633.3696, 663.76886, 716.015, 631.0085,
                475.211, 363.2088, 208.0285, 0.0,
            ],
        )));
    Solid::new(&LATHE, Rgb::new(0.85, 0.45, 0.3))
};
