//! Solvers: cost against error. Across, instructions a solve, the mean over the workload's families; up, wrong answers in
//! 10 000, over all families.

use crate::csv::{Method, costs, rows};
use crate::plot::{self, Axis, Panel, Point};
use laboratory::WRONG;
use plotters::style::RGBColor;
use std::collections::BTreeMap;
use std::error::Error;

const SHIPPED: RGBColor = RGBColor(200, 60, 30);
const CARDANO: RGBColor = RGBColor(215, 140, 20);
const RIVAL: RGBColor = RGBColor(50, 90, 150);
const PEER: RGBColor = RGBColor(90, 140, 60);

/// A contender: a method and where its functions come from.
struct Contender {
    method: String,
    backend: String,
    cost: f64,
    wrong: f64,
}

pub fn write() -> Result<(), Box<dyn Error>> {
    let wrong = wrong()?;
    let panel = |title, file| -> Result<Panel, Box<dyn Error>> {
        let contenders = contenders(file, &wrong)?;
        Ok(Panel {
            title,
            across: "instructions a solve".to_owned(),
            up: Axis {
                title: format!("answers off by more than {WRONG} units, in 10 000"),
                range: 1.0..20_000.0,
                has_none: true,
            },
            points: contenders.iter().map(|contender| contender.point(&contenders)).collect(),
        })
    };
    plot::draw(
        "docs/cost-and-error.svg",
        &[
            panel("On a Cortex-M4F", "docs/cost-m4f.csv")?,
            panel("On the host, x86-64", "docs/cost-host.csv")?,
        ],
    )?;
    plot::draw(
        "docs/cost-and-error-soft-float.svg",
        &[panel("On a Cortex-M3, in software floating point", "docs/cost-m3.csv")?],
    )
}

/// Wrong answers in 10 000.
fn wrong() -> Result<BTreeMap<Method, f64>, Box<dyn Error>> {
    let mut shares = BTreeMap::new();
    for row in rows("docs/solvers.csv")?.into_iter().filter(|row| row[2] == "all") {
        let share = 1e4 * row[4].parse::<f64>()? / row[3].parse::<f64>()?;
        shares.insert((row[0].clone(), row[1].clone()), share);
    }
    Ok(shares)
}

fn contenders(file: &str, wrong: &BTreeMap<Method, f64>) -> Result<Vec<Contender>, Box<dyn Error>> {
    let contender = |((method, backend), (cost, _)): (Method, (f64, f64))| {
        let wrong = *wrong.get(&(method.clone(), backend.clone()))?;
        Some(Contender { method, backend, cost, wrong })
    };
    Ok(costs(file)?.into_iter().filter_map(contender).collect())
}

impl Contender {
    fn point(&self, all: &[Self]) -> Point {
        Point { label: self.label(all), color: self.color(), cost: self.cost, error: self.wrong }
    }

    fn color(&self) -> RGBColor {
        match (self.method.as_str(), self.backend.as_str()) {
            ("split", _) => SHIPPED,
            ("Cardano", _) => CARDANO,
            (_, "f64") => PEER,
            _ => RIVAL,
        }
    }

    fn is_shipped(&self) -> bool {
        ["split", "Cardano"].contains(&self.method.as_str())
    }

    /// The crate's methods by name where they are cheapest, elsewhere by their backend alone: they have their own colors.
    fn label(&self, all: &[Self]) -> String {
        let others = all.iter().filter(|other| other.method == self.method);
        let cheapest = others.fold(f64::INFINITY, |cheapest, other| cheapest.min(other.cost));
        let backend = self.backend.as_str();
        match (self.is_shipped(), backend) {
            (true, _) if self.cost > 1.02 * cheapest => backend.to_owned(),
            (true, _) => format!("crate: {}, {backend}", self.method),
            (_, "") => self.method.clone(),
            _ => format!("{}, {backend}", self.method),
        }
    }
}
