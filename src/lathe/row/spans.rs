//! From span to span: what the next pixels see. The cheapest test comes first.

use super::certify::Certification;
use super::skip::Probe;
use super::sweep::{NEWTON_STEPS, RETRY, Span, Start, Sweep, TrackEnd, WORK};
use crate::hit::{Hit, Part};
use core::ptr;

impl Sweep<'_> {
    /// The span that begins with the i-th pixel; i must be less than [`Sweep::len`]. A tracked root is tried
    /// first, then a cap or a ring, then pixels that miss. If the i-th pixel belongs to none of these, the
    /// span is [`Span::Single`].
    ///
    /// The next i is the `to` of the span, or, of a tracked one, what [`Sweep::track`] returned, or, after a
    /// single ray, i + 1. This function begins to track roots, certifies them, and ends tracking.
    #[inline(always)]
    pub fn next(&mut self, i: u32) -> Span {
        match self.root.end.take() {
            // The root may have jumped: a probe of this pixel may find it at its new place.
            Some(TrackEnd::Diverged) => self.root.is_tracked = false,
            Some(TrackEnd::Limit) | None => {}
            Some(end) => self.resume(i, end),
        }
        loop {
            if self.root.is_tracked {
                let to = self.limit(i);
                if to > i {
                    return Span::Tracked { to };
                }
                self.resume(i, TrackEnd::Limit);
                continue;
            }
            if !self.bounds.is_usable || self.root.is_spent(i) {
                return Span::Single;
            }
            if let Some(span) = self.flat_span(i) {
                return span;
            }
            if self.root.probed == i {
                self.root.spend(RETRY);
                return Span::Single;
            }
            if let Probe::Misses { to } = self.search(i) {
                return Span::Empty { to };
            }
        }
    }

    /// Probes the i-th ray, with no root tracked, and returns what the probe found. If the ray may meet the
    /// solid, this begins to track a root there, or notes the plane of a cap or a ring in `root.plane`. The
    /// i-th ray will not be probed again.
    #[inline(never)]
    fn search(&mut self, i: u32) -> Probe {
        self.root.probed = i;
        self.root.spend(WORK);
        // The left half begins with the place that the last probe of the right half left in `start`, without
        // a probe of its own. Most often that is where the right half began to track a root.
        let probe = match self.root.start {
            Some(start) if i == 0 => Probe::MayMeet(start),
            _ => self.probe(i),
        };
        if let Probe::MayMeet(start) = probe {
            self.root.start = Some(start);
            self.root.begin(self.bounds.numbers, start);
            self.root.tries = NEWTON_STEPS;
        }
        probe
    }

    /// Continues where tracking ended before the i-th pixel, for the reason `end`, unless Newton's method
    /// diverged:
    ///
    /// - at the certificate's `until`, where its proof was how fast the ray approaches the axis, which no more
    ///   is fast enough, or where the root moved into the neighbouring segment: the root is
    ///   certified again, in the segment where it is now. If it is the nearest, it is tracked with the new
    ///   certificate. If another root may be nearer, that one is tracked, and if a plane may be, it is noted
    ///   in `root.plane`. If neither is certain, or if `root.tries` is used up, this is the last case;
    /// - where the root left its segment at a step or at the solid's end: no root is tracked, and the plane
    ///   there is noted in `root.plane`. At the solid's end the i-th pixel is not to be probed;
    /// - where the root is uncertified: no root is tracked, and the i-th pixel is not to be probed, since a
    ///   probe would find the same root again.
    #[inline(never)]
    fn resume(&mut self, i: u32, end: TrackEnd) {
        let root = &mut self.root;
        let segments = self.bounds.lathe.segments;
        let index = match end {
            TrackEnd::Limit => root.index,
            TrackEnd::Left { upper } => {
                let index = root.index.wrapping_add(if upper { 1 } else { usize::MAX });
                let next = segments.get(index);
                if next.is_none_or(|next| next.end(!upper) != root.segment.end(upper)) {
                    // The end of the solid, or a step.
                    if next.is_none() {
                        root.probed = i;
                    }
                    let plane = root.index + usize::from(upper);
                    root.begin(self.bounds.numbers, Start { index: plane, s: 0.0, sign: 0.0 });
                    return;
                }
                index
            }
            TrackEnd::Uncertified if root.certificate.bump.is_nan() => root.index,
            TrackEnd::Uncertified | TrackEnd::Diverged => usize::MAX,
        };
        root.tries -= 1;
        root.spend(WORK);
        if root.tries > 0
            && !root.is_spent(i)
            && let Some(segment) = segments.get(index)
        {
            root.index = index;
            if !ptr::eq(root.segment, segment) {
                (root.segment, root.own) = (segment, self.bounds.in_segment(segment));
            }
            match self.certify(i) {
                Certification::Nearest(certificate) => {
                    self.root.certificate = certificate;
                    return;
                }
                Certification::Another(start) => {
                    self.root.begin(self.bounds.numbers, start);
                    return;
                }
                Certification::Undecided => {}
            }
        }
        (self.root.is_tracked, self.root.probed) = (false, i);
    }

    /// To be called with the hit of a single ray, cast for the i-th pixel or for its mirror image. If it is
    /// on the wall, and the bounds are of use, this begins to track a root there, unless too many single rays
    /// have done so in vain; and the next pixel is not probed for a miss: its ray most likely hits as well.
    pub fn found(&mut self, i: u32, hit: &Hit) {
        if hit.part == Part::Wall && self.bounds.is_usable {
            let s = hit.t * self.bounds.unit - self.bounds.shift;
            self.root.probed = i + 1;
            if self.root.is_spent(i) {
                return;
            }
            let sign = if hit.enters { 1.0 } else { -1.0 };
            self.root.begin(self.bounds.numbers, Start { index: hit.segment, s, sign });
            self.root.tries = NEWTON_STEPS;
        }
    }
}
