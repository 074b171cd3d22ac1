//! Method by family: how many answers are wrong, and how wrong.

use crate::progress::bar;
use laboratory::contenders::{EVERYWHERE, HOST};
use laboratory::families::FAMILIES;
use laboratory::judge::Truth;
use laboratory::peers::PEERS;
use laboratory::tally::Tally;
use laboratory::troubles::Trouble;
use laboratory::{DISPLACEMENT, WRONG, forms, hits};
use std::error::Error;
use std::fmt::Write;

const SEED: u64 = 1995;
/// Questions a family, and rays a trouble.
const QUESTIONS: u64 = 4000;
const RAYS: u64 = 2000;

pub fn write() -> Result<(), Box<dyn Error>> {
    let solvers = solvers();
    std::fs::write("docs/solvers.csv", csv(&solvers, "family", WRONG)?)?;
    let intersections = intersections();
    std::fs::write("docs/intersections.csv", csv(&intersections, "trouble", DISPLACEMENT)?)?;
    Ok(())
}

/// Rows are methods, columns families; each method with its backend.
struct Table {
    columns: Vec<&'static str>,
    rows: Vec<(String, String, Vec<Tally>)>,
}

impl Table {
    fn new(methods: Vec<(String, String)>, columns: Vec<&'static str>) -> Self {
        let empty = vec![Tally::default(); columns.len()];
        let rows = methods.into_iter().map(|(method, backend)| (method, backend, empty.clone())).collect();
        Self { columns, rows }
    }
}

fn solvers() -> Table {
    let methods = EVERYWHERE.iter().chain(HOST).map(|c| (c.method.to_owned(), c.backend.to_owned()));
    let peers = PEERS.iter().map(|peer| (peer.name.to_owned(), "f64".to_owned()));
    let names = FAMILIES.iter().map(|family| family.name).collect();
    let mut table = Table::new(methods.chain(peers).collect(), names);
    let bar = bar(QUESTIONS * FAMILIES.len() as u64, "solvers");
    for (column, family) in FAMILIES.iter().enumerate() {
        for index in 0..QUESTIONS {
            let question = family.question(SEED, index);
            let (c, lo, hi) = (question.c, question.lo, question.hi);
            let truth = Truth::new(&c, lo, hi);
            let singles = EVERYWHERE.iter().chain(HOST).map(|m| (m.first_root)(&c, lo, hi).map(f64::from));
            let doubles = PEERS.iter().map(|m| (m.first_root)(c.map(f64::from), lo.into(), hi.into()));
            for (row, answer) in table.rows.iter_mut().zip(singles.chain(doubles)) {
                let verdict = truth.judge(answer);
                row.2[column].add(verdict.units, verdict.distance);
            }
            bar.inc(1);
        }
    }
    bar.finish();
    table
}

fn intersections() -> Table {
    let troubles = Trouble::all();
    let methods = forms::METHODS.iter().map(|(form, solver, _)| (form.to_string(), solver.to_string()));
    let mut table = Table::new(methods.collect(), troubles.iter().map(|t| t.name).collect());
    let bar = bar(RAYS * troubles.len() as u64, "intersections");
    for (column, trouble) in troubles.iter().enumerate() {
        for index in 0..RAYS {
            let case = trouble.case(SEED, index);
            let truth = hits::Truth::new(&case);
            for (row, (_, _, nearest)) in table.rows.iter_mut().zip(forms::METHODS) {
                let answer = nearest(case.outline, &case.cast);
                row.2[column].add(truth.judge(answer), truth.distance(answer));
            }
            bar.inc(1);
        }
    }
    bar.finish();
    table
}

fn csv(table: &Table, column: &str, wrong: f64) -> Result<String, std::fmt::Error> {
    let mut csv = format!("method,backend,{column},answers,wrong,median,p99,worst,distance,farthest\n");
    for (method, backend, tallies) in &table.rows {
        let mut all = Tally::default();
        tallies.iter().for_each(|tally| all.merge(tally));
        let names = table.columns.iter().copied().chain(["all"]);
        for (name, tally) in names.zip(tallies.iter().chain([&all])) {
            let (count, beyond) = (tally.count(), tally.beyond(wrong));
            let [median, p99, worst] = [tally.median(), tally.quantile(0.99), tally.worst()].map(figure);
            let [distance, farthest] = tally.distances().map(figure);
            writeln!(
                csv,
                "{method},{backend},\"{name}\",{count},{beyond},{median},{p99},{worst},{distance},{farthest}"
            )?;
        }
    }
    Ok(csv)
}

/// Three significant figures at most.
fn figure(units: f64) -> String {
    match units {
        u if u.is_infinite() => "∞".to_owned(),
        0.0 => "0".to_owned(),
        u if u < 0.01 || u >= 1e5 => format!("{u:.0e}"),
        u if u < 10.0 => format!("{u:.2}"),
        u => format!("{u:.0}"),
    }
}
