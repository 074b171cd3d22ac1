//! The figures in README.md's tables: each is measured somewhere, and held to what was measured.

use crate::firmware::ROOT;
use std::{env, fs};

fn path() -> String {
    format!("{ROOT}/README.md")
}

pub fn text() -> String {
    fs::read_to_string(path()).expect("README.md")
}

/// The cells of a table's row behind its title. Titles are unique.
pub fn row(text: &str, title: &str) -> Vec<String> {
    let start = format!("| {title} |");
    let rows: Vec<_> = text.lines().filter_map(|line| line.strip_prefix(&start)).collect();
    let [row] = rows.as_slice() else { panic!("README.md has {} rows {title:?}", rows.len()) };
    row.trim_end_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
}

/// Writes a row anew.
pub fn write(title: &str, cells: &[String]) {
    let start = format!("| {title} |");
    let anew = format!("{start} {} |", cells.join(" | "));
    let lines: Vec<_> = text()
        .lines()
        .map(|line| if line.starts_with(&start) { anew.clone() } else { line.to_owned() })
        .collect();
    fs::write(path(), lines.join("\n") + "\n").expect("README.md is written");
}

/// How far code's size may be from README's: versions of a compiler differ by as much.
pub const TOLERANCE: f64 = 0.03;

/// Compares a row's cells with what was measured, and returns what differs.
///
/// A cell is a dash, or what depends on the compiler, held to [`TOLERANCE`], and the RAM beside it, held exactly:
/// `123 / 45`. A compiler other than rustup's (`FIRMWARE_CARGO`) makes other code: what differs then is printed, and
/// not returned.
pub fn compare(title: &str, measured: &[String]) -> Vec<String> {
    let written = row(&text(), title);
    assert_eq!(written.len(), measured.len(), "{title}: README.md has {written:?}, measured {measured:?}");
    let agree = |was: &str, is: &str| {
        let [(code, ram), (measured, its_ram)] =
            [was, is].map(|cell| cell.split_once(" / ").unwrap_or((cell, "")));
        let near = |was: f64, is: f64| (is - was).abs() <= TOLERANCE * was;
        let is_near = match [code, measured].map(str::parse) {
            [Ok(was), Ok(is)] => near(was, is),
            _ => code == measured,
        };
        is_near && ram == its_ram
    };
    let wrong = written.iter().zip(measured).filter(|(was, is)| !agree(was, is));
    let wrong: Vec<_> =
        wrong.map(|(was, is)| format!("{title}: {is} measured, {was} in README.md")).collect();
    if env::var_os("FIRMWARE_CARGO").is_none() {
        return wrong;
    }
    wrong.iter().for_each(|line| println!("not held, another compiler: {line}"));
    Vec::new()
}
