//! The outlines under test as the kernel takes them.

use crate::cases::Outline;
use embedded_lathe::{End, Lathe, Profile, Segment};

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
