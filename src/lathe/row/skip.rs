//! Spans of misses: an upper bound of g along one ray, and the number of neighbours for which it still proves
//! a miss. The bound is computed in the row's [`arithmetic`](crate::arithmetic).

// One of the two is not used.
#[allow(dead_code)]
mod floats;
#[allow(dead_code)]
mod integers;

use super::sweep::{Start, Sweep};
use crate::arithmetic::Numbers;
use crate::lathe::frame::Frame;

/// By what part of itself |dz| may fall, at most, within the pixels that one probe certifies: to 7/8.
///
/// The value is a choice: it keeps `n/(1 − n·ε)`, see [`Sweep::below_zero`], near n.
const FALL: f32 = 1.0 / 8.0;

/// The types in which an arithmetic has a ray of a row, and a distance along it.
pub(super) trait Probing {
    /// A ray of the row.
    type Path<'a>;
    /// A distance along it.
    type Distance;
}

/// A ray of a row.
pub(super) type Path<'a> = <Numbers as Probing>::Path<'a>;

/// A distance s along a ray of a row.
pub(super) type Distance = <Numbers as Probing>::Distance;

/// What a probe finds of one ray.
pub(super) enum Probe {
    /// The ray misses the solid, and so do those of the next pixels, to before pixel `to`.
    Misses { to: u32 },
    /// The ray may meet the solid, near this place if anywhere.
    MayMeet(Start),
}

/// Where sign·g may be above zero, if an upper bound of it is not below zero.
pub(super) struct Above {
    /// Whether the bound is so near to zero that sign·g may stay below zero: less than the tolerance above
    /// it, in the last segment in which it is above.
    pub is_near: bool,
    /// About where sign·g crosses zero, in the first segment where sign·g may come to within the tolerance of
    /// zero. The start's own sign is 1 where sign·g rises through zero along the ray, −1 where it falls.
    /// It is a plane if sign·g jumps over zero there. `None` if sign·g stays below zero by the tolerance in
    /// every segment, or if it is above zero where the part begins and falls through zero nowhere in it.
    pub start: Option<Start>,
}

impl Sweep<'_> {
    /// The i-th ray.
    // Not inline: it is rarely called.
    #[inline(never)]
    pub(super) fn path(&self, i: u32) -> Path<'_> {
        self.bounds.numbers.path(self, &self.direction.numbers, i)
    }

    /// Decides by the segments' cubics whether the i-th ray misses the solid by more than the tolerance, and
    /// how many of the next rays do.
    pub(super) fn probe(&self, i: u32) -> Probe {
        let (bounds, numbers) = (&self.bounds, self.bounds.numbers);
        let path = self.path(i);
        // A ray that runs level in the plane of an end or of a step may meet the rim, where g has a jump.
        if numbers.is_in_edge(self, &path) {
            return Probe::MayMeet(Start { index: usize::MAX, s: 0.0, sign: 0.0 });
        }
        if let Some(n) = numbers.beside(self, &path) {
            return Probe::Misses { to: (i + 1).saturating_add(n) };
        }
        let Frame { len, ref base, ref top, .. } = *bounds.lathe.frame;
        let (exit, end) = if path.rises() { (len, top) } else { (0, base) };
        let interval = self.interval(&path);
        let start = match self.below_zero(i, &path, 1.0, interval, exit) {
            Ok(to) => return Probe::Misses { to },
            Err(above) => above.start,
        };
        // No crossing is known in any segment: the ray may leave the solid through the far end, without
        // meeting it if that end is open.
        if start.is_none()
            && end.beyond > 0.0
            && self.may_begin_inside(&path, interval)
            && let Ok(to) = self.below_zero(i, &path, -1.0, interval, exit)
        {
            return Probe::Misses { to };
        }
        Probe::MayMeet(start.unwrap_or(Start { index: exit, s: 0.0, sign: 0.0 }))
    }

    /// Whether a ray, and the next ones for which a probe of it holds, may be inside the solid from the begin
    /// of the ray's [interval](Sweep::interval) on, without having met it: because it begins inside, or has come
    /// in through an open end. At a cap it would have met the cap.
    pub(super) fn may_begin_inside(&self, path: &Path, interval: (Distance, Distance)) -> bool {
        let Frame { ref base, ref top, .. } = *self.bounds.lathe.frame;
        let entry = if path.rises() { base } else { top };
        entry.beyond > 0.0 || interval.0 <= self.bounds.numbers.start(self, path)
    }

    /// Whether sign·g stays below zero by more than the tolerance on an interval of the i-th ray. If so, the
    /// first pixel after it for which that is not certified; if not, or if it is not certain, where it may be
    /// above zero, as an error. On an interval that ends before it begins sign·g is below zero.
    ///
    /// Where the interval begins on the plane of an end, or ends on the plane of the knot `last`, sign·g must
    /// be below zero on both sides of the plane. If no knot has the number `last`, sign·g is tested only on
    /// the near side of the interval's end.
    ///
    /// For the next pixels, take one height. The point P where a ray has that height moves, as the pixel's
    /// number grows, along the line in which the row's plane meets that height, and always the same way. At
    /// P, g is F less the square of P's distance from the axis, and F is the same for all pixels, as the
    /// height is. If v is the motion of P from one pixel to the next, n pixels on g has changed by
    /// `−2·n·⟨P, v⟩ − n²·v²`. The largest values of both terms over the interval are those of two quadratics
    /// in s. If dz falls by the part ε of itself from pixel to pixel, a point moves in n pixels by
    /// `v·n/(1 − n·ε)`.
    #[inline(never)]
    pub(super) fn below_zero(
        &self,
        i: u32,
        path: &Path,
        sign: f32,
        interval: (Distance, Distance),
        last: usize,
    ) -> Result<u32, Above> {
        let numbers = self.bounds.numbers;
        let margin = numbers.upper_bound(self, path, sign, interval, last)?;
        let start = numbers.start(self, path);
        if interval == (start, start) && self.direction.rays.apart != 0.0 {
            // The interval is the one point where all rays begin, since they are not parallel: so sign·g is the
            // same for all of them.
            return Ok(u32::MAX);
        }
        Ok((i + 1).saturating_add(numbers.certified_run(self, i, path, sign, margin, interval)))
    }

    /// An interval of s along a ray. It contains the point of this ray at every height at which this ray, or
    /// any of the next rays that a probe of this ray certifies, can meet the solid. If there is no such
    /// height, it is empty: its end comes before its begin. It begins where the rays begin, if that is later and
    /// at one height for all of them; if their heights vary, it begins before that.
    pub(super) fn interval(&self, path: &Path) -> (Distance, Distance) {
        self.bounds.numbers.interval(self, path)
    }
}
