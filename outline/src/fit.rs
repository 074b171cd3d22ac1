//! The least number of segments that follow a section within a tolerance.
//!
//! Knots may lie at some places of the section, and at each of these on the section itself or on its two
//! parallels at nearly the tolerance, with the section's own tangent: three kinds of knot a place. (A segment
//! on exact ends is off by up to M·h⁴/384, M the largest fourth derivative of r² over height, all of it to one
//! side; moved by half of that it is off by half as much.) A knot at a corner or at an end stays where it is.
//! Beside a level tip r² goes with the root of the height, as no cubic does: there the last segment passes through
//! the section at two heights, and ends where it will. A step takes the rest.
//!
//! A search by breadth over all pairs of knots finds the fewest segments whose error at sampled places is within
//! the tolerance: first all knots that one segment reaches, then those that two reach. (A longer segment may do
//! where a shorter one does not, so that always taking the longest would not be enough.) Then the knots
//! between move, each in turn, as long as that makes the larger error of its two segments smaller.

use crate::{
    section::{Place, SAMPLES, Section},
    segment::{Cubic, Knot, Segment},
};

/// The segments for a section.
#[derive(Clone, Debug)]
pub(crate) struct Fitted {
    pub segments: Vec<Segment>,
    /// Whether a step leads from the segments to the section's end, below and above.
    pub steps: [bool; 2],
}

/// Offsets of knots from the section, in tolerances.
const OFFSETS: [f64; 3] = [0.0, MOST_OFFSET, -MOST_OFFSET];

const MOST_OFFSET: f64 = 0.95;

/// Where the segment beside a level tip meets the section: distances from the tip, in heights of the segment. The
/// first few meet it at the tip itself, and need no step.
const MEETINGS: [[f64; 2]; 7] =
    [[0.4, 0.0], [0.2, 0.0], [0.08, 0.0], [0.35, 0.04], [0.25, 0.015], [0.5, 0.1], [0.2, 0.005]];

/// How many of them.
const WITHOUT_STEP: usize = 3;

/// How far a segment may end beyond its step's end, squared, in squared tolerances. It adds to the error.
const OVERSHOOT: f64 = 1e-4;

/// At how many places a segment is compared with the section.
const COMPARED: usize = 16;

/// Where a segment may begin or end.
#[derive(Clone, Copy, Debug)]
enum Anchor {
    /// At s, so many tolerances away from the section.
    Knot { s: f64, offset: f64, knot: Knot },
    /// At a level tip, meeting the section as [`MEETINGS`] says.
    Tip { s: f64, z: f64, meeting: [f64; 2] },
}

impl Anchor {
    fn s(&self) -> f64 {
        match self {
            Self::Knot { s, .. } | Self::Tip { s, .. } => *s,
        }
    }

    fn z(&self) -> f64 {
        match self {
            Self::Knot { knot, .. } => knot.z,
            Self::Tip { z, .. } => *z,
        }
    }

    fn is_tip(&self) -> bool {
        matches!(self, Self::Tip { .. })
    }

    fn has_step(&self) -> bool {
        matches!(self, Self::Tip { meeting: [_, last], .. } if *last > 0.0)
    }
}

/// The fewest segments within `tolerance` of a section, with knots at some `count` places, or `None` if there
/// are none.
pub(crate) fn fewest(section: &Section, tolerance: f64, count: usize) -> Option<Fitted> {
    if let Some(segments) = exact(section) {
        return Some(Fitted { segments, steps: [false; 2] });
    }
    let search = Search { section, places: section.places(count), tolerance };
    let anchors = search.polished(search.shortest(&search.anchors())?);
    let segments: Option<Vec<Segment>> =
        anchors.windows(2).map(|pair| search.segment(&pair[0], &pair[1])).collect();
    let steps = [anchors[0].has_step(), anchors[anchors.len() - 1].has_step()];
    segments
        .filter(|segments| segments.iter().all(Segment::is_solid))
        .map(|segments| Fitted { segments, steps })
}

struct Search<'a> {
    section: &'a Section,
    places: Vec<Place>,
    tolerance: f64,
}

/// An anchor and the index of its place.
struct Choice {
    anchor: Anchor,
    at: usize,
}

