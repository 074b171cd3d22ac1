// BULB_BASE, from bulb.svg, "base": 4 segments.
// Within 0.1 mm of the drawing; proven for these numbers: 9.448e-2 mm.
pub static BULB_BASE: Lathe<[Segment; 4]> =
    Lathe::turn(valid!(Profile::from_squared_radii(
        &[
            0.0, 0.0, 2.492326, 3.0, 4.0, 14.0, 14.0,
        ],
        &[
            0.0, 36.0, 36.0, 153.27846, 167.06503, 169.87329, 169.0, 169.0, 174.2, 179.52, 184.96,
            184.96, 184.96, 184.96, 169.0,
        ],
    )));
