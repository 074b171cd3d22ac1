//! The outlines under test as the kernel takes them.

use crate::cases::Outline;
use crate::oracle::{self, Band};
use embedded_lathe::{End, Hit, Lathe, Part, Profile, Segment};

/// The most segments an outline has.
pub const SEGMENTS: usize = 16;
/// What all hits of one need at most.
pub const CAPACITY: usize = 4 * SEGMENTS + 1;

pub fn lathe(outline: &Outline) -> Lathe<[Segment; SEGMENTS]> {
    let profile = Profile::from_squared_radii(&outline.knots, &outline.ordinates)
        .and_then(|profile| profile.squash(outline.k))
        .expect(outline.name);
    Lathe::turn(ended(profile, outline))
}

/// A profile whose ends are capped where those of an outline are.
pub fn ended<const N: usize>(profile: Profile<N>, outline: &Outline) -> Profile<N> {
    let profile = if outline.base_closed { profile.base(End::Capped) } else { profile };
    if outline.top_closed { profile.top(End::Capped) } else { profile }
}

/// The crate's name for a part of the oracle's.
pub fn part(part: oracle::Part) -> Part {
    match part {
        oracle::Part::Wall => Part::Wall,
        oracle::Part::Base => Part::Base,
        oracle::Part::Top => Part::Top,
        oracle::Part::Ring => Part::Ring,
    }
}

/// Whether a hit is the crossing that the oracle's band is about: of the same part, in the same direction, within it.
pub fn is_in(hit: &Hit, band: &Band) -> bool {
    hit.enters == band.enters && hit.part == part(band.part) && band.holds(hit.t)
}