impl Search<'_> {
    /// Every anchor that there may be, from the lowest up.
    fn anchors(&self) -> Vec<Choice> {
        let last = self.places.len() - 1;
        let mut choices = Vec::new();
        let tips = |at: usize, tip: &crate::section::Tip, choices: &mut Vec<Choice>| {
            if tip.level {
                let anchor = |meeting| Anchor::Tip { s: self.places[at].s, z: tip.at.z, meeting };
                let meetings = if tip.step { &MEETINGS[..] } else { &MEETINGS[..WITHOUT_STEP] };
                choices.extend(meetings.iter().map(|meeting| Choice { anchor: anchor(*meeting), at }));
            }
        };
        tips(0, &self.section.low, &mut choices);
        for at in (0..=last).step_by(SAMPLES) {
            let offsets = if at == 0 || at == last { &OFFSETS[..1] } else { &OFFSETS };
            let anchors = offsets.iter().filter_map(|offset| self.knot(&self.places[at], *offset));
            choices.extend(anchors.map(|anchor| Choice { anchor, at }));
        }
        tips(last, &self.section.high, &mut choices);
        choices
    }

    fn knot(&self, place: &Place, offset: f64) -> Option<Anchor> {
        let knot = knot(place, offset * self.tolerance)?;
        Some(Anchor::Knot { s: place.s, offset, knot })
    }

    /// A chain of the fewest segments from the lower end to the upper one: all anchors that one segment reaches,
    /// then those that two reach, and so on.
    fn shortest(&self, choices: &[Choice]) -> Option<Vec<Anchor>> {
        let last = self.places.len() - 1;
        let mut before: Vec<Option<usize>> = vec![None; choices.len()];
        let mut reached: Vec<usize> = (0..choices.len()).filter(|k| choices[*k].at == 0).collect();
        let mut open: Vec<usize> = (reached.len()..choices.len()).collect();
        let far = choices.len() > FAR;
        while !reached.is_empty() {
            let mut next = Vec::new();
            open.retain(|high| {
                let choice = &choices[*high];
                // The nearest first, whose segment is the shortest.
                let below = &reached[..reached.partition_point(|low| choices[*low].at < choice.at)];
                let nearest = below.iter().rev().take(if far { 256 } else { usize::MAX });
                let from = nearest.copied().find(|low| self.allows(&choices[*low], choice));
                if from.is_some() {
                    before[*high] = from;
                    next.push(*high);
                }
                from.is_none()
            });
            if let Some(end) = next.iter().copied().find(|k| choices[*k].at == last) {
                let mut path: Vec<usize> = core::iter::successors(Some(end), |k| before[*k]).collect();
                path.reverse();
                return Some(path.into_iter().map(|k| choices[k].anchor).collect());
            }
            reached = next;
        }
        None
    }

    fn allows(&self, low: &Choice, high: &Choice) -> bool {
        self.error(&low.anchor, &high.anchor, &self.places[low.at..=high.at], self.tolerance).is_some()
    }

    /// The segment between two anchors, if their heights are two numbers.
    fn segment(&self, low: &Anchor, high: &Anchor) -> Option<Segment> {
        if !((low.z() as f32) < high.z() as f32) {
            return None;
        }
        if let (Anchor::Knot { knot: low, .. }, Anchor::Knot { knot: high, .. }) = (low, high) {
            return Some(Segment::between(*low, *high));
        }
        let height = high.z() - low.z();
        // What it passes through, and with which slope: a height that stands twice has one.
        let conditions = |anchor: &Anchor, towards: f64| match anchor {
            Anchor::Knot { knot, .. } => [*knot; 2],
            Anchor::Tip { z, meeting, .. } => meeting.map(|part| self.at_height(z + towards * part * height)),
        };
        let [[a, b], [c, d]] = [conditions(low, 1.0), conditions(high, -1.0)];
        let [b, a] = if low.is_tip() { [a, b] } else { [b, a] };
        Segment::through([a, b, c, d], [low.z(), high.z()])
    }

    /// The section at about a height; at its ends exactly.
    fn at_height(&self, z: f64) -> Knot {
        let at = self.places.partition_point(|place| place.z < z).min(self.places.len() - 1);
        let Place { z, f, slope, .. } = self.places[at];
        Knot { z, f, slope }
    }

    /// The largest distance of the segment between two anchors from places of the section, or `None` where the
    /// segment is none or the distance exceeds the limit.
    fn error(&self, low: &Anchor, high: &Anchor, places: &[Place], limit: f64) -> Option<f64> {
        let segment = self.segment(low, high)?;
        let cubic = segment.cubic();
        let steps = places.len() - 1;
        let compared = steps.min(COMPARED);
        let limit = limit * limit;
        let mut largest: f64 = 0.0;
        // At a level tip, the step from the segment's end to the section's.
        let tips = [(low, &self.section.low, segment.b[0]), (high, &self.section.high, segment.b[3])];
        let tips = tips.map(|(anchor, tip, f)| anchor.has_step().then(|| (tip.at, f.max(0.0).sqrt())));
        // It leads on from the segment's end, not back.
        for (tip, end) in tips.into_iter().flatten() {
            let overshoot = if places[steps / 2].r < tip.r { end - tip.r } else { tip.r - end }.max(0.0);
            if !(overshoot * overshoot <= OVERSHOOT * limit) {
                return None;
            }
        }
        // From the middle outwards and back, so that what fails fails early.
        for k in 0..compared.max(1) - 1 {
            let k = 1 + (k * SHUFFLE + compared / 2) % (compared - 1);
            let place = &places[k * steps / compared];
            let mut distance = squared_distance(&cubic, place, limit);
            for (tip, end) in tips.into_iter().flatten() {
                let beside = (tip.r.min(end) - place.r).max(place.r - tip.r.max(end)).max(0.0);
                distance = distance.min((tip.z - place.z).powi(2) + beside * beside);
                // The segment must not turn before its end.
                if cubic.at(place.z).1 * place.slope < 0.0 && distance > 0.01 * limit {
                    return None;
                }
            }
            if !(distance <= limit) {
                return None;
            }
            largest = largest.max(distance);
        }
        segment.is_solid().then(|| largest.sqrt())
    }

    /// Moves the knots between the first and the last, along the section and across it, to where the largest
    /// error is least.
    fn polished(&self, mut anchors: Vec<Anchor>) -> Vec<Anchor> {
        let error = |low: &Anchor, high: &Anchor| {
            let from = self.places.partition_point(|place| place.s < low.s());
            let to = self.places.partition_point(|place| place.s <= high.s());
            let between = &self.places[from.saturating_sub(1)..(to + 1).min(self.places.len())];
            self.error(low, high, between, f64::INFINITY)
        };
        let both =
            |low: &Anchor, here: &Anchor, high: &Anchor| Some(error(low, here)?.max(error(here, high)?));
        let mut step = 0.25;
        for _ in 0..ROUNDS {
            let mut moved = false;
            for i in 1..anchors.len() - 1 {
                let (below, above) = (anchors[i - 1], anchors[i + 1]);
                let Anchor::Knot { s, offset, .. } = anchors[i] else { continue };
                let Some(least) = both(&below, &anchors[i], &above) else { continue };
                for (along, across) in [(-step, 0.0), (step, 0.0), (0.0, -step), (0.0, step)] {
                    let room = if along < 0.0 { s - below.s() } else { above.s() - s };
                    let offset = (offset + across).clamp(-MOST_OFFSET, MOST_OFFSET);
                    let Some(there) = self.knot(&self.section.place(s + along * room), offset) else {
                        continue;
                    };
                    if both(&below, &there, &above).is_some_and(|error| error < 0.999 * least) {
                        (anchors[i], moved) = (there, true);
                        break;
                    }
                }
            }
            if !moved {
                step *= 0.5;
            }
        }
        anchors
    }
}

