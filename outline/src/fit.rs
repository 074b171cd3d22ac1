//! The least number of segments that follow a section within a tolerance.
//!
//! Knots may lie at some places of the section, and at each of these on the section itself or at one of several
//! distances from it, up to nearly the tolerance. Where the section is smooth a knot has its tangent there, so that
//! the segments on both sides share it: joined in this way, equal segments of height h are off by at least M·h⁴/768,
//! M the fourth derivative of r² over height. At a corner and at the section's ends a knot stays where it is, and
//! segments choose their slope: there is no tangent to share. With [`Joins::Free`] they choose it everywhere. Beside
//! a level tip r² goes with the root of the height, as no cubic does: there the last segment ends at one of several
//! radii within the tolerance, and a step takes the rest.
//!
//! Between two knots a segment has at most two numbers left, its slopes at both ends. It has to pass between the
//! section's two parallels at the tolerance: each point of a parallel bounds a weighted sum of the two slopes, which
//! leaves a half-plane of them, and of the pairs that lie in all half-planes the segment takes the nearest to the
//! section's own slopes.
//!
//! A breadth-first search over all pairs of knots finds the fewest such segments: first all knots that one segment
//! reaches, then those that two reach. (A longer segment may pass where a shorter one does not, so that always taking
//! the longest would not be enough.) What it finds is proven; where a proof fails the search goes on without the
//! segment that it fails for.

use crate::{
    certificate,
    region::Region,
    section::{Place, SAMPLES, Section, Tip},
    segment::{Cubic, Knot, Segment},
    solid::Joins,
    tube::{Apart, Bound, SIDES, Tube},
};
use std::collections::HashSet;

/// The segments for a section.
#[derive(Clone, Debug)]
pub(crate) struct Fitted {
    /// Rounded to f32.
    pub segments: Vec<Segment>,
    /// Whether a step leads from the segments to the section's end, below and above.
    pub steps: [bool; 2],
    /// The proven error.
    pub error: f64,
}

/// Offsets of knots from the section, in tolerances, where segments share the tangent there.
const OFFSETS: [f64; 5] = [MOST_OFFSET, -MOST_OFFSET, 0.5, -0.5, 0.0];

/// The same where they do not. Of several that do, the search takes the last, here as above and below.
const FREE_OFFSETS: [f64; 3] = [MOST_OFFSET, -MOST_OFFSET, 0.0];

const MOST_OFFSET: f64 = 0.97;

/// Below a level tip, how far down the section has the radius at which a segment may end: in tolerances. Zero is
/// the tip itself, and needs no step.
const DEPTHS: [f64; 8] = [0.95, 0.85, 0.7, 0.5, 0.3, 0.15, 0.05, 0.0];

/// Of the tolerance, what segments are compared by: the rest is for rounding, and for what samples may miss. By less,
/// one after the other, where those that are found are not proven.
const COMPARED_BY: [f64; 5] = [0.99, 0.96, 0.9, 0.75, 0.5];

/// At how many points of parallels a segment is compared with the section before it is at all.
const COMPARED: usize = 16;

/// At how many of each it is compared where those do not refuse it.
const CLOSER: usize = 200;

/// How far out a side is looked for where parallels fold, in tolerances, as the proof does.
const REACHES: [f64; 6] = [1.0, 0.7, 0.45, 0.25, 0.1, 0.0];

/// How often each search goes on without what was not proven.
const TRIES: usize = 12;

/// By how much rounding to f32 may turn a tangent that two segments share, in radians: lower segments are none.
const MOST_TURNED: f64 = 2e-4;

/// A unit in the last place of f32 is at most as large a part of a number.
const ULP: f64 = 1.0 / (1 << 23) as f64;

/// Where a segment may begin or end.
#[derive(Clone, Copy, Debug)]
struct Anchor {
    /// The index of its place.
    at: usize,
    z: f64,
    f: f64,
    /// The slope there, below and above; `None` where a segment chooses it.
    slopes: [Option<f64>; 2],
    /// Whether a step leads on to the section's end.
    step: bool,
}

