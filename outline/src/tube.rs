//! Where a fitted curve may pass: between a section's two parallels at the tolerance.

use crate::{
    certificate::NEAR_CORNER,
    section::{Place, Section},
};

/// The squared radius that a curve must not reach at a height.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    pub z: f64,
    pub f: f64,
}

/// A place at which one parallel or both are not followed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Apart {
    /// Its index.
    pub at: usize,
    /// The directions in which it is left outwards and inwards, both away from the axis.
    pub d: [[f64; 2]; 2],
}

/// What bounds curves near a section at some places of it.
pub(crate) struct Tube {
    /// Above and below which a curve's squared radius may not be: the points of the outer parallel and of the inner
    /// one, from the lowest up. Without those where a parallel is folded, as on the inner side of a bend sharper than
    /// the tolerance: they are nearer to another place of the section.
    pub bounds: [Vec<Bound>; 2],
    /// The places that have no such point on a side, or are left there in another direction than the normal.
    pub apart: Vec<Apart>,
}

impl Tube {
    pub fn new(section: &Section, places: &[Place], tolerance: f64) -> Self {
        let mut tube = Self { bounds: [Vec::new(), Vec::new()], apart: Vec::new() };
        for (at, place) in places.iter().enumerate() {
            let d = SIDES.map(|side| section.direction(place, side, NEAR_CORNER * tolerance));
            let mut is_whole = true;
            for (side, d) in [0, 1].into_iter().zip(d) {
                let sign = SIDES[side];
                let parts = if place.is_gapped(sign) { GAP } else { 1 };
                is_whole &= parts > 1 || d == place.normal;
                for part in 0..parts {
                    let [r, z] = match parts {
                        1 => place.normal,
                        _ => place.between(f64::from(part) / f64::from(parts - 1)),
                    };
                    let (r, z) = (place.r + sign * tolerance * r, place.z + sign * tolerance * z);
                    if is_folded(places, tolerance, r, z) {
                        is_whole = false;
                    } else if r > 0.0 {
                        tube.bounds[side].push(Bound { z, f: r * r });
                    }
                }
            }
            if !is_whole {
                tube.apart.push(Apart { at, d });
            }
        }
        for bounds in &mut tube.bounds {
            bounds.sort_by(|a, b| a.z.total_cmp(&b.z));
        }
        tube
    }

    /// The bounds of one kind within a stretch of heights.
    pub fn within(&self, side: usize, [low, high]: [f64; 2]) -> &[Bound] {
        let bounds = &self.bounds[side];
        &bounds
            [bounds.partition_point(|bound| bound.z < low)..bounds.partition_point(|bound| bound.z <= high)]
    }
}

/// The signs of outwards and inwards.
pub(crate) const SIDES: [f64; 2] = [1.0, -1.0];

/// At how many points of the circle about a corner that closes the gap in a parallel curves are bounded.
const GAP: u32 = 9;

/// Of the tolerance: a point as much nearer to the section than that is on a fold.
const FOLDED: f64 = 1e-3;

/// Whether a point is nearer to one of the places than the tolerance.
fn is_folded(places: &[Place], tolerance: f64, r: f64, z: f64) -> bool {
    let near = (1.0 - FOLDED) * tolerance;
    let from = places.partition_point(|place| place.z < z - near);
    let beside = places[from..].iter().take_while(|place| place.z < z + near);
    beside.into_iter().any(|place| (place.r - r).hypot(place.z - z) < near)
}
