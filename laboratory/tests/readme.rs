//! README's figures of speed are the record's, docs/instructions.csv.
//!
//! ```text
//! cargo test --test readme                         compares
//! cargo test --test readme -- --ignored write      README's rows, after .ci/record
//! ```

use laboratory::readme;
use std::collections::HashMap;

const RECORD: &str = include_str!("../../docs/instructions.csv");

/// A row of README's table, and the lines of the record that it shows, side by side.
const ROWS: [(&str, &[&str]); 15] = [
    ("vase, a pixel", &["vase"]),
    ("tilted vase, a pixel", &["tilted vase"]),
    ("still life of three solids, a pixel", &["still life"]),
    ("six pawns on a board, a pixel", &["pawns"]),
    ("bowl, a pixel", &["bowl"]),
    ("knob, shiny, a pixel", &["knob"]),
    ("vase of 64 segments, a pixel", &["vase of 64 segments"]),
    ("vase, by `Scene::draw_by_rows`, a pixel", &["vase drawn by rows"]),
    ("vase, by `Scene::draw`, a pixel", &["vase drawn"]),
    ("one ray against the vase", &["ray at the vase"]),
    ("one ray against 64 segments", &["ray at 64 segments"]),
    ("first root of a cubic: `Split<Native>`", &["split native"]),
    ("`Split<Libm>` / `Split<Micromath>`", &["split libm", "split micromath"]),
    ("`Cardano<Native>`", &["cardano native"]),
    ("`Cardano<Libm>` / `Cardano<Micromath>`", &["cardano libm", "cardano micromath"]),
];

/// A line of the record.
#[derive(Clone, Copy)]
struct Line {
    pixels: f64,
    hits: f64,
    instructions: f64,
    /// Estimated for the Cortex-M4F alone.
    cycles: Option<f64>,
}

/// By machine and scene.
fn record() -> HashMap<(&'static str, &'static str), Line> {
    let lines = RECORD.lines().filter(|line| !line.starts_with('#')).skip(1);
    let line = |line: &'static str| {
        let cells: Vec<_> = line.split(',').collect();
        let [machine, scene, pixels, hits, instructions, _, _, cycles, _] = cells.as_slice() else {
            panic!("nine columns: {line}")
        };
        let number = |cell: &str| cell.parse::<f64>().expect("a number");
        let [pixels, hits, instructions] = [pixels, hits, instructions].map(|cell| number(cell));
        ((*machine, *scene), Line { pixels, hits, instructions, cycles: cycles.parse().ok() })
    };
    lines.map(line).collect()
}

/// Rounded, thousands set apart.
fn whole(number: f64) -> String {
    let number = number.round() as u64;
    if number < 1000 { number.to_string() } else { format!("{} {:03}", number / 1000, number % 1000) }
}

/// Titles and cells.
fn rows() -> Vec<(String, Vec<String>)> {
    let record = record();
    let cells = |scenes: &[&str]| {
        let lines: Vec<_> = scenes.iter().map(|scene| record[&("m4f", *scene)]).collect();
        let side_by_side =
            |of: fn(&Line) -> f64| lines.iter().map(of).map(whole).collect::<Vec<_>>().join(" / ");
        vec![
            side_by_side(|line| line.instructions / line.pixels),
            side_by_side(|line| line.cycles.expect("an M4F's") / line.pixels),
        ]
    };
    let mut rows: Vec<_> = ROWS.iter().map(|(title, scenes)| (title.to_string(), cells(scenes))).collect();
    // Of as many roots as the crate finds.
    let [ours, textbook] = ["split native", "textbook libm"].map(|scene| record[&("m4f", scene)].hits);
    let title = format!("textbook Cardano over libm, which misses {} of {ours} roots", ours - textbook);
    rows.push((title, cells(&["textbook libm"])));
    rows
}

#[test]
fn the_readme_shows_the_record() {
    let text = readme::text();
    for (title, cells) in rows() {
        assert_eq!(readme::row(&text, &title), cells, "{title}: cargo test --test readme -- --ignored write");
    }
    let vase = record()[&("m3", "vase")];
    let soft = format!("takes {} instructions", whole(vase.instructions / vase.pixels));
    assert!(text.contains(&soft), "README.md does not say that a pixel of the vase {soft} on an M3");
}

#[test]
#[ignore = "writes README.md"]
fn write() {
    rows().iter().for_each(|(title, cells)| readme::write(title, cells));
}