/// The fewest segments within `tolerance` of a section, with knots at some `count` places, and proven; or
/// the place where none were.
pub(crate) fn fewest(section: &Section, tolerance: f64, count: usize, joins: Joins) -> Result<Fitted, f64> {
    if let Some(segments) = exact(section) {
        let segments: Vec<Segment> = segments.iter().map(Segment::rounded).collect();
        let error = certificate::distance(section, &segments, [false; 2], tolerance)?;
        return Ok(Fitted { segments, steps: [false; 2], error });
    }
    let mut place = 0.5 * section.pieces.len() as f64;
    for part in COMPARED_BY {
        let search = Search::new(section, part * tolerance, count, joins);
        let anchors = search.anchors();
        let mut refused = HashSet::new();
        for _ in 0..TRIES {
            let Some(path) = search.shortest(&anchors, &refused) else { break };
            let fitted = search.fitted(&anchors, &path);
            match certificate::distance(section, &fitted.segments, fitted.steps, tolerance) {
                Ok(error) => return Ok(Fitted { error, ..fitted }),
                Err(at) => {
                    place = at;
                    let above = path.partition_point(|k| search.places[anchors[*k].at].s <= at);
                    let above = above.clamp(1, path.len() - 1);
                    refused.insert((path[above - 1], path[above]));
                }
            }
        }
    }
    Err(place)
}

struct Search<'a> {
    section: &'a Section,
    places: Vec<Place>,
    tube: Tube,
    tolerance: f64,
    joins: Joins,
}

impl<'a> Search<'a> {
    fn new(section: &'a Section, tolerance: f64, count: usize, joins: Joins) -> Self {
        let places = section.places(count);
        let tube = Tube::new(section, &places, tolerance);
        Self { section, places, tube, tolerance, joins }
    }

    /// Every anchor that there may be, from the lowest up.
    fn anchors(&self) -> Vec<Anchor> {
        let last = self.places.len() - 1;
        let mut anchors = Vec::new();
        for at in (0..=last).step_by(SAMPLES) {
            let place = &self.places[at];
            match at {
                0 => self.ends(at, &self.section.low, &mut anchors),
                _ if at == last => self.ends(at, &self.section.high, &mut anchors),
                _ if place.is_corner => anchors.push(self.free(at, place.f, false)),
                _ => anchors.extend(self.offsets().iter().filter_map(|offset| self.knot(at, *offset))),
            }
        }
        anchors
    }

