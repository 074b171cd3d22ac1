//! The tables of `docs/ACCURACY.md` and `docs/SPEED.md`, from the CSV files, each between its two marks.

use crate::boards;
use crate::csv::{costs, rows};
use std::error::Error;
use std::fmt::Write;

const ACCURACY: &str = "docs/ACCURACY.md";
const SPEED: &str = "docs/SPEED.md";

type Text = Result<String, Box<dyn Error>>;

pub fn write() -> Result<(), Box<dyn Error>> {
    insert(ACCURACY, "solvers", &solvers()?)?;
    insert(ACCURACY, "failures", &matrix("docs/solvers.csv", SOLVERS)?)?;
    insert(ACCURACY, "intersections", &matrix("docs/intersections.csv", INTERSECTIONS)?)?;
    insert(ACCURACY, "displacements", &displacements()?)?;
    insert(ACCURACY, "sextic", &sextic()?)?;
    insert(SPEED, "boards", &boards::table()?)
}

/// A line a method: what it gets wrong, and what it costs.
fn solvers() -> Text {
    let files = ["docs/cost-m4f.csv", "docs/cost-m3.csv", "docs/cost-host.csv"];
    let [m4f, m3, host] = files.map(costs);
    let (m4f, m3, host) = (m4f?, m3?, host?);
    let mut text =
        "| method | over | wrong, of 10 000 | median | worst | distance | farthest, separate | M4F | at worst | M3 | host |\n"
            .to_owned();
    text.push_str("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    let rows = rows("docs/solvers.csv")?;
    for row in rows.iter().filter(|row| row[2] == "all") {
        let [method, over, _, answers, wrong, median, _, worst, distance, _] = row.as_slice() else {
            return Err("docs/solvers.csv".into());
        };
        let farthest = farthest(&rows, row, "well separated")?;
        let key = (method.clone(), over.clone());
        let share = 1e4 * wrong.parse::<f64>()? / answers.parse::<f64>()?;
        let whole = |cost: Option<f64>| cost.map_or("–".to_owned(), |cost| format!("{cost:.0}"));
        let [m4f, most] = [m4f.get(&key).map(|c| c.0), m4f.get(&key).map(|c| c.1)].map(whole);
        let [m3, host] = [m3.get(&key), host.get(&key)].map(|cost| whole(cost.map(|c| c.0)));
        let name = if OURS.contains(&method.as_str()) { format!("**{method}**") } else { method.clone() };
        writeln!(
            text,
            "| {name} | {over} | {share:.0} | {median} | {worst} | {distance} | {farthest} | {m4f} | {most} | {m3} | {host} |"
        )?;
    }
    Ok(text)
}

/// How far a row's method strays in one family, where the roots are as well determined as the question.
fn farthest<'a>(rows: &'a [Vec<String>], row: &[String], family: &str) -> Result<&'a str, Box<dyn Error>> {
    let own = rows.iter().find(|other| other[..2] == row[..2] && other[2] == family);
    own.and_then(|own| own.get(9)).map(String::as_str).ok_or_else(|| format!("no {family}").into())
}

const OURS: [&str; 2] = ["split", "Cardano"];

/// A heading, and the methods and backends under it.
type Columns = &'static [(&'static str, &'static [(&'static str, &'static str)])];

const SOLVERS: Columns = &[
    (
        "crate, all",
        &[
            ("split", "native"),
            ("split", "libm"),
            ("split", "micromath"),
            ("split", "std"),
            ("Cardano", "native"),
            ("Cardano", "libm"),
            ("Cardano", "micromath"),
            ("Cardano", "std"),
        ],
    ),
    ("brackets, all", &[("bracketed Newton", "libm"), ("bisection", "libm"), ("recursive", "")]),
    ("textbook libm", &[("textbook Cardano", "libm")]),
    ("textbook micromath", &[("textbook Cardano", "micromath")]),
    ("textbook, Newton step", &[("textbook + Newton step", "libm")]),
    ("Blinn", &[("Blinn", "libm")]),
    ("Kahan", &[("Kahan", "libm")]),
    ("Newton alone", &[("Newton alone", "")]),
    ("kurbo f64", &[("kurbo", "f64")]),
    ("polycool f64", &[("polycool", "f64")]),
    ("roots f64", &[("roots", "f64")]),
];

