//! The program for hosts: it runs itself under valgrind, which counts the regions, and then prints them.

use crate::{frames, lone, rays, region, report, solvers};
use std::{env, error::Error, fs, process};

/// As the argument: only run what is measured.
const COUNTED: &str = "counted";

pub fn run() -> Result<(), Box<dyn Error>> {
    let is_counted = env::args().nth(1).is_some_and(|argument| argument == COUNTED);
    if !is_counted {
        region::foresee(counts()?);
    }
    report::head();
    frames::measured();
    lone::measured();
    rays::measured();
    solvers::measured();
    Ok(())
}

/// Instructions of each region, in order: callgrind counts while in `counted`, and writes what it has each time that returns.
///
/// It would keep only one of two options that name their function alike.
fn counts() -> Result<Vec<u64>, Box<dyn Error>> {
    let file = env::temp_dir().join(format!("bench-{}.callgrind", process::id()));
    let output = process::Command::new("valgrind")
        .args(["--tool=callgrind", "--toggle-collect=*region*counted*", "--dump-after=*::counted*"])
        .args(["--combine-dumps=yes", &format!("--callgrind-out-file={}", file.display())])
        .arg(env::current_exe()?)
        .arg(COUNTED)
        .output()
        .map_err(|error| format!("valgrind: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let profile = fs::read_to_string(&file)?;
    fs::remove_file(&file)?;
    let totals = profile.lines().filter_map(|line| line.strip_prefix("totals: "));
    Ok(totals.map(|total| total.trim().parse()).collect::<Result<_, _>>()?)
}
