//! A *shell*: a body of one outer sheet and hollows within it, such as a cup or a ring. Seen from outside,
//! its sheets do not hide one another.

use crate::lathe::Lathe;
use crate::sheet::Sheet;

/// How a hollow ends in relation to the outer sheet.
enum Join {
    /// It is closed, clear of the outer sheet's end.
    Closed,
    /// Both end in the same circle, with a ring of either between their walls.
    Ring,
    /// Both walls end in the same circle.
    Edge,
}

/// Whether sheets are proven to be a shell: the first an outer one, all others inner ones, its hollows. A
/// hollow is narrower than the outer sheet at all heights. At each end it is closed, clear of the ends of the
/// outer sheet and of other hollows, or it ends where the outer sheet does, in the same circle. At each end
/// of the outer sheet that is not closed, one hollow ends in the latter way.
///
/// Then the sheets close the material off. Of a ray that begins beyond all of them the first crossing, if any,
/// enters the material: there the ray enters the outer sheet, or it leaves a hollow, into which it came by an
/// open end. And of the first crossings with each sheet, no other one is of that kind. For where a ray comes
/// into a hollow by an open end, it passes the plane of that end, which is the outer sheet's as well: before,
/// it was beyond all sheets, and now it is within the outer sheet, which it next leaves. The open end of
/// another hollow would be the outer sheet's other end, whose plane this ray passes only outwards.
pub(crate) const fn is_shell(sheets: &[Sheet]) -> bool {
    let [outer, hollows @ ..] = sheets else { return false };
    if outer.is_inner() || hollows.is_empty() {
        return false;
    }
    let outer = outer.lathe();
    let mut is_closed = [outer.rim(false).beyond == 0.0, outer.rim(true).beyond == 0.0];
    let mut i = 0;
    while i < hollows.len() {
        let hollow = hollows[i].lathe();
        let (Some(lower), Some(upper)) = (join(hollow, outer, false), join(hollow, outer, true)) else {
            return false;
        };
        let edges = [matches!(lower, Join::Edge), matches!(upper, Join::Edge)];
        if !hollows[i].is_inner() || !hollow.is_within(outer, edges) {
            return false;
        }
        let mut other = 0;
        while other < i {
            if !is_apart(hollow, hollows[other].lathe()) {
                return false;
            }
            other += 1;
        }
        is_closed[0] |= !matches!(lower, Join::Closed);
        is_closed[1] |= !matches!(upper, Join::Closed);
        i += 1;
    }
    is_closed[0] && is_closed[1]
}

/// How a hollow's upper end, or its lower one, is joined to that end of the outer sheet; `None` if in no way
/// of [`Join`].
const fn join(hollow: &Lathe, outer: &Lathe, is_upper: bool) -> Option<Join> {
    let (own, other) = (hollow.rim(is_upper), outer.rim(is_upper));
    let gap = if is_upper { other.z - own.z } else { own.z - other.z };
    if own.beyond == 0.0 && gap > outer.clearance() {
        Some(Join::Closed)
    } else if gap != 0.0 || own.beyond != other.beyond || own.wall > own.beyond || other.beyond > other.wall {
        None
    } else if own.wall == other.wall {
        Some(Join::Edge)
    } else {
        Some(Join::Ring)
    }
}

