//! The least number of segments that follow a section within a tolerance.
//!
//! Knots may lie at some places of the section, and at each of these on the section itself or on its two
//! parallels at nearly the tolerance, with the section's own tangent: three kinds of knot a place. (A segment
//! on exact ends is off by up to M·h⁴/384, M the largest fourth derivative of r² over height, all of it to one
//! side; moved by half of that it is off by half as much.) At a corner and at the section's ends a knot
//! stays where it is, but a segment may arrive with another slope than the section: there is no tangent to share.
//! Beside a level tip r² goes with the root of the height, as no cubic does: there the last segment passes through
//! the section at another height, and ends at one of several radii within the tolerance. A step takes the rest.
//!
//! A search by breadth over all pairs of knots finds the fewest segments that lie between the section's parallels
//! at the tolerance, at sampled places: first all knots that one segment reaches, then those that two reach. (A
//! longer segment may do where a shorter one does not, so that always taking the longest would not be enough.)
//! What it finds is proven; where a proof fails the search goes on without the segment that it fails for.

use crate::{
    certificate,
    section::{Place, SAMPLES, Section, Tip},
    segment::{Cubic, Knot, Segment},
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

/// Offsets of knots from the section, in tolerances. Of several that do, the search takes the last, here as below.
const OFFSETS: [f64; 3] = [MOST_OFFSET, -MOST_OFFSET, 0.0];

const MOST_OFFSET: f64 = 0.95;

/// By how much a segment's slope at a corner or an end may differ from the section's: in tolerances of r² over the
/// height of the segment. The polynomial of degree 4 with leading coefficient 1 that is least on [−1, 1] among those that are zero at ±1
/// has slopes of 4·cot(π/8) = 9.7 times its size there, twice as much in segments of height 2.
const TILTS: [f64; 5] = [19.0, -19.0, 8.0, -8.0, 0.0];

/// A section with more corners than these has knots with its own slopes there.
const MANY_CORNERS: usize = 30;

/// Where the segment beside a level tip meets the section: the distance from the tip, in heights of the segment.
const MEETINGS: [f64; 7] = [0.7, 0.5, 0.03, 0.08, 0.35, 0.15, 0.25];

/// Below a level tip, how far down the section has the radius at which a segment may end: in tolerances. Zero is
/// the tip itself, and needs no step.
const DEPTHS: [f64; 4] = [0.9, 0.6, 0.3, 0.0];

/// Of the tolerance, what a segment is compared by: the rest is for rounding, and what samples may miss.
const COMPARED_BY: f64 = 0.985;

/// At how many places a segment is compared with the section, corners aside.
const COMPARED: usize = 16;

/// At how many it is compared where those do not refuse it.
const CLOSER: usize = 200;

/// How far out a side is looked for, in tolerances, as the proof does.
const REACHES: [f64; 9] = [1.0, 0.7, 0.45, 0.25, 0.1, 0.0, -0.3, -0.6, -0.9];

/// How often the search goes on without what was not proven.
const TRIES: usize = 60;

/// Where a segment may begin or end.
#[derive(Clone, Copy, Debug)]
struct Anchor {
    /// The index of its place.
    at: usize,
    z: f64,
    f: f64,
    /// What decides the slope there, below and above.
    slopes: [Slope; 2],
    /// Whether a step leads on to the section's end.
    step: bool,
}

#[derive(Clone, Copy, Debug)]
enum Slope {
    /// This one.
    Fixed(f64),
    /// This one and as many [`TILTS`].
    Tilted(f64, f64),
    /// That with which the segment meets the section so far from here, in heights of the segment.
    Meeting(f64),
}

/// The fewest segments within `tolerance` of a section, with knots at some `count` places, and proven; or
/// the place where none were.
pub(crate) fn fewest(section: &Section, tolerance: f64, count: usize) -> Result<Fitted, f64> {
    if let Some(segments) = exact(section) {
        let segments: Vec<Segment> = segments.iter().map(Segment::rounded).collect();
        let error = certificate::distance(section, &segments, [false; 2], tolerance)?;
        return Ok(Fitted { segments, steps: [false; 2], error });
    }
    let search = Search::new(section, tolerance, count);
    let anchors = search.anchors();
    let mut refused = HashSet::new();
    let mut place = 0.5 * section.pieces.len() as f64;
    for _ in 0..TRIES {
        let Some(path) = search.shortest(&anchors, &refused) else { break };
        let (fitted, chain) = search.fitted(&anchors, &path);
        match certificate::distance(section, &fitted.segments, fitted.steps, tolerance) {
            Ok(error) => return Ok(Fitted { error, ..fitted }),
            Err(at) => {
                place = at;
                let above = chain.partition_point(|k| search.places[anchors[*k].at].s <= at);
                let above = above.clamp(1, chain.len() - 1);
                refused.insert((chain[above - 1], chain[above]));
            }
        }
    }
    Err(place)
}

struct Search<'a> {
    section: &'a Section,
    places: Vec<Place>,
    /// The indices of places with corners.
    corners: Vec<usize>,
    tolerance: f64,
}