    fn offsets(&self) -> &'static [f64] {
        match self.joins {
            Joins::Smooth => &OFFSETS,
            Joins::Free => &FREE_OFFSETS,
        }
    }

    /// A knot at a distance from the section, with the tangent of the place it belongs to.
    fn knot(&self, at: usize, offset: f64) -> Option<Anchor> {
        let Place { r, z, f, slopes: [_, slope], normal, .. } = self.places[at];
        let by = offset * self.tolerance;
        let (r, z) = (r + by * normal[0], z + by * normal[1]);
        // 2·r·dr/dz.
        let (f, slope) = if offset == 0.0 { (f, slope) } else { (r * r, 2.0 * r * -normal[1] / normal[0]) };
        let shared = (self.joins == Joins::Smooth).then_some(slope);
        let anchor = Anchor { at, z, f, slopes: [shared; 2], step: false };
        ((r > 0.0 || offset == 0.0) && slope.is_finite()).then_some(anchor)
    }

    /// A knot at the height of a place without a tangent to share.
    fn free(&self, at: usize, f: f64, step: bool) -> Anchor {
        Anchor { at, z: self.places[at].z, f, slopes: [None; 2], step }
    }

    /// The anchors at an end of the section.
    fn ends(&self, at: usize, tip: &Tip, anchors: &mut Vec<Anchor>) {
        let Place { f, slopes, .. } = self.places[at];
        if tip.level && tip.step {
            let inwards = if at > 0 { -self.tolerance } else { self.tolerance };
            let below_tip = DEPTHS.iter().filter(|depth| **depth > 0.0);
            anchors.extend(
                below_tip.map(|depth| self.free(at, self.at_height(tip.at.z + inwards * depth), true)),
            );
        }
        // A pointed pole stays one.
        let pointed = tip.at.r == 0.0 && slopes[1] == 0.0;
        let end = self.free(at, f, false);
        anchors.push(if pointed { Anchor { slopes: [Some(0.0); 2], ..end } } else { end });
    }

    /// A chain of the fewest segments from the lower end to the upper one: all anchors that one segment reaches,
    /// then those that two reach, and so on.
    fn shortest(&self, anchors: &[Anchor], refused: &HashSet<(usize, usize)>) -> Option<Vec<usize>> {
        let last = self.places.len() - 1;
        let mut before: Vec<Option<usize>> = vec![None; anchors.len()];
        let mut reached: Vec<usize> = (0..anchors.len()).filter(|k| anchors[*k].at == 0).collect();
        let mut open: Vec<usize> = (reached.len()..anchors.len()).collect();
        let far = anchors.len() > FAR;
        while !reached.is_empty() {
            let mut next = Vec::new();
            open.retain(|high| {
                let anchor = &anchors[*high];
                // The nearest first, whose segment is the shortest.
                let below = &reached[..reached.partition_point(|low| anchors[*low].at < anchor.at)];
                let nearest = below.iter().rev().take(if far { 256 } else { usize::MAX });
                let from = nearest.copied().find(|low| {
                    !refused.contains(&(*low, *high)) && self.segment(&anchors[*low], anchor).is_some()
                });
                if from.is_some() {
                    before[*high] = from;
                    next.push(*high);
                }
                from.is_none()
            });
            if let Some(end) = next.iter().rev().copied().find(|k| anchors[*k].at == last) {
                let mut path: Vec<usize> = core::iter::successors(Some(end), |k| before[*k]).collect();
                path.reverse();
                return Some(path);
            }
            reached = next;
        }
        None
    }

    /// The segments of a path, as they are printed, not proven yet.
    fn fitted(&self, anchors: &[Anchor], path: &[usize]) -> Fitted {
        let pairs = path.windows(2).filter_map(|k| self.segment(&anchors[k[0]], &anchors[k[1]]));
        let segments = pairs.map(|segment| segment.rounded()).collect();
        let steps = [anchors[path[0]].step, anchors[path[path.len() - 1]].step];
        Fitted { segments, steps, error: f64::INFINITY }
    }

    /// The segment between two anchors that passes between the parallels at sampled points, if there is one.
    fn segment(&self, low: &Anchor, high: &Anchor) -> Option<Segment> {
        if !((low.z as f32) < high.z as f32) {
            return None;
        }
        let ends = [low, high];
        let height = high.z - low.z;
        let slopes = [low.slopes[1], high.slopes[0]];
        let tips = [
            (low.at == 0).then_some(&self.section.low),
            (high.at + 1 == self.places.len()).then_some(&self.section.high),
        ];
        let own = [self.places[low.at].slopes[1], self.places[high.at].slopes[0]];
        let secant = (high.f - low.f) / height;
        let start = [0, 1].map(|end| if tips[end].is_some_and(|tip| tip.level) { secant } else { own[end] });
        let mut region = Region::around(start);
        // A fixed slope's is a part of what is known.
        let cut = |region: &mut Region, bound: &Bound, side: f64| {
            let u = (bound.z - low.z) / height;
            let v = 1.0 - u;
            let by_slopes = [height * u * v * v, -height * u * u * v];
            let mut room = bound.f - low.f * v * v * (1.0 + 2.0 * u) - high.f * u * u * (1.0 + 2.0 * v);
            let mut plane = [0.0; 2];
            for end in 0..2 {
                match slopes[end] {
                    Some(slope) => room -= by_slopes[end] * slope,
                    None => plane[end] = by_slopes[end],
                }
            }
            region.cut([side * plane[0], side * plane[1], side * room])
        };
        let within = [0, 1].map(|side| self.tube.within(side, [low.z, high.z]));
        for k in 0..COMPARED {
            let bounds = within[k % 2];
            let at = ((k as f64 + 0.5) * GOLDEN).fract() * bounds.len() as f64;
            if bounds.get(at as usize).is_some_and(|bound| !cut(&mut region, bound, SIDES[k % 2])) {
                return None;
            }
        }
        // Beside a level tip a segment goes on as the section does, and does not turn before its end; at a pole it
        // leads away from the axis.
        for (end, tip) in tips.into_iter().enumerate() {
            let Some(tip) = tip.filter(|tip| (tip.level || tip.at.r == 0.0) && slopes[end].is_none()) else {
                continue;
            };
            let mut along = [0.0; 2];
            along[end] = -tip.leans;
            if !region.cut([along[0], along[1], 0.0]) {
                return None;
            }
        }
        for (bounds, side) in within.into_iter().zip(SIDES) {
            let step = bounds.len().div_ceil(CLOSER).max(1);
            if !bounds.iter().step_by(step).all(|bound| cut(&mut region, bound, side)) {
                return None;
            }
        }
        let nearest = region.nearest();
        let knot = |end: usize| Knot {
            z: ends[end].z,
            f: ends[end].f,
            slopes: [slopes[end].unwrap_or(nearest[end]); 2],
        };
        let segment = Segment::between(knot(0), knot(1));
        // Rounding of two neighboring ordinates to f32 turns a tangent by no more than this; the tangent itself by
        // less.
        let turned = |end: usize| {
            let largest = segment.b.iter().fold(0.0, |b: f64, c| b.max(c.abs()));
            3.0 * ULP * largest / (height * 2.0 * ends[end].f.sqrt())
        };
        let is_shared =
            (0..2).all(|end| slopes[end].is_none() || ends[end].f == 0.0 || turned(end) <= MOST_TURNED);
        (is_shared && segment.rounded().is_solid() && self.allows(low, high, &segment)).then_some(segment)
    }

    /// The section's squared radius at about a height; at its ends exactly.
    fn at_height(&self, z: f64) -> f64 {
        let at = self.places.partition_point(|place| place.z < z).min(self.places.len() - 1);
        self.places[at].f
    }

    /// Whether a segment passes between the parallels where they are folded or gapped.
    fn allows(&self, low: &Anchor, high: &Anchor, segment: &Segment) -> bool {
        let last = self.places.len() - 1;
        let end = |anchor: &Anchor, is_end: bool, tip: &Tip, upper: bool| {
            is_end.then(|| Ray::new(tip, if anchor.step { tip.at.r } else { anchor.f.sqrt() }, upper))
        };
        let rays = [
            end(low, low.at == 0, &self.section.low, false),
            end(high, high.at == last, &self.section.high, true),
        ];
        let curve = Curve { cubic: segment.cubic(), z: segment.z, rays, known: 0.2 * self.tolerance };
        let apart = &self.tube.apart;
        let from = apart.partition_point(|place| place.at <= low.at);
        let to = apart.partition_point(|place| place.at < high.at);
        apart[from..to].iter().all(|place| self.is_between(&curve, place))
    }

    /// Whether a curve passes between some points on both sides of a place that are not farther than the tolerance.
    fn is_between(&self, curve: &Curve, apart: &Apart) -> bool {
        let place = &self.places[apart.at];
        SIDES.iter().zip(apart.d).all(|(side, [r, z])| {
            REACHES.iter().any(|reach| {
                let by = side * reach * self.tolerance;
                curve.is_beside(place.r + by * r, place.z + by * z, *side)
            })
        })
    }
}