/// From so many anchors on, one is looked for no farther back than among the nearest 256 that were reached.
const FAR: usize = 5000;

/// How often each knot is tried to move.
const ROUNDS: usize = 24;

/// Has no divisor in common with any number of compared places less one up to [`COMPARED`].
const SHUFFLE: usize = 17;

/// A knot at a distance from the section, with the tangent of the place it belongs to.
fn knot(place: &Place, offset: f64) -> Option<Knot> {
    let (r, z) = (place.r + offset * place.normal.r, place.z + offset * place.normal.z);
    if offset == 0.0 {
        return place.slope.is_finite().then_some(Knot { z, f: place.f, slope: place.slope });
    }
    // 2·r·dr/dz.
    let slope = 2.0 * r * -place.normal.z / place.normal.r;
    (r > 0.0 && slope.is_finite()).then_some(Knot { z, f: r * r, slope })
}

/// The square of about how far a place is from a segment: to first order, by the smaller of both slopes, and not
/// more than the difference of radii, which is looked at only where the former exceeds the limit.
fn squared_distance(cubic: &Cubic, place: &Place, limit: f64) -> f64 {
    let (f, slope) = cubic.at(place.z);
    let gap = f - place.f;
    let by_slope = gap * gap / (4.0 * place.f + (slope * slope).min(place.slope * place.slope));
    if by_slope <= limit {
        return by_slope;
    }
    let by_radius = f.max(0.0).sqrt() - place.r;
    by_slope.min(by_radius * by_radius)
}

