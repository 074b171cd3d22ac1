//! The deepest stack of a frame of any reference scene, by rows or drawn, below its caller's: painted and looked at, in the bench
//! firmware, and as README says.
//!
//! ```text
//! cargo test --test stack -- --ignored --skip write --nocapture       needs qemu-system-arm and two targets
//! cargo test --test stack -- --ignored write                          README's row
//! ```

use laboratory::{firmware, readme};
use std::path::Path;
use std::process::Command;

const TITLE: &str = "deepest stack of a frame, release profile";

/// What the bench firmware prints.
fn bench(target: &str) -> String {
    let runner = Path::new(firmware::ROOT).join(".cargo/run-firmware");
    let output = Command::new(runner)
        .arg(firmware::build(target, "bench", firmware::RELEASE, &[]))
        .output()
        .expect("the runner starts");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The largest number of bytes in its comments, `# scene: 123 bytes of stack by rows, 123 drawn`.
fn deepest(report: &str) -> u32 {
    let comments: Vec<_> = report.lines().filter(|line| line.starts_with('#')).collect();
    assert!(comments.len() >= 4, "{report}");
    let numbers = comments.iter().flat_map(|line| line.split(' ')).filter_map(|word| word.parse().ok());
    numbers.max().expect("a number")
}

/// As README has them: M0+, which is not measured, M3, M4F.
fn cells() -> Vec<String> {
    let [soft, hard] = [firmware::M3, firmware::M4F].map(|target| deepest(&bench(target)).to_string());
    vec!["—".to_owned(), soft, hard]
}

#[test]
#[ignore = "needs qemu-system-arm and two targets"]
fn a_frame_needs_the_stack_that_the_readme_says() {
    let cells = cells();
    println!("| stack, bytes | M0+ | M3 | M4F |\n|---|---:|---:|---:|\n| {TITLE} | {} |", cells.join(" | "));
    let wrong = readme::compare(TITLE, &cells);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
#[ignore = "writes README.md"]
fn write() {
    readme::write(TITLE, &cells());
}
