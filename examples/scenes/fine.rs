//! The vase again, each segment cut into sixteen of the same shape: what do more segments cost?

use super::{CLAY, VASE_KNOTS, VASE_ORDINATES, VASE_SCENE};
use embedded_lathe::{End, Lathe, Profile, Scene, Segment, Solid, valid};

const CUTS: usize = 16;
const SEGMENTS: usize = CUTS * (VASE_KNOTS.len() - 1);

const KNOTS: [f32; SEGMENTS + 1] = {
    let mut knots = [VASE_KNOTS[0]; SEGMENTS + 1];
    let mut i = 1;
    while i <= SEGMENTS {
        let (segment, cut) = ((i - 1) / CUTS, (i - 1) % CUTS + 1);
        let (z, top) = (VASE_KNOTS[segment], VASE_KNOTS[segment + 1]);
        knots[i] = if cut == CUTS { top } else { z + (top - z) * (cut as f32 / CUTS as f32) };
        i += 1;
    }
    knots
};

/// De Casteljau's cuts, one after another, each the first of the parts that remain.
const ORDINATES: [f32; 3 * SEGMENTS + 1] = {
    let mut ordinates = [VASE_ORDINATES[0]; 3 * SEGMENTS + 1];
    let mut b = [0.0; 4];
    let mut i = 0;
    while i < SEGMENTS {
        let (segment, cut) = (i / CUTS, i % CUTS);
        if cut == 0 {
            let (_, from) = VASE_ORDINATES.split_at(3 * segment);
            b = [from[0], from[1], from[2], from[3]];
        }
        let u = 1.0 / (CUTS - cut) as f32;
        let (p, q, r) = (mix(b[0], b[1], u), mix(b[1], b[2], u), mix(b[2], b[3], u));
        let (s, t) = (mix(p, q, u), mix(q, r, u));
        let join = mix(s, t, u);
        [ordinates[3 * i + 1], ordinates[3 * i + 2], ordinates[3 * i + 3]] = [p, s, join];
        b = [join, t, r, b[3]];
        i += 1;
    }
    ordinates
};

const fn mix(a: f32, b: f32, u: f32) -> f32 {
    if u < 1.0 { a + (b - a) * u } else { b }
}

/// The vase in 64 segments.
pub static VASE: Lathe<[Segment; SEGMENTS]> =
    Lathe::turn(valid!(Profile::from_squared_radii(&KNOTS, &ORDINATES)).base(End::Capped));

/// In the vase's place.
pub static SCENE: Scene = VASE_SCENE.with_solids(&[Solid::new(&VASE, CLAY)]);
