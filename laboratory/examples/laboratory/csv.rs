//! The files that the commands hand to one another.

use std::collections::BTreeMap;
use std::error::Error;

/// A method and where its functions come from.
pub type Method = (String, String);

/// The fields of the lines below the head. Only names of families are quoted, and may hold commas.
pub fn rows(file: &str) -> Result<Vec<Vec<String>>, Box<dyn Error>> {
    let text = std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let fields = |line: &str| {
        let mut parts = line.split('"');
        match (parts.next(), parts.next(), parts.next()) {
            (Some(before), Some(quoted), Some(after)) => {
                let before = before.strip_suffix(',').unwrap_or(before).split(',');
                let after = after.strip_prefix(',').unwrap_or(after).split(',');
                before.chain([quoted]).chain(after).map(str::to_owned).collect()
            }
            _ => line.split(',').map(str::to_owned).collect(),
        }
    };
    Ok(text.lines().skip(1).map(fields).collect())
}

/// Instructions a solve: the mean over the families, and the worst.
pub fn costs(file: &str) -> Result<BTreeMap<Method, (f64, f64)>, Box<dyn Error>> {
    let mut costs: BTreeMap<Method, Vec<(f64, f64)>> = BTreeMap::new();
    for row in rows(file)? {
        let [method, backend, _, mean, worst] = row.as_slice() else {
            return Err(file.into());
        };
        let cost = (mean.parse()?, worst.parse().unwrap_or(f64::NAN));
        costs.entry((method.clone(), backend.clone())).or_default().push(cost);
    }
    let sum = |costs: Vec<(f64, f64)>| {
        let mean = costs.iter().map(|cost| cost.0).sum::<f64>() / costs.len() as f64;
        (mean, costs.iter().map(|cost| cost.1).fold(f64::NAN, f64::max))
    };
    Ok(costs.into_iter().map(|(method, costs)| (method, sum(costs))).collect())
}

/// The columns of docs/instructions.csv with instructions a pixel and with cycles a pixel.
pub const INSTRUCTIONS: usize = 5;
pub const CYCLES: usize = 8;

/// A number of docs/instructions.csv, by its line's machine and scene, and its column.
pub fn recorded(machine: &str, scene: &str, column: usize) -> Result<f64, Box<dyn Error>> {
    let lines = rows("docs/instructions.csv")?;
    let line = lines.iter().find(|row| row[0] == machine && row.get(1).is_some_and(|name| name == scene));
    let line = line.ok_or_else(|| format!("docs/instructions.csv has no {scene} on {machine}"))?;
    Ok(line[column].parse()?)
}
