//! On which side of a plane a lathe lies: with this, the rows and columns of a picture that cannot show it
//! are found.

use super::Lathe;
use super::frame::{EndPlane, View};
use super::segment::Segment;
use crate::math::UNIT_ROUNDOFF;
use crate::math::minmax::greater;
use crate::profile::Extremes;
use crate::vector::{F32x3, dot, one_norm, to_one, vector};

/// By how much the plane must clear the surface, as a share of the distance between the plane's point and the
/// farthest point of the solid.
///
/// Then no ray in the plane, cast from that point, hits the solid. In units of 2⁻²⁴ of the distance: by the
/// crate's promise a ray misses if it clears the silhouette by 4 units; the ray's direction is rounded by 12
/// units (7 in the picture, 5 when it is turned), and its origin by 5; the plane's normal, a product of two
/// turned vectors, is rounded by 15 units and its distance by 5. That is 41; the value leaves room for half
/// as much again.
const MARGIN: f32 = 64.0 * UNIT_ROUNDOFF;

/// By how much `w² − a²·f` must exceed zero, relative to the sum of the largest magnitudes of the two terms:
/// an upper bound of its rounding errors. 4 units of 2⁻²⁴ come from w², 3 from a²·f, 1 from the difference,
/// and 8 from the search for the least value ([`Extremes`]).
const ROUNDING: f32 = 16.0 * UNIT_ROUNDOFF;

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// Whether the whole surface is proven to lie behind the plane through `point`, on the side that `normal`
    /// points away from, so that no ray in that plane that starts at `point` hits it. `rough` is a length by
    /// which the point itself may be wrong, in units of 2⁻²⁴. All is in object space.
    ///
    /// At the height z the surface is an ellipse with the squared half-axes f/k and f. The product nx·x +
    /// ny·y with the normal n is at most `a·√f` on it, with a² = nx²/k + ny². The plane meets that height
    /// where the same product is w = n·point − nz·z, which is linear in z. So the surface is behind the plane
    /// where w > 0 and w² − a²·f > 0: in each segment a cubic in u, and one number at each of the two ends.
    ///
    /// False if a number overflows or is NaN, and always for an endless sheet (k = 0).
    #[inline(never)]
    pub(crate) fn is_behind(&self, normal: F32x3, point: F32x3, rough: f32) -> bool {
        let View { frame, segments } = self.view();
        let Some((n, _)) = to_one(normal) else {
            return false;
        };
        // In lengths of the frame, x not scaled by √k.
        let point = (point - vector([0.0, 0.0, frame.middle])) * frame.scale;
        let distance = one_norm(point) + rough * frame.scale + frame.size / frame.root_squash;
        let ahead = dot(n, point) - MARGIN * one_norm(n) * distance;
        // The same normal in the frame, where the solid is round.
        let stretched = n.x / frame.root_squash;
        // The ball around the solid may be behind the plane. Far solids need this: their w² overflows.
        if ahead > (stretched.abs() + n.y.abs() + n.z.abs()) * frame.size {
            return true;
        }
        let across = stretched * stretched + n.y * n.y;
        let at = |z: f32| ahead - n.z * z;
        let is_end_behind = |end: &EndPlane, z: f32| {
            let (w, f) = (at(z), greater(end.wall, end.beyond));
            w > 0.0 && w * w - across * f > ROUNDING * (w * w + across * f)
        };
        is_end_behind(&frame.base, frame.low)
            && is_end_behind(&frame.top, frame.high)
            && segments
                .iter()
                .all(|segment| is_segment_behind(segment, at(segment.low), at(segment.high), across))
    }
}

/// Whether w > 0 and `w² > a²·f` are proven all along a segment. `low` and `high` are w at its lower and its
/// upper knot, and `across` is a²: see [`Lathe::is_behind`].
fn is_segment_behind(segment: &Segment, low: f32, high: f32, across: f32) -> bool {
    let (first, mixed, last) = (low * low, low * high, high * high);
    let squares = [first, (first + 2.0 * mixed) / 3.0, (2.0 * mixed + last) / 3.0, last];
    let [b0, b1, b2, b3] = segment.b;
    let largest = greater(greater(b0, b1), greater(b2, b3));
    let rounding = ROUNDING * (greater(first, last) + across * largest);
    let [s0, s1, s2, s3] = squares;
    let g = [s0 - across * b0, s1 - across * b1, s2 - across * b2, s3 - across * b3];
    low > 0.0
        && high > 0.0
        && g[0] > rounding
        && g[3] > rounding
        && (g[1] > rounding && g[2] > rounding || Extremes::of(g).least > rounding)
}
