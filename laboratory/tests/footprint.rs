//! Flash and RAM that the library adds to firmware, in Cargo's profile `small` and, for the renderer, in `release`, whose
//! speed README tells: as README's table has them. The solids'
//! segments are in what is subtracted, too: they are the user's. So are the demo's own functions.
//!
//! ```text
//! cargo test --test footprint -- --ignored --skip write --nocapture       needs the three targets
//! cargo test --test footprint -- --ignored write                          README's rows
//! ```

use laboratory::firmware::{self, M0, M3, M4F};
use laboratory::readme;
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

/// What firmware has beyond the same without the library.
struct Row {
    title: &'static str,
    with: &'static str,
    /// Empty where all of it counts.
    without: &'static str,
    /// A module of functions of its own, as symbols name it.
    own: Option<&'static str>,
    profile: &'static str,
    /// The features of what is measured, not of what is subtracted.
    options: &'static [&'static str],
    targets: &'static [&'static str],
}

/// The least there can be, on every target.
const NOTHING: Row = Row {
    title: "",
    with: "",
    without: "footprint-nothing",
    own: None,
    profile: firmware::SMALL,
    options: &[],
    targets: &[M0, M3, M4F],
};
const LOGGED: Row = Row { options: &["--features", "defmt"], ..NOTHING };
const DEMO: Row = Row { with: "oled", without: "", targets: &[M3, M4F], ..NOTHING };

const ROWS: [Row; 7] = [
    Row { title: "intersection", with: "footprint-ray", ..NOTHING },
    Row { title: "intersection, logged by defmt", with: "footprint-ray", ..LOGGED },
    Row { title: "renderer", with: "footprint-renderer", ..NOTHING },
    Row {
        title: "renderer, release profile",
        with: "footprint-renderer",
        profile: firmware::RELEASE,
        ..NOTHING
    },
    Row { title: "renderer, logged by defmt", with: "footprint-renderer", ..LOGGED },
    Row {
        title: "OLED demo, the library's part",
        without: "footprint-card",
        own: Some("4oled4show"),
        ..DEMO
    },
    Row { title: "OLED demo, whole", ..DEMO },
];

impl Row {
    fn added(&self, target: &str) -> Footprint {
        let path = |example, options| firmware::build(target, example, self.profile, options);
        let with = path(self.with, self.options);
        let own = Footprint { flash: self.own.map_or(0, |module| own(&with, module)), ram: 0 };
        let added = footprint(&with) - own;
        if self.without.is_empty() { added } else { added - footprint(&path(self.without, &[])) }
    }

    /// As README has them: M0+, M3, M4F.
    fn cells(&self) -> Vec<String> {
        let cell = |target: &str| {
            let Footprint { flash, ram } = self.added(target);
            format!("{flash} / {ram}")
        };
        let mut cells = vec!["—".to_owned(); 3 - self.targets.len()];
        cells.extend(self.targets.iter().map(|target| cell(target)));
        cells
    }
}

#[test]
#[ignore = "needs the targets"]
fn footprint_is_as_the_readme_says() {
    println!("| flash / RAM, bytes | M0+ | M3 | M4F |\n|---|---:|---:|---:|");
    let mut wrong = Vec::new();
    for row in ROWS {
        let cells = row.cells();
        println!("| {} | {} |", row.title, cells.join(" | "));
        wrong.extend(readme::compare(row.title, &cells));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
#[ignore = "writes README.md"]
fn write() {
    ROWS.iter().for_each(|row| readme::write(row.title, &row.cells()));
}
