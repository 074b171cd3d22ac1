// BULB_GLASS, from bulb.svg, "glass": 4 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.450e-2 mm.
pub static BULB_GLASS: Solid = {
    static LATHE: Lathe<[Segment; 4]> =
        Lathe::turn(valid!(Profile::from_squared_radii(
            &[
                0.0, 9.7470875, 11.019718, 35.09761, 48.0,
            ],
            &[
                169.0, 162.37555, 248.25883, 385.46118, 403.37503, 432.1206, 449.71277, 782.5528,
                709.98285, 499.74094, 387.08063, 223.64142, 0.0,
            ],
        )));
    Solid::new(&LATHE, Rgb::new(0.85, 0.45, 0.3))
};
