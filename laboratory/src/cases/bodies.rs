//! Bodies bounded by several sheets.

use super::{Outline, outline};
use crate::oracle::{Ray, Shape, bands, crossings};

/// Sheets about one axis: each an outline, and whether the material is outside of it.
pub struct Body {
    pub name: &'static str,
    pub sheets: Vec<(Outline, bool)>,
}

/// A crossing that a ray must have, and the sheet that it is of.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    pub from: f64,
    pub to: f64,
    pub enters: bool,
    pub sheet: usize,
}

impl Body {
    pub fn shapes(&self) -> Vec<Shape> {
        self.sheets.iter().map(|(outline, _)| outline.shape()).collect()
    }

    /// Height or largest diameter, whichever is more.
    pub fn size(&self) -> f64 {
        let shapes = self.shapes();
        let low = shapes.iter().map(Shape::base).fold(f64::INFINITY, f64::min);
        let high = shapes.iter().map(Shape::top).fold(f64::NEG_INFINITY, f64::max);
        let widest = shapes.iter().map(Shape::widest).fold(0.0, f64::max);
        (high - low).max(2.0 * widest)
    }

    /// All crossings, in order, if no displacement below `eps` changes them or their order.
    pub fn crossings(&self, ray: &Ray, eps: f64) -> Option<Vec<Expected>> {
        let mut all = Vec::new();
        for (sheet, (outline, is_inner)) in self.sheets.iter().enumerate() {
            let shape = outline.shape();
            let bands = bands(&shape, ray, eps);
            if !bands.complete || bands.sure.len() != crossings(&shape, ray).len() {
                return None;
            }
            all.extend(bands.sure.iter().map(|band| Expected {
                from: band.from,
                to: band.to,
                enters: band.enters != *is_inner,
                sheet,
            }));
        }
        all.sort_by(|a, b| a.from.total_cmp(&b.from));
        all.is_sorted_by(|a, b| a.to < b.from).then_some(all)
    }

    /// How many outer sheets hold a point, less the inner ones.
    pub fn depth(&self, point: [f64; 3]) -> i32 {
        let held = self.sheets.iter().filter(|(outline, _)| outline.shape().inside(point));
        held.map(|(_, is_inner)| if *is_inner { -1 } else { 1 }).sum()
    }
}

fn sheet(knots: &[f32], ordinates: &[f32]) -> Outline {
    Outline {
        name: "sheet",
        knots: knots.to_vec(),
        ordinates: ordinates.to_vec(),
        k: 1.0,
        base_closed: false,
        top_closed: false,
    }
}

fn capped(outline: Outline) -> Outline {
    Outline { base_closed: true, ..outline }
}

fn squashed(body: Body, name: &'static str, k: f32) -> Body {
    let sheets = body.sheets.into_iter().map(|(outline, is_inner)| (Outline { k, ..outline }, is_inner));
    Body { name, sheets: sheets.collect() }
}

pub fn bodies() -> Vec<Body> {
    vec![
        cup(),
        squashed(cup(), "elliptic cup", 0.4),
        bowl(),
        wine_glass(),
        torus(),
        washer(),
        bottle(),
        mushroom(),
        shell(),
        lifted_bowl(),
    ]
}

/// A flat rim, which belongs to the outer wall.
fn cup() -> Body {
    let wall = capped(sheet(&[0.0, 1.0, 1.0], &[0.16, 0.2, 0.22, 0.25, 0.2]));
    let hollow = capped(sheet(&[0.1, 1.0], &[0.12, 0.16, 0.18, 0.2]));
    Body { name: "cup", sheets: vec![(wall, false), (hollow, true)] }
}

/// Two walls that meet in an edge.
fn bowl() -> Body {
    let wall = sheet(&[0.0, 0.4], &[0.0, 0.2, 0.35, 0.36]);
    let hollow = sheet(&[0.05, 0.4], &[0.0, 0.16, 0.3, 0.36]);
    Body { name: "bowl", sheets: vec![(wall, false), (hollow, true)] }
}

/// Beside heights that are large.
fn lifted_bowl() -> Body {
    let mut body = bowl();
    for (outline, _) in &mut body.sheets {
        outline.knots.iter_mut().for_each(|z| *z += 30.0);
    }
    Body { name: "lifted bowl", ..body }
}

/// A foot, a stem, and a hollow whose rim is an edge.
fn wine_glass() -> Body {
    let ordinates = [0.09, 0.09, 0.09, 0.09, 0.004, 0.004, 0.004, 0.004, 0.1, 0.16, 0.12];
    let wall = capped(sheet(&[0.0, 0.03, 0.03, 0.5, 1.0], &ordinates));
    let hollow = sheet(&[0.55, 1.0], &[0.0, 0.08, 0.14, 0.12]);
    Body { name: "wine glass", sheets: vec![(wall, false), (hollow, true)] }
}

/// A ring, closed: its outer half and its inner half meet in two edges.
fn torus() -> Body {
    let outer = sheet(&[-0.25, 0.25], &[0.25, 0.62, 0.62, 0.25]);
    let inner = sheet(&[-0.25, 0.25], &[0.25, 0.05, 0.05, 0.25]);
    Body { name: "torus", sheets: vec![(outer, false), (inner, true)] }
}

/// Both faces belong to the wall of the hole.
fn washer() -> Body {
    let outer = sheet(&[0.0, 0.1], &[0.25; 4]);
    let hole = sheet(&[0.0, 0.0, 0.1, 0.1], &[0.25, 0.09, 0.09, 0.09, 0.09, 0.25]);
    Body { name: "washer", sheets: vec![(outer, false), (hole, true)] }
}

/// A punt from below, whose rim belongs to the wall, and a hollow from above, whose bottom is over it.
fn bottle() -> Body {
    let ordinates = [0.1, 0.2, 0.2, 0.2, 0.2, 0.19, 0.02, 0.02, 0.02, 0.02, 0.02, 0.014];
    let wall = sheet(&[0.0, 0.0, 0.6, 0.9, 1.2, 1.2], &ordinates);
    let punt = sheet(&[0.0, 0.2], &[0.1, 0.08, 0.05, 0.0]);
    let hollow = capped(sheet(
        &[0.25, 0.6, 0.9, 1.2],
        &[0.15, 0.17, 0.17, 0.18, 0.16, 0.014, 0.014, 0.014, 0.014, 0.014],
    ));
    Body { name: "bottle", sheets: vec![(wall, false), (punt, true), (hollow, true)] }
}

/// A stem, and a cap with an undercut: its underside comes down beside the stem.
fn mushroom() -> Body {
    let cap = sheet(&[0.4, 0.9], &[0.36, 0.4, 0.3, 0.0]);
    let stem = capped(sheet(&[0.0, 0.5], &[0.04, 0.03, 0.03, 0.04]));
    let underside = sheet(&[0.4, 0.5, 0.5], &[0.36, 0.3, 0.3, 0.25, 0.04]);
    Body { name: "mushroom", sheets: vec![(cap, false), (stem, false), (underside, true)] }
}

/// A hollow ball.
fn shell() -> Body {
    let hollow = sheet(&[-1.25, 1.25], &[0.0, 2.083_333_3, 2.083_333_3, 0.0]);
    Body { name: "shell", sheets: vec![(outline("sphere"), false), (hollow, true)] }
}