/// A segment, and how it goes on where it ends at the section's end.
struct Curve {
    cubic: Cubic,
    z: [f64; 2],
    rays: [Option<Ray>; 2],
    /// How far beyond other ends its tangent stands for the next segment.
    known: f64,
}

/// How the segments are continued beyond the section's end, as the proof does.
struct Ray {
    r: f64,
    /// Of the radius over height.
    slope: f64,
}

impl Ray {
    fn new(tip: &Tip, r: f64, upper: bool) -> Self {
        Self { r, slope: tip.ray(upper) }
    }
}

impl Curve {
    /// Whether a point is outside (+1) of the curve or inside (−1).
    fn is_beside(&self, r: f64, z: f64, side: f64) -> bool {
        let beyond = |ray: &Option<Ray>, end: f64| {
            ray.as_ref().map(|ray| side * (r - ray.r - ray.slope * (z - end)) > 0.0)
        };
        let by_ray = if z < self.z[0] {
            beyond(&self.rays[0], self.z[0])
        } else if z > self.z[1] {
            beyond(&self.rays[1], self.z[1])
        } else {
            None
        };
        by_ray.unwrap_or_else(|| {
            let end = z.clamp(self.z[0], self.z[1]);
            if (z - end).abs() > self.known {
                return false;
            }
            let (f, slope) = self.cubic.at(end);
            let gap = r * r.abs() - (f + slope * (z - end));
            side * gap > 0.0
        })
    }
}

