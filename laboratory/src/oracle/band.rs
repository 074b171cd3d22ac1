//! How much the surface may be off before the list of crossings changes.
//!
//! Call a point *in* if every point within `eps` of it lies in the solid, *out* if none does. Moving a point by `eps` moves
//! g by no more than `eps·(2·ρ + |df/dz|) + eps²`, ρ² = k·x² + y² and the slope the largest within `eps` in height;
//! so g beyond that bound decides, and the bound exceeds `eps·|∇g|` by no more than √2 where f is nearly straight over `eps`.
//! Within `eps` of an end plane nothing is in. What is neither is a *band*.
//!
//! Anyone who displaces the ray, its start, the wall or the ends by less than `eps` in all must see the same in and out.
//! A band between out and in is therefore crossed, in all, once, and a hit reported there is right; a band between
//! two outs or two ins (a near tangency), one that wall and end share (a rim), and one that the start lies in prove nothing.

use super::bernstein::{self, Cubic, lerp};
use super::crossing::{Part, crossings};
use super::line::{Line, Ray};
use super::shape::Shape;

/// A stretch of the ray that holds a crossing, whoever looks.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    pub from: f64,
    pub to: f64,
    pub enters: bool,
    pub part: Part,
}

/// The bands up to the first doubtful one.
#[derive(Clone, Debug)]
pub struct Bands {
    pub sure: Vec<Band>,
    /// No doubtful one follows: these are all. Empty and complete is a sure miss.
    pub complete: bool,
}

/// Whether no displacement below `eps` changes the list of crossings.
pub fn robust(shape: &Shape, ray: &Ray, eps: f64) -> bool {
    bands(shape, ray, eps).complete
}

/// Whether the list of [`crossings`] is beyond the oracle's own rounding: robust at 1e-12 of the size, one crossing a band.
pub fn certain(shape: &Shape, ray: &Ray) -> bool {
    let bands = bands(shape, ray, 1e-12 * shape.size());
    let list = crossings(shape, ray);
    let agree = |(band, at): (&Band, &super::Crossing)| {
        (band.from..=band.to).contains(&at.t) && band.enters == at.enters && band.part == at.part
    };
    bands.complete && bands.sure.len() == list.len() && bands.sure.iter().zip(&list).all(agree)
}

/// The bands of `t > t_min` at this `eps` in object units, in order. Passing an open end is a band too, but not listed.
pub fn bands(shape: &Shape, ray: &Ray, eps: f64) -> Bands {
    let line = Line::new(shape, ray);
    let mut walk = Walk { shape, line: &line, eps, runs: Vec::new() };
    let start = ray.t_min - line.t0;
    walk.push(Run::sure(Side::Out, start.min(0.0)));
    let reach = line.within(shape.widest() + eps).and_then(|span| walk.reach(span));
    if let Some([from, to]) = reach.filter(|&[_, to]| to > start) {
        if from <= start {
            walk.runs.clear();
        }
        walk.all(from.max(start), to);
        // A line along the sheet goes on for ever as it is.
        if to.is_finite() {
            walk.push(Run::sure(Side::Out, to));
        }
    }
    walk.judge()
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Side {
    In,
    Out,
    Either,
}

/// A stretch of one side; for `Either`, what may be crossed there.
#[derive(Clone, Copy, Debug)]
struct Run {
    side: Side,
    wall: bool,
    base: bool,
    top: bool,
    s: [f64; 2],
}

impl Run {
    fn sure(side: Side, s: f64) -> Self {
        Run { side, wall: false, base: false, top: false, s: [s, s] }
    }
}

struct Walk<'a> {
    shape: &'a Shape,
    line: &'a Line,
    eps: f64,
    runs: Vec<Run>,
}

