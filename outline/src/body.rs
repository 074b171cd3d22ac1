//! What comes out: one solid as sheets of segments, in the f32 numbers that firmware has.

use crate::{error::Warning, segment::Segment};

/// One solid of revolution: height-monotone walls, the flats that join them, and how far it is from the
/// drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its walls, in the order in which they are drawn.
    pub sheets: Vec<Sheet>,
    /// The tolerance asked for, in the drawing's unit.
    pub tolerance: f64,
    /// The proven error: from no point of the drawing's outline is the body's farther, nor the other way
    /// around. In the drawing's unit.
    pub error: f64,
    /// What was changed or left out.
    pub warnings: Vec<Warning>,
    /// The outline as it was understood: where it turns and ends, and its flats.
    pub shape: Shape,
}

/// An outline's traits, before anything is fitted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// How many pieces of it only rise or only fall, from where it begins.
    pub walls: usize,
    /// The heights at which they begin and end, increasing, each once.
    pub heights: Vec<f64>,
    /// The flats that are drawn: height, least and largest radius.
    pub flats: Vec<(f64, [f64; 2])>,
}

/// A wall of a body: squared radius over height. Its body lies on one side of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Where the body is.
    pub side: Side,
    /// Heights, not decreasing: a height that stands twice is a step.
    pub knots: Vec<f32>,
    /// Three Bézier ordinates of the squared radius for each segment and one more, those at joins shared; at a
    /// step both its squared radii, so that there is one more for each step.
    pub ordinates: Vec<f32>,
    /// The squared radius to which a flat leads from the lower end: 0 for a cap, `None` if there is no flat.
    pub base: Option<f32>,
    /// The same at the upper end.
    pub top: Option<f32>,
}

/// On which side of a sheet its body lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// An outer wall: the body is nearer to the axis.
    Outer,
    /// An inner wall: the body is farther from the axis.
    Inner,
}

impl Body {
    /// The number of segments; steps are none.
    pub fn segments(&self) -> usize {
        self.sheets.iter().map(|sheet| sheet.segments().count()).sum()
    }
}

impl Sheet {
    /// A sheet of stretches, each of them segments that are joined, from the lowest up.
    pub(crate) fn new(side: Side, stretches: &[Vec<Segment>]) -> Self {
        let (mut knots, mut ordinates) = (Vec::new(), Vec::new());
        for segment in stretches.iter().flatten() {
            let [z0, z1] = segment.z.map(|z| z as f32);
            let b = segment.b.map(|b| b as f32);
            if ordinates.last() == Some(&b[0]) {
                ordinates.extend_from_slice(&b[1..]);
                knots.push(z1);
            } else {
                ordinates.extend_from_slice(&b);
                knots.extend_from_slice(&[z0, z1]);
            }
        }
        Self { side, knots, ordinates, base: None, top: None }
    }

    /// Its segments from the lowest up, the printed numbers as f64.
    pub fn segments(&self) -> impl Iterator<Item = Segment> {
        let mut at = 0;
        self.knots.windows(2).filter_map(move |z| {
            if z[0] == z[1] {
                at += 1;
                return None;
            }
            let b: [f32; 4] = core::array::from_fn(|j| self.ordinates[at + j]);
            at += 3;
            Some(Segment { z: [z[0], z[1]].map(f64::from), b: b.map(f64::from) })
        })
    }

    /// The squared radius at its lower and at its upper end.
    pub fn ends(&self) -> [f32; 2] {
        [self.ordinates[0], self.ordinates[self.ordinates.len() - 1]]
    }
}
