//! From an outline to a body: the whole pipe.

use crate::{
    axis::{self, Half},
    body::{Body, Shape, Sheet, Side},
    crossing::{self, Strand},
    cusps,
    error::{OutlineError, Warning},
    fit::{self, Fitted},
    outline::Outline,
    piece::{Piece, Point},
    section::{self, Section, Tip},
    segment::Segment,
    walls::{self, Flat, Run, Runs, Wall},
};

/// How an outline is to be fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The largest distance between the drawn outline and the body's, in the drawing's unit.
    pub tolerance: f64,
    /// Which half to take of an outline that has both. `None` refuses one.
    pub half: Option<Half>,
    /// At how many places knots may lie between two places where the outline is level or on the axis. More of them
    /// take longer, as the square of their number, and may save a segment.
    pub places: usize,
    /// How segments meet where the outline is smooth.
    pub joins: Joins,
}

/// How segments meet where the outline is smooth. At its corners they meet as it does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Joins {
    /// With the outline's tangent.
    #[default]
    Smooth,
    /// With any tangents, within the tolerance of the outline: up to 1.4 times fewer
    /// segments, whose joins shading shows as edges.
    Free,
}

impl Fit {
    /// Within a tolerance; no half chosen, 400 places, joins smooth.
    pub const fn within(tolerance: f64) -> Self {
        Self { tolerance, half: None, places: 400, joins: Joins::Smooth }
    }
}

/// A wall and the segments that stand for it.
struct FittedWall {
    rises: bool,
    /// From its lower end up; between two of them there may be a step.
    stretches: Vec<Vec<Segment>>,
    /// The radii at which the drawn wall ends, below and above.
    drawn: [f64; 2],
    /// Whether a step follows the drawing at its ends.
    steps: [bool; 2],
}

/// The body that an outline encloses when it is turned about the axis.
///
/// An open outline whose ends lie on the axis is closed by it; any other open one makes walls without
/// thickness.
///
/// # Errors
///
/// [`OutlineError`], with the height of what is wrong.
pub fn body(outline: &Outline, fit: &Fit) -> Result<Body, OutlineError> {
    let tolerance = fit.tolerance;
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(OutlineError::Tolerance(tolerance));
    }
    if outline.pieces().len() > crate::MOST_PIECES {
        return Err(OutlineError::TooManyPieces(outline.pieces().len()));
    }
    // What is left is for the steps at turns, for cutting in f64 and for the snap to the axis.
    let fit = &Fit { tolerance: SHARE * tolerance, ..*fit };
    let mut warnings = Vec::new();
    let chains = axis::one_side(outline, fit.half, &mut warnings)?;
    let runs = chains
        .iter()
        .map(|chain| walls::runs(chain, fit.tolerance, &mut warnings))
        .collect::<Result<Vec<_>, _>>()?;
    if let Some(at) = crossing::find(&strands(&runs)) {
        return Err(OutlineError::CrossesItself { height: at.z, radius: at.r });
    }
    let shape = shape(&runs);
    // What cutting in f64 and the snap to the axis may have moved.
    let moved = (axis::ON_AXIS * outline.size()).min(1e-3 * tolerance)
        * f64::from(u8::from(snapped(outline)))
        + 1e-12 * outline.size();
    let mut met = 0.0;
    // Walls that are nearer to each other than the tolerance may cross when they are fitted: then more closely.
    for closer in CLOSER {
        let fit = &Fit { tolerance: closer * fit.tolerance, ..*fit };
        let (mut sheets, mut warnings) = (Vec::new(), warnings.clone());
        let mut error: f64 = 0.0;
        for runs in &runs {
            error = error.max(assemble(runs.clone(), fit, &mut sheets, &mut warnings)?);
        }
        error += moved;
        match walls_meet(&sheets) {
            None => return Ok(Body { sheets, tolerance, error, warnings, shape }),
            Some(height) => met = height,
        }
    }
    Err(OutlineError::WallsMeet { height: met })
}

/// The parts of the tolerance within which walls are fitted until they do not cross.
const CLOSER: [f64; 5] = [1.0, 0.85, 0.7, 0.5, 0.3];

/// Of the tolerance, what fitting and straightening may use.
const SHARE: f64 = 0.97;

/// Whether the outline has ends near the axis that are not on it.
fn snapped(outline: &Outline) -> bool {
    let near = axis::ON_AXIS * outline.size();
    outline.pieces().iter().any(|piece| {
        let r = [piece.start().r.abs(), piece.end().r.abs()];
        r.iter().any(|r| *r > 0.0 && *r <= near)
    })
}

/// Every wall of the outline in chords, and its flats.
fn strands(runs: &[Runs]) -> Vec<Strand<'_>> {
    let runs = runs.iter().flat_map(|runs| &runs.runs);
    runs.flat_map(|run| match run {
        Run::Wall(wall) => wall.pieces.iter().map(piece_strand).collect(),
        Run::Flat(flat) => vec![flat_strand(flat)],
    })
    .collect()
}