impl<'a> Search<'a> {
    fn new(section: &'a Section, tolerance: f64, count: usize) -> Self {
        let places = section.places(count);
        let corners = (0..places.len()).filter(|i| places[*i].is_corner).collect();
        Self { section, places, corners, tolerance: COMPARED_BY * tolerance }
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
                _ if place.is_corner => self.corner(at, &mut anchors),
                _ => anchors.extend(OFFSETS.iter().filter_map(|offset| self.knot(at, *offset))),
            }
        }
        anchors
    }

    /// A knot at a distance from the section, with the tangent of the place it belongs to.
    fn knot(&self, at: usize, offset: f64) -> Option<Anchor> {
        let Place { r, z, f, slopes: [_, slope], normal, .. } = self.places[at];
        let by = offset * self.tolerance;
        let (r, z) = (r + by * normal[0], z + by * normal[1]);
        // 2·r·dr/dz.
        let (f, slope) = if offset == 0.0 { (f, slope) } else { (r * r, 2.0 * r * -normal[1] / normal[0]) };
        let anchor = Anchor { at, z, f, slopes: [Slope::Fixed(slope); 2], step: false };
        ((r > 0.0 || offset == 0.0) && slope.is_finite()).then_some(anchor)
    }

    fn corner(&self, at: usize, anchors: &mut Vec<Anchor>) {
        let Place { z, f, slopes, .. } = self.places[at];
        if !slopes.iter().all(|slope| slope.is_finite()) {
            return;
        }
        let tilts = if self.corners.len() > MANY_CORNERS { &TILTS[TILTS.len() - 1..] } else { &TILTS };
        for below in tilts {
            for above in tilts {
                let slopes = [Slope::Tilted(slopes[0], *below), Slope::Tilted(slopes[1], *above)];
                anchors.push(Anchor { at, z, f, slopes, step: false });
            }
        }
    }

    /// The anchors at an end of the section.
    fn ends(&self, at: usize, tip: &Tip, anchors: &mut Vec<Anchor>) {
        let Place { z, f, slopes, .. } = self.places[at];
        if tip.level {
            let upper = at > 0;
            for depth in if tip.step { &DEPTHS[..] } else { &DEPTHS[DEPTHS.len() - 1..] } {
                let by = if upper { -depth } else { *depth } * self.tolerance;
                let f = self.at_height(tip.at.z + by).f;
                let meets = |meeting: &f64| {
                    let slopes = [Slope::Meeting(*meeting); 2];
                    Anchor { at, z, f, slopes, step: *depth > 0.0 }
                };
                anchors.extend(MEETINGS.iter().map(meets));
            }
        }
        if slopes[1].is_finite() && slopes[0].is_finite() {
            let tilted = |tilt: &f64| {
                let slopes = slopes.map(|slope| Slope::Tilted(slope, *tilt));
                Anchor { at, z, f, slopes, step: false }
            };
            anchors.extend(TILTS.iter().map(tilted));
        }
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
                let from = nearest
                    .copied()
                    .find(|low| self.allows(&anchors[*low], anchor) && !refused.contains(&(*low, *high)));
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

    /// The segments of a path, as they are printed, not proven yet, and the anchors between them.
    fn fitted(&self, anchors: &[Anchor], path: &[usize]) -> (Fitted, Vec<usize>) {
        let pairs = path.windows(2).filter_map(|k| self.segment(&anchors[k[0]], &anchors[k[1]]));
        let segments = pairs.map(|segment| segment.rounded()).collect();
        let steps = [anchors[path[0]].step, anchors[path[path.len() - 1]].step];
        (Fitted { segments, steps, error: f64::INFINITY }, path.to_vec())
    }

    /// The segment between two anchors, if their heights are two numbers.
    fn segment(&self, low: &Anchor, high: &Anchor) -> Option<Segment> {
        if !((low.z as f32) < high.z as f32) {
            return None;
        }
        let height = high.z - low.z;
        let slope = |anchor: &Anchor, slope: Slope| match slope {
            Slope::Fixed(slope) => Some(slope),
            Slope::Tilted(slope, by) => {
                let per_distance = (4.0 * anchor.f + slope * slope).sqrt();
                Some(slope + by * self.tolerance * per_distance / height)
            }
            Slope::Meeting(_) => None,
        };
        let [below, above] = [slope(low, low.slopes[1]), slope(high, high.slopes[0])];
        let knot = |anchor: &Anchor, slope: Option<f64>| Knot {
            z: anchor.z,
            f: anchor.f,
            slopes: [slope.unwrap_or(0.0); 2],
        };
        let ends = [knot(low, below), knot(high, above)];
        if below.is_some() && above.is_some() {
            return Some(Segment::between(ends[0], ends[1]));
        }
        // What it passes through.
        let other = |end: Knot, slope: Slope, towards: f64| match slope {
            Slope::Meeting(part) => self.at_height(end.z + towards * part * height),
            _ => end,
        };
        let between = [other(ends[0], low.slopes[1], 1.0), other(ends[1], high.slopes[0], -1.0)];
        Segment::through([ends[0], between[0], between[1], ends[1]], [low.z, high.z])
    }

    /// The section at about a height; at its ends exactly.
    fn at_height(&self, z: f64) -> Knot {
        let at = self.places.partition_point(|place| place.z < z).min(self.places.len() - 1);
        let Place { z, f, slopes, .. } = self.places[at];
        Knot { z, f, slopes }
    }

    /// Whether the segment between two anchors lies between the parallels at some places.
    fn allows(&self, low: &Anchor, high: &Anchor) -> bool {
        let Some(segment) = self.segment(low, high) else { return false };
        let last = self.places.len() - 1;
        // Beside a level tip it goes on as the section does, and does not turn before its end.
        let [b0, b1, b2, b3] = segment.b;
        let (bottom, top) = (&self.section.low, &self.section.high);
        if low.at == 0 && bottom.level && (b1 - b0) * bottom.leans < 0.0
            || high.at == last && top.level && (b3 - b2) * top.leans < 0.0
        {
            return false;
        }
        let end = |anchor: &Anchor, is_end: bool, tip: &Tip, upper: bool| {
            is_end.then(|| Ray::new(tip, if anchor.step { tip.at.r } else { anchor.f.sqrt() }, upper))
        };
        let rays = [
            end(low, low.at == 0, &self.section.low, false),
            end(high, high.at == last, &self.section.high, true),
        ];
        let curve = Curve { cubic: segment.cubic(), z: segment.z, rays, known: 0.2 * self.tolerance };
        let places = &self.places[low.at..=high.at];
        let steps = places.len() - 1;
        let compared = steps.min(COMPARED);
        // From the middle outwards and back, so that what fails fails early.
        let all = (0..compared.max(1) - 1).all(|k| {
            let k = 1 + (k * SHUFFLE + compared / 2) % (compared - 1);
            self.is_between(&curve, &places[k * steps / compared])
        });
        let corners = self.corners.partition_point(|corner| *corner <= low.at)
            ..self.corners.partition_point(|corner| *corner < high.at);
        let closer = steps.div_ceil(CLOSER).max(1);
        all && places.iter().step_by(closer).all(|place| self.is_between(&curve, place))
            && self.corners[corners].iter().all(|corner| self.is_between(&curve, &self.places[*corner]))
            && segment.is_solid()
    }

    /// Whether a curve passes between the parallels at a place.
    fn is_between(&self, curve: &Curve, place: &Place) -> bool {
        let [r, z] = place.normal;
        [1.0, -1.0].iter().all(|side| {
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

/// If there are more anchors than this, one is looked for no farther back than among the nearest 256 that were reached.
const FAR: usize = 20000;

/// Has no divisor in common with any number of compared places less one up to [`COMPARED`].
const SHUFFLE: usize = 17;

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

    /// The fewest segments of all chains of knots at every place, at nine offsets and with nine tilts at
    /// the ends, by trying them all.
    fn exhaustive(search: &Search, most: usize) -> Option<usize> {
        let last = search.places.len() - 1;
        let nine = |k: i32| f64::from(k - 4) / 4.0;
        let end = |at: usize, k: i32| {
            let Place { z, f, slopes, .. } = search.places[at];
            let slopes = slopes.map(|slope| Slope::Tilted(slope, 20.0 * nine(k)));
            Some(Anchor { at, z, f, slopes, step: false })
        };
        let anchor = |at: usize, k: i32| match at {
            0 => end(at, k),
            _ if at == last => end(at, k),
            _ => search.knot(at, nine(k) * MOST_OFFSET),
        };
        let anchors: Vec<Anchor> =
            (0..=last).step_by(SAMPLES).flat_map(|at| (0..9).filter_map(move |k| anchor(at, k))).collect();
        fn reaches(search: &Search, anchors: &[Anchor], from: &Anchor, segments: usize) -> bool {
            let last = search.places.len() - 1;
            let farther = anchors.iter().filter(|to| to.at > from.at && (segments > 1) == (to.at < last));
            farther.into_iter().any(|to| {
                search.allows(from, to) && (segments == 1 || reaches(search, anchors, to, segments - 1))
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
                let search = Search::new(section, tolerance, 10);
                let fewest = fewest(section, tolerance, 10).expect("a fit").segments.len();
                let least = exhaustive(&search, fewest).expect("at most as many");
                assert!(fewest <= least + 1, "{curve:?}, {tolerance}: {fewest} for {least}");
                counts.push((fewest, least));
            }
        }
        assert!(counts.iter().any(|(fewest, _)| *fewest >= 3), "only trivial cases: {counts:?}");
    }
}