impl Walk<'_> {
    fn push(&mut self, run: Run) {
        match self.runs.last_mut() {
            Some(last) if last.side == run.side => {
                last.s[1] = run.s[1];
                last.wall |= run.wall;
                last.base |= run.base;
                last.top |= run.top;
            }
            _ => self.runs.push(run),
        }
    }

    /// The part of the span between the end planes, each moved out by eps.
    fn reach(&self, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let (low, high) = (self.shape.base() - self.eps, self.shape.top() + self.eps);
        if self.line.horizontal() {
            return (low..=high).contains(&self.line.near[2]).then_some([from, to]);
        }
        let (a, b) = (self.line.at_height(low), self.line.at_height(high));
        let (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
        (from < to).then_some([from, to])
    }

    /// Every height at which g, or what it means, changes its formula.
    fn planes(&self) -> Vec<f64> {
        let (base, top) = (self.shape.base(), self.shape.top());
        let mut planes = self.shape.knots.clone();
        planes.extend([base - self.eps, base + self.eps, top - self.eps, top + self.eps]);
        planes
    }

    fn all(&mut self, from: f64, to: f64) {
        if self.line.horizontal() {
            // Along the sheet all places are alike.
            let [from, to] = if to.is_finite() { [from, to] } else { [0.0, 0.0] };
            return self.piece(from, to, 0);
        }
        let mut cuts: Vec<f64> = self.planes().iter().map(|&z| self.line.at_height(z)).collect();
        cuts.retain(|&s| from < s && s < to);
        cuts.extend([from, to]);
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2).filter(|pair| pair[0] < pair[1]) {
            self.piece(pair[0], pair[1], 0);
        }
    }

    /// How much g may change within eps of the points between two parameters.
    fn tolerance(&self, s0: f64, s1: f64) -> f64 {
        let (z0, z1) = (self.line.point(s0)[2], self.line.point(s1)[2]);
        let slope = self.shape.steepest(z0.min(z1) - self.eps, z0.max(z1) + self.eps);
        // k·x² + y² is convex along the line: largest at an end.
        let rho = self.line.squared_distance(s0).max(self.line.squared_distance(s1)).sqrt();
        self.eps * (2.0 * rho + slope + self.eps)
    }

    fn ordinates(&self, s0: f64, s1: f64) -> Cubic {
        let middle = self.line.point(lerp(s0, s1, 0.5))[2];
        let segment = self.shape.locate(middle).0;
        let (z, h) = (self.shape.knots[segment], self.shape.knots[segment + 1] - self.shape.knots[segment]);
        bernstein::through(std::array::from_fn(|i| {
            let s = lerp(s0, s1, i as f64 / 3.0);
            let u = ((self.line.point(s)[2] - z) / h).clamp(0.0, 1.0);
            bernstein::value(self.shape.squared_radius(segment), u) - self.line.squared_distance(s)
        }))
    }

    fn piece(&mut self, s0: f64, s1: f64, depth: u32) {
        let g = self.ordinates(s0, s1);
        let (low, high) = g.iter().fold((f64::MAX, f64::MIN), |(low, high), &g| (low.min(g), high.max(g)));
        let tolerance = self.tolerance(s0, s1);
        let middle = lerp(s0, s1, 0.5);
        let z = self.line.point(middle)[2];
        // An end of no radius is a pole: the wall closes by itself.
        let ends_at = |knot: usize| {
            self.shape.ordinates[3 * knot] > 0.0 && (z - self.shape.knots[knot]).abs() <= self.eps
        };
        let (base, top) = (ends_at(0), ends_at(self.shape.segments()));
        let either = |wall| Run { side: Side::Either, wall, base, top, s: [s0, s1] };
        let sure = |side| Run { s: [s0, s1], ..Run::sure(side, s0) };
        if high < -tolerance {
            return self.push(sure(Side::Out));
        }
        if low > tolerance {
            return self.push(if base || top { either(false) } else { sure(Side::In) });
        }
        // To call a stretch a band is always sound; this is how finely it is worth deciding.
        let about = self.tolerance(middle, middle);
        if low.abs().max(high.abs()) <= about
            || (high - low <= about / 4.0 && tolerance <= 1.5 * about)
            || depth == 40
        {
            return self.push(either(true));
        }
        self.piece(s0, middle, depth + 1);
        self.piece(middle, s1, depth + 1);
    }

    fn judge(self) -> Bands {
        let mut sure = Vec::new();
        let mut complete = self.runs.first().is_some_and(|run| run.side != Side::Either);
        let mut before = self.runs.first().map(|run| run.side);
        let mut rest = self.runs.get(1..).unwrap_or_default();
        while complete && let [band, after, others @ ..] = rest {
            let single = band.wall as u8 + band.base as u8 + band.top as u8 == 1;
            complete = band.side == Side::Either
                && single
                && after.side != Side::Either
                && Some(after.side) != before;
            if complete {
                let (part, open) = match (band.base, band.top) {
                    (true, _) => (Part::Base, !self.shape.base_closed),
                    (_, true) => (Part::Top, !self.shape.top_closed),
                    _ => (Part::Wall, false),
                };
                if !open {
                    let [from, to] = band.s.map(|s| self.line.t0 + s);
                    sure.push(Band { from, to, enters: after.side == Side::In, part });
                }
            }
            (before, rest) = (Some(after.side), others);
        }
        Bands { sure, complete: complete && rest.is_empty() }
    }
}