fn piece_strand(piece: &Piece) -> Strand<'_> {
    let chords = if piece.is_straight() { 1 } else { 32 };
    Strand { at: Box::new(|t| piece.at(t)), chords }
}

fn flat_strand(flat: &Flat) -> Strand<'_> {
    Strand { at: Box::new(|t| Point { r: flat.from + t * (flat.to - flat.from), z: flat.z }), chords: 1 }
}

fn shape(runs: &[Runs]) -> Shape {
    let mut shape = Shape::default();
    for runs in runs {
        if let Some(z) = runs.begins_inside {
            shape.walls += 1;
            shape.heights.push(z);
        }
        for run in &runs.runs {
            match run {
                Run::Wall(wall) => {
                    shape.walls += 1;
                    shape
                        .heights
                        .extend([wall.pieces[0].start().z, wall.pieces[wall.pieces.len() - 1].end().z]);
                    // Where it stands still inside, it is two, with a flat of no width between them.
                    for at in section::still(wall) {
                        shape.walls += 1;
                        shape.heights.push(at.z);
                        shape.flats.push((at.z, [at.r; 2]));
                    }
                    let ends = [wall.pieces[0].jet(0.0), wall.pieces[wall.pieces.len() - 1].jet(1.0)];
                    let poles = ends.iter().filter(|end| end.r == 0.0 && section::is_flat(end));
                    shape.flats.extend(poles.map(|end| (end.z, [0.0; 2])));
                }
                Run::Flat(flat) if flat.drawn => {
                    shape.flats.push((flat.z, [flat.from.min(flat.to), flat.from.max(flat.to)]));
                }
                Run::Flat(_) => {}
            }
        }
    }
    shape.heights.sort_by(f64::total_cmp);
    shape.heights.dedup();
    shape
}

/// One chain's sheets, added to those of others. Returns their proven error.
fn assemble(
    mut runs: Runs,
    fit: &Fit,
    sheets: &mut Vec<Sheet>,
    warnings: &mut Vec<Warning>,
) -> Result<f64, OutlineError> {
    let rises_outside = area(&runs.runs) > 0.0;
    let mut sections: Vec<Vec<Section>> = runs
        .runs
        .iter()
        .map(|run| if let Run::Wall(wall) = run { section::sections(wall) } else { Vec::new() })
        .collect();
    cusps::keep(&runs, &mut sections);
    let mut error: f64 = 0.0;
    let mut walls: Vec<FittedWall> = Vec::new();
    // The flat before each wall, and the one after the last.
    let mut flats: Vec<Option<Flat>> = vec![None];
    for (run, sections) in core::mem::take(&mut runs.runs).into_iter().zip(sections) {
        match run {
            Run::Flat(flat) => {
                error = error.max(flat.error + rounding(flat.z));
                let last = flats.last_mut().expect("one more than walls");
                *last = Some(match last.take() {
                    Some(before) => Flat { from: before.from, ..flat },
                    None => flat,
                });
            }
            Run::Wall(wall) => match fit_wall(&wall, &sections, fit, warnings)? {
                Some((fitted, wall_error)) => {
                    error = error.max(wall_error);
                    walls.push(fitted);
                    flats.push(None);
                }
                None => error = error.max(rounding(wall.pieces[0].start().z)),
            },
        }
    }
    if walls.is_empty() {
        return Err(OutlineError::NoWall);
    }
    // Walls in one direction are one sheet.
    let mut groups: Vec<Vec<FittedWall>> = Vec::new();
    let mut before = Vec::new();
    let after = flats.pop().flatten();
    for (wall, flat) in walls.into_iter().zip(flats) {
        match groups.last_mut() {
            Some(group) if group[0].rises == wall.rises => group.push(wall),
            _ => {
                groups.push(vec![wall]);
                before.push(flat);
            }
        }
    }
    let first = sheets.len();
    for group in &groups {
        let side = if group[0].rises == rises_outside { Side::Outer } else { Side::Inner };
        let mut stretches: Vec<Vec<Segment>> = Vec::new();
        for wall in group {
            let inward = wall.stretches.iter().cloned();
            if wall.rises { stretches.extend(inward) } else { stretches.splice(0..0, inward).for_each(drop) }
        }
        sheets.push(Sheet::new(side, &stretches));
    }
    let n = groups.len();
    // Where one sheet is drawn on into the next, a flat leads from the one's end to the other's.
    for i in 0..n {
        let next = if i + 1 < n { i + 1 } else { 0 };
        if next == 0 && !runs.closed {
            continue;
        }
        let (rises, next_rises) = (groups[i][0].rises, groups[next][0].rises);
        let end = sheets[first + i].ends()[usize::from(rises)];
        let start = sheets[first + next].ends()[usize::from(!next_rises)];
        if end != start {
            let (of, to) = if sheets[first + i].side == Side::Outer { (i, start) } else { (next, end) };
            let sheet = &mut sheets[first + of];
            *(if rises { &mut sheet.top } else { &mut sheet.base }) = Some(to);
        }
        // The drawn ends must lie on that flat.
        let last = &groups[i][groups[i].len() - 1];
        let drawn = [last.drawn[usize::from(rises)], groups[next][0].drawn[usize::from(!next_rises)]];
        let ring = [f64::from(end).sqrt(), f64::from(start).sqrt()];
        let beyond = drawn.map(|r| (ring[0].min(ring[1]) - r).max(r - ring[0].max(ring[1])).max(0.0));
        if last.steps[usize::from(rises)] || groups[next][0].steps[usize::from(!next_rises)] {
            error += beyond[0].max(beyond[1]);
        }
    }
    if !runs.closed {
        let (wall, sheet) = (&groups[0][0], &mut sheets[first]);
        let flat = before[0].as_ref().map(|flat| flat.from);
        let below = wall.rises;
        *(if below { &mut sheet.base } else { &mut sheet.top }) = flat_to(flat, wall, usize::from(!below));
        let group = &groups[n - 1];
        let (wall, sheet) = (&group[group.len() - 1], &mut sheets[first + n - 1]);
        let above = wall.rises;
        *(if above { &mut sheet.top } else { &mut sheet.base }) =
            flat_to(after.map(|flat| flat.to), wall, usize::from(above));
    }
    Ok(error)
}

