//! The deepest stack of a frame of any reference scene, by rows or drawn, below its caller's: painted and looked at, in the bench firmware.
//!
//! ```text
//! cargo test --test stack -- --ignored --nocapture       needs qemu-system-arm and two targets
//! ```

use laboratory::firmware;
use std::path::Path;
use std::process::Command;

/// Bytes, on a Cortex-M4F.
const MOST: u32 = 1024;

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

#[test]
#[ignore = "needs qemu-system-arm and two targets"]
fn a_frame_needs_little_stack() {
    let [hard, soft] = [firmware::M4F, firmware::M3].map(|target| deepest(&bench(target)));
    println!(
        "| stack of a frame, bytes | M3 | M4F |\n|---|---:|---:|\n| by rows or drawn | {soft} | {hard} |"
    );
    assert!((MOST / 4..=MOST).contains(&hard), "{hard} bytes of stack, and {MOST} were allowed");
}