const INTERSECTIONS: Columns = &[
    ("paper, textbook Cardano", &[("paper", "textbook Cardano")]),
    ("paper, the crate's solver", &[("paper", "split")]),
    ("sound form, textbook Cardano", &[("sound form", "textbook Cardano")]),
    (
        "crate, as asked, and by both solvers over all backends",
        &[
            ("crate", "as asked"),
            ("crate", "split over native"),
            ("crate", "split over std"),
            ("crate", "split over libm"),
            ("crate", "split over micromath"),
            ("crate", "Cardano over native"),
            ("crate", "Cardano over std"),
            ("crate", "Cardano over libm"),
            ("crate", "Cardano over micromath"),
        ],
    ),
];

/// Wrong answers in a thousand, a line a family.
fn matrix(file: &str, columns: Columns) -> Text {
    let rows = rows(file)?;
    let mut families: Vec<&String> = Vec::new();
    for row in &rows {
        if row[2] != "all" && !families.contains(&&row[2]) {
            families.push(&row[2]);
        }
    }
    let mut text = "| wrong, of 1 000 |".to_owned();
    for (heading, _) in columns {
        write!(text, " {heading} |")?;
    }
    write!(text, "\n|---|{}\n", "--:|".repeat(columns.len()))?;
    for family in families {
        write!(text, "| {family} |")?;
        for (_, methods) in columns {
            let (mut answers, mut wrong) = (0.0, 0.0);
            for row in &rows {
                if row[2] == *family && methods.contains(&(row[0].as_str(), row[1].as_str())) {
                    answers += row[3].parse::<f64>()?;
                    wrong += row[4].parse::<f64>()?;
                }
            }
            match 1e3 * wrong / answers {
                0.0 => write!(text, " · |")?,
                share if share < 9.95 => write!(text, " {share:.1} |")?,
                share => write!(text, " {share:.0} |")?,
            }
        }
        writeln!(text)?;
    }
    Ok(text)
}

fn displacements() -> Text {
    let mut text =
        "| form | solver | rays | wrong | median | 99 % | worst | along the ray | farthest, all around |\n"
            .to_owned();
    text.push_str("|---|---|--:|--:|--:|--:|--:|--:|--:|\n");
    let rows = rows("docs/intersections.csv")?;
    for row in rows.iter().filter(|row| row[2] == "all") {
        let [form, solver, _, rays, wrong, median, p99, worst, along, _] = row.as_slice() else {
            return Err("docs/intersections.csv".into());
        };
        let farthest = farthest(&rows, row, "all around")?;
        writeln!(
            text,
            "| {form} | {solver} | {rays} | {wrong} | {median} | {p99} | {worst} | {along} | {farthest} |"
        )?;
    }
    Ok(text)
}

fn sextic() -> Text {
    let mut text = "| polynomial | instructions a solve, host |\n|---|--:|\n".to_owned();
    for row in rows("docs/cost-sextic.csv")? {
        writeln!(text, "| {} | {} |", row[0], row[1])?;
    }
    Ok(text)
}

/// Puts a table between its two marks.
fn insert(file: &str, name: &str, table: &str) -> Result<(), Box<dyn Error>> {
    let page = std::fs::read_to_string(file)?;
    let (from, to) = (format!("<!-- {name} -->\n"), format!("<!-- /{name} -->"));
    let (before, rest) = page.split_once(&from).ok_or_else(|| format!("{file} has no {from}"))?;
    let (_, after) = rest.split_once(&to).ok_or_else(|| format!("{file} has no {to}"))?;
    std::fs::write(file, format!("{before}{from}{table}{to}{after}"))?;
    Ok(())
}