/// If there are more anchors than this, one is looked for no farther back than among the nearest 256 that were
/// reached.
const FAR: usize = 20000;

/// The golden section's fractions fill an interval evenly, however many there are.
const GOLDEN: f64 = 0.618_033_988_749_895;

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
    let knot = |place: &Place| Knot { z: place.z, f: place.f, slopes: place.slopes };
    let segment = Segment::between(knot(first), knot(last));
    if !segment.b.iter().all(|b| b.is_finite()) {
        return None;
    }
    let size = last.z - first.z + places.iter().fold(0.0, |r: f64, p| r.max(p.r));
    let limit = (1e-11 * size).powi(2);
    let cubic = segment.cubic();
    let squared_distance = |place: &Place| {
        let (f, slope) = cubic.at(place.z);
        let gap = f - place.f;
        let by_slope = gap * gap / (4.0 * place.f + slope * slope);
        by_slope.min((f.max(0.0).sqrt() - place.r).powi(2))
    };
    places.iter().all(|place| squared_distance(place) <= limit).then_some(segment)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Piece, point, section::sections, walls::Wall};

    /// The fewest segments of all chains of knots at every place, at nine offsets and with free slopes at
    /// the ends, by trying them all.
    fn exhaustive(search: &Search, most: usize) -> Option<usize> {
        let last = search.places.len() - 1;
        let offset = |k: i32| f64::from(k - 4) / 4.0 * MOST_OFFSET;
        let anchors = (0..=last).step_by(SAMPLES).flat_map(|at| {
            let is_end = at == 0 || at == last;
            let end = is_end.then(|| search.free(at, search.places[at].f, false));
            end.into_iter()
                .chain((0..9).filter(move |_| !is_end).filter_map(move |k| search.knot(at, offset(k))))
        });
        let anchors: Vec<Anchor> = anchors.collect();
        fn reaches(search: &Search, anchors: &[Anchor], from: &Anchor, segments: usize) -> bool {
            let last = search.places.len() - 1;
            let farther = anchors.iter().filter(|to| to.at > from.at && (segments > 1) == (to.at < last));
            farther.into_iter().any(|to| {
                search.segment(from, to).is_some()
                    && (segments == 1 || reaches(search, anchors, to, segments - 1))
            })
        }
        let starts = || anchors.iter().filter(|anchor| anchor.at == 0);
        (1..=most).find(|segments| starts().any(|start| reaches(search, &anchors, start, *segments)))
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
                let search = Search::new(section, tolerance, 10, Joins::Smooth);
                let fewest = fewest(section, tolerance, 10, Joins::Smooth).expect("a fit").segments.len();
                let least = exhaustive(&search, fewest).expect("at most as many");
                assert!(fewest <= least + 1, "{curve:?}, {tolerance}: {fewest} for {least}");
                counts.push((fewest, least));
            }
        }
        assert!(counts.iter().any(|(fewest, _)| *fewest >= 3), "only trivial cases: {counts:?}");
    }
}
