// BULB_GLASS, from bulb.svg, "glass": 4 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.648e-2 mm.
pub static BULB_GLASS: Lathe<[Segment; 4]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 6.1643023, 11.0200405, 35.098217, 48.0,
        ],
        &[
            169.0, 169.0, 188.97641, 250.50232, 298.96744, 382.5767, 449.6988, 782.53754, 710.0415,
            499.78735, 387.1271, 223.6309, 0.0,
        ],
    )));