/// Whether two hollows are at different heights, clear of one another.
const fn is_apart(one: &Lathe, other: &Lathe) -> bool {
    let clearance = one.clearance().max(other.clearance());
    one.rim(false).z - other.rim(true).z > clearance || other.rim(false).z - one.rim(true).z > clearance
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::lathe::Segment;
    use crate::profile::Profile;
    use std::vec::Vec;

    type Outline<'a> = (&'a [f32], &'a [f32]);

    /// The outer sheet of a cup with a base, and with a ring for its rim.
    const CUP: Outline = (&[0.0, 0.0, 1.0, 1.0], &[0.0, 0.2, 0.3, 0.3, 0.25, 0.2]);
    /// Its hollow.
    const HOLLOW: Outline = (&[0.1, 0.1, 1.0], &[0.0, 0.1, 0.2, 0.2, 0.2]);
    /// The outer side of a ring, up to an edge at each end.
    const RING: Outline = (&[0.0, 0.4, 1.0], &[0.3, 0.5, 0.6, 0.6, 0.6, 0.6, 0.3]);

    /// Whether sheets are a shell, given the knots and squared radii of each; the first is the outer one.
    fn is_shell_of(outlines: &[Outline]) -> bool {
        let profiles =
            outlines.iter().map(|(knots, squares)| Profile::<2>::from_squared_radii(knots, squares));
        let profiles: Vec<_> = profiles.map(Result::unwrap).collect();
        let lathes = profiles.iter().map(|profile| Lathe::turn_beside(*profile, &profiles[0]));
        let lathes: Vec<Lathe<[Segment; 2]>> = lathes.collect();
        let sheets = lathes.iter().enumerate().map(|(number, lathe)| match number {
            0 => Sheet::outer(lathe),
            _ => Sheet::inner(lathe),
        });
        is_shell(&sheets.collect::<Vec<_>>())
    }

    #[test]
    fn cups_and_rings_are_shells() {
        assert!(is_shell_of(&[CUP, HOLLOW]));
        let by_the_hollow = (&[0.1, 0.1, 1.0, 1.0][..], &[0.0, 0.1, 0.2, 0.2, 0.2, 0.25][..]);
        assert!(is_shell_of(&[(CUP.0.split_at(3).0, &[0.0, 0.2, 0.3, 0.3, 0.25]), by_the_hollow]));
        assert!(is_shell_of(&[RING, (&[0.0, 0.5, 1.0], &[0.3, 0.1, 0.1, 0.1, 0.1, 0.1, 0.3])]));
        // With a second hollow, in the foot.
        let foot = (&[0.0, 0.05][..], &[0.15, 0.1, 0.05, 0.0][..]);
        let ground = (CUP.0, &[0.15, 0.2, 0.3, 0.3, 0.25, 0.2][..]);
        assert!(is_shell_of(&[ground, HOLLOW, foot]) && is_shell_of(&[ground, foot, HOLLOW]));
        // A hollow that no ray gets into.
        assert!(is_shell_of(&[(&[0.0, 1.0], &[0.0, 0.5, 0.5, 0.0]), (&[0.3, 0.6], &[0.0, 0.1, 0.1, 0.0])]));
    }

    #[test]
    fn other_bodies_are_not_shells() {
        assert!(!is_shell_of(&[CUP]) && !is_shell_of(&[HOLLOW, CUP]));
        // A gap in the rim, in height and in radius.
        assert!(!is_shell_of(&[CUP, (&[0.1, 0.1, 0.9], HOLLOW.1)]));
        assert!(!is_shell_of(&[CUP, (HOLLOW.0, &[0.0, 0.1, 0.2, 0.2, 0.19])]));
        // No rim, and a hollow without a bottom.
        assert!(!is_shell_of(&[(&[0.0, 0.0, 1.0], &[0.0, 0.2, 0.3, 0.3, 0.25]), HOLLOW]));
        assert!(!is_shell_of(&[CUP, (&[0.1, 1.0], &[0.1, 0.2, 0.2, 0.2])]));
        // An end of the outer sheet that is open, though a hollow is joined to the other.
        let foot = (&[0.0, 0.05][..], &[0.15, 0.1, 0.05, 0.0][..]);
        assert!(!is_shell_of(&[(&[0.0, 0.0, 1.0], &[0.15, 0.2, 0.3, 0.3, 0.25]), foot]));
        // A hollow that comes through the wall, through the base, and up to it.
        assert!(!is_shell_of(&[CUP, (HOLLOW.0, &[0.0, 0.1, 0.5, 0.5, 0.2])]));
        assert!(!is_shell_of(&[CUP, (&[-0.1, -0.1, 1.0], HOLLOW.1)]));
        assert!(!is_shell_of(&[CUP, (&[0.0, 0.0, 1.0], HOLLOW.1)]));
        // Where the wall is cut by a step, and the hollow is too wide only below it, or just at it.
        let stepped: Outline = (&[0.0, 0.0, 0.5, 0.5, 1.0], &[0.0, 0.1, 0.1, 0.1, 0.1, 0.3, 0.3, 0.3, 0.3]);
        assert!(!is_shell_of(&[stepped, (&[0.4, 0.4, 1.0], &[0.0, 0.2, 0.2, 0.25, 0.3])]));
        assert!(!is_shell_of(&[stepped, (&[0.5, 0.5, 1.0], &[0.0, 0.2, 0.2, 0.25, 0.3])]));
        assert!(is_shell_of(&[stepped, (&[0.51, 0.51, 1.0], &[0.0, 0.2, 0.2, 0.25, 0.3])]));
        // An edge at which the walls do not part.
        assert!(!is_shell_of(&[RING, (&[0.0, 0.5, 1.0], &[0.3, 0.1, 0.1, 0.1, 0.1, 0.6, 0.3])]));
        // Rings that cover each other: of the hollow inwards, of the outer sheet outwards.
        assert!(!is_shell_of(&[CUP, (&[0.1, 0.1, 1.0, 1.0], &[0.0, 0.1, 0.2, 0.2, 0.22, 0.2])]));
        let flange = (CUP.0, &[0.0, 0.2, 0.3, 0.3, 0.25, 0.28][..]);
        assert!(!is_shell_of(&[flange, (&[0.1, 0.1, 1.0, 1.0], &[0.0, 0.1, 0.2, 0.2, 0.2, 0.28])]));
        // Two hollows at one height.
        assert!(!is_shell_of(&[CUP, HOLLOW, (&[0.5, 0.6], &[0.0, 0.05, 0.05, 0.0])]));
    }
}