/// The squared radius to which a flat leads at an open end of the outline.
fn flat_to(drawn: Option<f64>, wall: &FittedWall, end: usize) -> Option<f32> {
    let radius = drawn.or(wall.steps[end].then_some(wall.drawn[end]))?;
    Some((radius * radius) as f32)
}

/// Half a unit in the last place of a height as f32.
fn rounding(z: f64) -> f64 {
    (z - f64::from(z as f32)).abs().next_up()
}

/// Twice the area between the outline and the axis, positive if it is drawn with the body on its left.
fn area(runs: &[Run]) -> f64 {
    let walls = runs.iter().filter_map(|run| if let Run::Wall(wall) = run { Some(wall) } else { None });
    walls
        .map(|wall| {
            let under: f64 = wall.pieces.iter().map(under).sum();
            if wall.rises { under } else { -under }
        })
        .sum()
}

fn under(piece: &Piece) -> f64 {
    let points: Vec<Point> = (0..=16).map(|i| piece.at(f64::from(i) / 16.0)).collect();
    points.windows(2).map(|p| (p[0].r + p[1].r) * (p[1].z - p[0].z)).sum()
}

/// The segments for a wall and their proven error; none if all of it is at one height in f32.
fn fit_wall(
    wall: &Wall,
    sections: &[Section],
    fit: &Fit,
    warnings: &mut Vec<Warning>,
) -> Result<Option<(FittedWall, f64)>, OutlineError> {
    let drawn = [wall.pieces[0].start().r, wall.pieces[wall.pieces.len() - 1].end().r];
    let mut fitted = FittedWall { rises: wall.rises, stretches: Vec::new(), drawn, steps: [false; 2] };
    let mut error: f64 = 0.0;
    let last = sections.len() - 1;
    for (i, section) in sections.iter().enumerate() {
        let heights = [section.low.at.z, section.high.at.z];
        if heights[0] as f32 == heights[1] as f32 {
            warnings.push(Warning::Merged { heights });
            error = error.max(rounding(heights[0]) + heights[1] - heights[0]);
            continue;
        }
        let Fitted { segments, steps, error: proven } = fit_section(section, fit)?;
        error = error.max(proven);
        fitted.stretches.push(segments);
        fitted.steps[0] |= i == 0 && steps[0];
        fitted.steps[1] |= i == last && steps[1];
    }
    Ok((!fitted.stretches.is_empty()).then_some((fitted, error)))
}

/// The fewest segments whose rounded numbers are proven to be within the tolerance.
fn fit_section(section: &Section, fit: &Fit) -> Result<Fitted, OutlineError> {
    let without_steps = Section {
        pieces: section.pieces.clone(),
        low: Tip { step: false, ..section.low },
        high: Tip { step: false, ..section.high },
    };
    // If steps do not do, without.
    let fitted = fit::fewest(section, fit.tolerance, fit.places, fit.joins)
        .or_else(|_| fit::fewest(&without_steps, fit.tolerance, fit.places, fit.joins));
    fitted.map_err(|s| OutlineError::OutOfReach {
        tolerance: fit.tolerance / SHARE,
        height: section.place(s).z,
    })
}

/// The height at which fitted walls cross, if they do.
fn walls_meet(sheets: &[Sheet]) -> Option<f64> {
    if sheets.len() < 2 {
        return None;
    }
    let segments: Vec<Segment> = sheets.iter().flat_map(Sheet::segments).collect();
    let strands: Vec<Strand> = segments
        .iter()
        .map(|segment| {
            let at = |t: f64| {
                let z = segment.z[0] + t * (segment.z[1] - segment.z[0]);
                Point { r: segment.at(z).0.max(0.0).sqrt(), z }
            };
            Strand { at: Box::new(at), chords: 32 }
        })
        .collect();
    crossing::find(&strands).map(|at| at.z)
}
