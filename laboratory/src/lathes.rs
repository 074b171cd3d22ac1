//! The outlines under test as the kernel takes them.

use crate::cases::Outline;
use embedded_lathe::{End, Lathe, Profile, Segment};

/// The most segments an outline has.
pub const SEGMENTS: usize = 16;
/// What all hits of one need at most.
pub const CAPACITY: usize = 3 * SEGMENTS + 2;

pub fn lathe(outline: &Outline) -> Lathe<[Segment; SEGMENTS]> {
    let end = |closed| if closed { End::Capped } else { End::Open };
    let profile = Profile::from_squared_radii(&outline.knots, &outline.ordinates)
        .and_then(|profile| profile.squash(outline.k))
        .expect(outline.name);
    Lathe::turn(profile.base(end(outline.base_closed)).top(end(outline.top_closed)))
}