/// A section all of whose pieces are cubic in r² over height as they are: as many segments as it takes to have
/// all of them exact.
fn exact(section: &Section) -> Option<Vec<Segment>> {
    let mut segments: Vec<Segment> = Vec::new();
    let mut covered: Vec<Vec<Place>> = Vec::new();
    for i in 0..section.pieces.len() {
        let places: Vec<Place> = (0..=8).map(|k| inside(section, i, f64::from(k) / 8.0)).collect();
        let segment = through(&places)?;
        if let (Some(last), Some(before)) = (segments.last_mut(), covered.last_mut()) {
            let both: Vec<Place> = before.iter().chain(&places).copied().collect();
            if let Some(one) = through(&both) {
                (*last, *before) = (one, both);
                continue;
            }
        }
        segments.push(segment);
        covered.push(places);
    }
    segments.iter().all(Segment::is_solid).then_some(segments)
}

/// The place at t in piece i, also where the piece after it begins.
fn inside(section: &Section, i: usize, t: f64) -> Place {
    let piece = Section { pieces: vec![section.pieces[i].clone()], ..*section };
    piece.place(t)
}

/// The segment with the values and slopes of the first and the last place, if it passes through all between.
fn through(places: &[Place]) -> Option<Segment> {
    let (first, last) = (places.first()?, places.last()?);
    let segment = Segment::between(knot(first, 0.0)?, knot(last, 0.0)?);
    let size = last.z - first.z + places.iter().fold(0.0, |r: f64, p| r.max(p.r));
    let limit = (1e-11 * size).powi(2);
    let cubic = segment.cubic();
    places.iter().all(|place| squared_distance(&cubic, place, limit) <= limit).then_some(segment)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Piece, point, section::sections, walls::Wall};

    /// The fewest segments of all chains of knots at every place and at nine offsets, by trying them all.
    fn exhaustive(search: &Search, most: usize) -> Option<usize> {
        let last = search.places.len() - 1;
        let offsets = |at: usize| if at == 0 || at == last { 4..=4 } else { 0..=8 };
        let knots: Vec<Choice> = (0..=last)
            .step_by(SAMPLES)
            .flat_map(|at| offsets(at).map(move |k| (at, (f64::from(k) - 4.0) / 4.0 * MOST_OFFSET)))
            .filter_map(|(at, offset)| Some(Choice { anchor: search.knot(&search.places[at], offset)?, at }))
            .collect();
        let end = knots.len() - 1;
        fn reaches(search: &Search, knots: &[Choice], from: usize, end: usize, segments: usize) -> bool {
            if segments == 1 {
                return search.allows(&knots[from], &knots[end]);
            }
            let farther = (from + 1..end).filter(|to| knots[*to].at > knots[from].at);
            farther.into_iter().any(|to| {
                search.allows(&knots[from], &knots[to]) && reaches(search, knots, to, end, segments - 1)
            })
        }
        (1..=most).find(|segments| reaches(search, &knots, 0, end, *segments))
    }

    #[test]
    fn no_chain_of_knots_is_shorter_by_more_than_one() {
        let curves = [
            vec![point(1.0, 0.0), point(2.0, 1.0), point(0.3, 2.0), point(1.0, 3.0)],
            vec![point(0.0, 0.0), point(1.0, 0.2), point(1.5, 2.0), point(0.4, 3.0)],
            vec![
                point(1.0, 0.0),
                point(1.0, 1.0),
                point(3.0, 1.2),
                point(0.2, 1.8),
                point(1.0, 2.5),
                point(0.5, 3.5),
            ],
            vec![point(2.0, 0.0), point(0.0, 1.5), point(2.0, 3.0)],
        ];
        let mut counts = Vec::new();
        for curve in &curves {
            let wall = Wall { pieces: vec![Piece::bezier(curve)], rises: true };
            let section = &sections(&wall)[0];
            for tolerance in [0.1, 0.03, 0.01] {
                let search = Search { section, places: section.places(10), tolerance };
                let fewest = fewest(section, tolerance, 10).expect("a fit").segments.len();
                let least = exhaustive(&search, fewest).expect("at most as many");
                assert!(fewest <= least + 1, "{curve:?}, {tolerance}: {fewest} for {least}");
                counts.push((fewest, least));
            }
        }
        assert!(counts.iter().any(|(fewest, _)| *fewest >= 3), "only trivial cases: {counts:?}");
    }
}
