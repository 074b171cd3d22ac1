//! What a solve costs, in instructions: counted, not timed.
//!
//! On the host valgrind's callgrind counts what one function, [`measured`], executes, in one run of this program a method and family of
//! [`workload`]. On the target, the firmware `examples/solvers` marks each solve and a plugin of QEMU counts between the marks.
//! What a call alone costs is counted likewise and taken off.

use crate::progress::bar;
use laboratory::contenders::{EVERYWHERE, FirstRoot, HOST};
use laboratory::peers::{self, PEERS};
use laboratory::workload::{COUNT, FAMILIES, Item};
use laboratory::{contenders, sextic};
use std::error::Error;
use std::fmt::Write;
use std::hint::black_box;
use std::process::Command;

const HEAD: &str = "method,backend,family,mean,worst\n";

/// A method on the host.
enum Method {
    Single(FirstRoot),
    Double(peers::FirstRoot),
}

fn methods() -> Vec<(String, Method)> {
    let single = EVERYWHERE.iter().chain(HOST);
    let single = single.map(|c| (format!("{},{}", c.method, c.backend), Method::Single(c.first_root)));
    let double = PEERS.iter().map(|peer| (format!("{},f64", peer.name), Method::Double(peer.first_root)));
    let call = Method::Single(|_, lo, _| Some(lo));
    std::iter::once(("call alone,".to_owned(), call)).chain(single).chain(double).collect()
}

/// The families of the workload, then the paper's claim: a cubic and a sextic for the same rays.
const CLAIM: usize = FAMILIES.len();

#[inline(never)]
fn measured(work: &mut dyn FnMut()) {
    work();
}

/// What valgrind watches: every question of a family, by one method.
pub fn solve(method: usize, family: usize) -> Result<(), Box<dyn Error>> {
    if family >= CLAIM {
        let pairs: Vec<_> = (0..u64::from(COUNT)).map(|i| sextic::pair(1995, i)).collect();
        for pair in &pairs {
            let c: &[f32] = if family == CLAIM { &pair.cubic.c } else { &pair.sextic };
            measured(&mut || {
                black_box(contenders::recursive::first_root(black_box(c), 0.0, 1.0));
            });
        }
        return Ok(());
    }
    let items: Vec<Item> = (0..COUNT).map(FAMILIES[family].1).collect();
    let methods = methods();
    let (_, method) = &methods[method];
    for item in &items {
        let &Item { c, lo, hi } = item;
        match method {
            Method::Single(first_root) => measured(&mut || {
                black_box(first_root(black_box(&c), black_box(lo), black_box(hi)));
            }),
            Method::Double(first_root) => {
                let (c, lo, hi) = (c.map(f64::from), f64::from(lo), f64::from(hi));
                measured(&mut || {
                    black_box(first_root(black_box(c), black_box(lo), black_box(hi)));
                });
            }
        }
    }
    Ok(())
}

/// Counts every method on every family, and writes `docs/cost-host.csv` and `docs/cost-sextic.csv`.
pub fn write() -> Result<(), Box<dyn Error>> {
    let methods = methods();
    let bar = bar((methods.len() * FAMILIES.len() + 2) as u64, "cost");
    let mut csv = HEAD.to_owned();
    for (family, (name, _)) in FAMILIES.iter().enumerate() {
        let mut alone = 0;
        for (i, (method, _)) in methods.iter().enumerate() {
            let count = count(i, family)?;
            bar.inc(1);
            if i == 0 {
                alone = count;
                continue;
            }
            let mean = (count - alone) as f64 / f64::from(COUNT);
            writeln!(csv, "{method},{name},{mean:.1},")?;
        }
    }
    std::fs::write("docs/cost-host.csv", csv)?;
    let mut csv = "polynomial,instructions\n".to_owned();
    for (i, name) in ["cubic", "sextic"].into_iter().enumerate() {
        let mean = count(0, CLAIM + i)? as f64 / f64::from(COUNT);
        writeln!(csv, "{name},{mean:.1}")?;
        bar.inc(1);
    }
    std::fs::write("docs/cost-sextic.csv", csv)?;
    bar.finish();
    Ok(())
}

/// Instructions in `measured` and below, for a whole family.
fn count(method: usize, family: usize) -> Result<u64, Box<dyn Error>> {
    let out = std::env::temp_dir().join(format!("laboratory-{}.callgrind", std::process::id()));
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--toggle-collect=*cost*measured*", "--cache-sim=no"])
        .arg(format!("--callgrind-out-file={}", out.display()))
        .arg(std::env::current_exe()?)
        .args(["solve", &method.to_string(), &family.to_string()])
        .output()
        .map_err(|error| format!("valgrind: {error}"))?;
    let profile = std::fs::read_to_string(&out)?;
    std::fs::remove_file(&out)?;
    let total = profile.lines().find_map(|line| line.strip_prefix("totals: "));
    match total.and_then(|total| total.trim().parse().ok()) {
        Some(total) if output.status.success() && total > 0 => Ok(total),
        _ => Err(String::from_utf8_lossy(&output.stderr).into()),
    }
}

/// Reads what the firmware and the plugin print, and writes it as CSV.
///
/// The firmware's lines are `solver,method,backend,family,count`, in order; the plugin's `region,instructions,…`, a region a solve.
pub fn from_target(file: &str) -> Result<(), Box<dyn Error>> {
    let lines: Vec<String> = std::io::stdin().lines().collect::<Result<_, _>>()?;
    let region = |line: &String| -> Option<u64> {
        let mut fields = line.split(',');
        fields.next()?.parse::<u32>().ok()?;
        fields.next()?.parse().ok()
    };
    let mut regions = lines.iter().filter_map(region);
    let mut csv = HEAD.to_owned();
    let mut alone = 0.0;
    for line in lines.iter().filter_map(|line| line.strip_prefix("solver,")) {
        let (what, count) = line.rsplit_once(',').ok_or("no count")?;
        let counts: Vec<u64> = regions.by_ref().take(count.trim().parse()?).collect();
        let mean = counts.iter().sum::<u64>() as f64 / counts.len() as f64;
        let worst = counts.iter().copied().max().unwrap_or(0) as f64;
        if what.starts_with("call alone") {
            alone = mean;
            continue;
        }
        writeln!(csv, "{what},{:.1},{:.0}", mean - alone, worst - alone)?;
    }
    std::fs::write(file, csv)?;
    Ok(())
}
