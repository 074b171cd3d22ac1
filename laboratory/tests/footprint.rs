//! Flash and RAM that the library adds to firmware in Cargo's profile `small`, as a table, and within bounds. The
//! solids' segments are in what is subtracted, too: they are the user's. So are the demo's own functions.
//!
//! ```text
//! cargo test --test footprint -- --ignored --nocapture       needs the three targets
//! ```

use laboratory::firmware::{self, M0, M3, M4F};
use object::{File, Object, ObjectSection, ObjectSymbol, SectionFlags, SectionKind, elf};
use std::{fs, ops::Sub, path::Path};

#[derive(Clone, Copy)]
struct Footprint {
    flash: u64,
    ram: u64,
}

impl Sub for Footprint {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Footprint { flash: self.flash - other.flash, ram: self.ram - other.ram }
    }
}

/// Sections that take up memory: zeroed ones only RAM, constant ones only flash, initialised ones both.
fn footprint(path: &Path) -> Footprint {
    let data = fs::read(path).unwrap();
    let file = File::parse(&*data).unwrap();
    let mut sum = Footprint { flash: 0, ram: 0 };
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
        let has = |flag| sh_flags & flag != elf::SectionFlags(0);
        if has(elf::SHF_ALLOC) && section.kind() != SectionKind::UninitializedData {
            sum.flash += section.size();
        }
        if has(elf::SHF_ALLOC) && has(elf::SHF_WRITE) {
            sum.ram += section.size();
        }
    }
    sum
}

/// The flash of a program's own functions, told by their names.
fn own(path: &Path, module: &str) -> u64 {
    let data = fs::read(path).unwrap();
    let file = File::parse(&*data).unwrap();
    let own = file.symbols().filter(|symbol| symbol.name().is_ok_and(|name| name.contains(module)));
    let flash = own.map(|symbol| symbol.size()).sum();
    assert!(flash > 0, "{module} has no symbols in {}", path.display());
    flash
}

/// What a firmware has beyond the same without the library.
struct Row {
    title: &'static str,
    with: &'static str,
    without: &'static str,
    /// A module of functions of its own, as symbols name it.
    own: Option<&'static str>,
    targets: &'static [&'static str],
    /// Flash on a Cortex-M4F, at most.
    flash: u64,
    /// RAM: the buffer for pixels, and nothing else.
    ram: u64,
}

const ROWS: [Row; 3] = [
    Row {
        title: "intersection",
        with: "footprint-ray",
        without: "footprint-nothing",
        own: None,
        targets: &[M0, M3, M4F],
        flash: 4096,
        ram: 0,
    },
    Row {
        title: "renderer",
        with: "footprint-renderer",
        without: "footprint-nothing",
        own: None,
        targets: &[M0, M3, M4F],
        flash: 13 * 1024,
        ram: 240 * 2,
    },
    Row {
        title: "OLED demo, the library's part",
        with: "oled",
        without: "footprint-card",
        own: Some("4oled4show"),
        targets: &[M3, M4F],
        flash: 12 * 1024,
        ram: 0,
    },
];

#[test]
#[ignore = "needs the targets"]
fn footprint_is_small() {
    println!("| flash / RAM, bytes | M0+ | M3 | M4F |\n|---|---:|---:|---:|");
    let line = |title: &str, sizes: &[Footprint]| {
        let cells: Vec<_> = sizes.iter().map(|s| format!("{} / {}", s.flash, s.ram)).collect();
        println!("| {title} | {}{} |", "— | ".repeat(3 - cells.len()), cells.join(" | "));
    };
    let of = |target: &str, example: &str, options: &[&str]| {
        footprint(&firmware::build(target, example, firmware::SMALL, options))
    };

    let mut wrong = Vec::new();
    for Row { title, with, without, own: module, targets, flash, ram } in ROWS {
        let added = targets.iter().map(|t| {
            let own = |module| own(&firmware::build(t, with, firmware::SMALL, &[]), module);
            let rest = Footprint { flash: module.map_or(0, own), ram: 0 };
            of(t, with, &[]) - of(t, without, &[]) - rest
        });
        let added: Vec<_> = added.collect();
        line(title, &added);
        if with.starts_with("footprint") {
            let defmt = ["--features", "defmt"];
            let logged: Vec<_> = targets.iter().map(|t| of(t, with, &defmt) - of(t, without, &[])).collect();
            line(&format!("{title}, logged by defmt"), &logged);
        }
        let found = added.last().expect("a target");
        if !(flash / 4..=flash).contains(&found.flash) {
            wrong.push(format!("{title}: {} bytes of flash, and {flash} were allowed", found.flash));
        }
        if added.iter().any(|a| a.ram != ram) {
            wrong.push(format!("{title}: RAM beyond {ram} bytes"));
        }
    }
    line("OLED demo, whole", &[M3, M4F].map(|t| of(t, "oled", &[])));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
