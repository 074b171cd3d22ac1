//! What a frame costs, drawn whole and by the rectangle that has changed: docs/REDRAW.md has what the emulated machines count.
//!
//! ```text
//! cargo test -p embedded-lathe-laboratory --test redraw -- --ignored --skip write       needs qemu-system-arm, gcc and two targets
//! cargo test -p embedded-lathe-laboratory --test redraw -- --ignored write              docs/REDRAW.md's table
//! ```

use laboratory::firmware::{self, M3, M4F, RELEASE, ROOT};
use std::{fs, path::Path, process::Command};

/// A line that the firmware prints.
struct Line {
    scene: String,
    drawn: String,
    pixels: u64,
    instructions: u64,
}

/// How many frames the firmware draws in each of m4cycles' regions.
const FRAMES: u64 = 24;

/// How much more or less than the table a count may be: as the record's.
const TOLERANCE: f64 = 0.05;

/// What the firmware prints on a machine, and what QEMU writes beside it.
fn run(target: &str, plugin: &str) -> (Vec<Line>, String) {
    let output = Command::new(Path::new(ROOT).join(".cargo/run-firmware"))
        .env("QEMU_ARGS", plugin)
        .arg(firmware::build(target, "redraw", RELEASE, &[]))
        .output()
        .expect("the runner starts");
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    let lines = text.lines().skip(1).map(|line| {
        let cells: Vec<_> = line.split(',').collect();
        let [scene, drawn, pixels, instructions] = cells[..] else { panic!("{line}") };
        let [pixels, instructions] = [pixels, instructions].map(|number| number.parse().unwrap());
        Line { scene: scene.into(), drawn: drawn.into(), pixels, instructions }
    });
    (lines.collect(), String::from_utf8(output.stderr).unwrap())
}

/// The table's cells: pixels, instructions and cycles on the M4F, pixels and instructions on the M3; one row for each line.
fn measured() -> Vec<(String, [u64; 5])> {
    let plugin = Path::new(env!("CARGO_TARGET_TMPDIR")).join("m4cycles.so");
    let built = Command::new("gcc")
        .args(["-O2", "-shared", "-fPIC", "-o"])
        .arg(&plugin)
        .arg(Path::new(ROOT).join("examples/bench/m4cycles.c"))
        .status()
        .expect("gcc starts");
    assert!(built.success());
    let (m4f, regions) = run(M4F, &format!("-plugin {}", plugin.display()));
    let (m3, _) = run(M3, "");
    // Each region is a line: its number, its instructions, its cycles.
    let cycles = regions.lines().filter_map(|line| {
        let mut cells = line.split(',');
        let _: u64 = cells.next()?.parse().ok()?;
        cells.nth(1)?.parse::<u64>().ok()
    });
    let cycles: Vec<_> = cycles.map(|cycles| cycles / FRAMES).collect();
    assert_eq!((cycles.len(), m3.len()), (m4f.len(), m4f.len()), "{regions}");
    let rows = m4f.iter().zip(&m3).zip(cycles);
    rows.map(|((a, b), cycles)| {
        assert_eq!((&a.scene, &a.drawn), (&b.scene, &b.drawn));
        (format!("{}, {}", a.scene, a.drawn), [a.pixels, a.instructions, cycles, b.pixels, b.instructions])
    })
    .collect()
}

fn page() -> String {
    fs::read_to_string(Path::new(ROOT).join("docs/REDRAW.md")).unwrap()
}

/// Digits in groups of three.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<_> =
        digits.as_bytes().rchunks(3).rev().map(|group| str::from_utf8(group).unwrap()).collect();
    groups.join(" ")
}

fn row(title: &str, cells: &[u64; 5]) -> String {
    format!("| {title} | {} |", cells.map(grouped).join(" | "))
}

/// The numbers of a row of the page.
fn written(page: &str, title: &str) -> [u64; 5] {
    let start = format!("| {title} |");
    let line =
        page.lines().find_map(|line| line.strip_prefix(&start)).unwrap_or_else(|| panic!("no row {title:?}"));
    let numbers = line.trim_end_matches('|').split('|').map(|cell| cell.replace(' ', "").parse().unwrap());
    numbers.collect::<Vec<_>>().try_into().unwrap()
}

#[test]
#[ignore = "needs qemu-system-arm, gcc and two targets"]
fn a_frame_costs_what_the_page_says() {
    let page = page();
    for (title, cells) in measured() {
        println!("{}", row(&title, &cells));
        for (is, was) in cells.into_iter().zip(written(&page, &title)) {
            assert!(
                (is as f64 - was as f64).abs() <= TOLERANCE * was as f64,
                "{title}: {is}, {was} in docs/REDRAW.md"
            );
        }
    }
}

#[test]
fn the_page_has_all_rows() {
    for scene in ["turning knob", "moving ball"] {
        let [whole, rectangle] =
            ["whole", "rectangle"].map(|drawn| written(&page(), &format!("{scene}, {drawn}")));
        assert_eq!((whole[0], whole[3]), (240 * 240, 128 * 64));
        // On the Cortex-M3 the ball's rectangle takes 36 % of the whole: its rows are short, and each sets up both solids.
        assert!((0..5).all(|i| 2 * rectangle[i] < whole[i]), "{scene}: {rectangle:?} of {whole:?}");
    }
}

#[test]
#[ignore = "writes docs/REDRAW.md"]
fn write() {
    let mut lines: Vec<_> = page().lines().map(String::from).collect();
    for (title, cells) in measured() {
        let start = format!("| {title} |");
        let line = lines.iter_mut().find(|line| line.starts_with(&start)).expect("a row of that title");
        *line = row(&title, &cells);
    }
    fs::write(Path::new(ROOT).join("docs/REDRAW.md"), lines.join("\n") + "\n").unwrap();
}
