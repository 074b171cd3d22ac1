//! No panic machinery is linked into firmware that uses the library.
//!
//! ```text
//! cargo test --test panics -- --ignored      needs the three targets
//! ```

use laboratory::firmware::{self, M0, M3, M4F, RELEASE, SMALL};
use object::{File, Object, ObjectSection, ObjectSymbol, SymbolKind};
use std::{collections::BTreeSet, fs, path::Path};

/// Functions of the panic machinery, each with those that branch to it.
fn panics(elf: &Path) -> Vec<(String, BTreeSet<String>)> {
    let data = fs::read(elf).unwrap();
    let file = File::parse(&*data).unwrap();
    let functions = || file.symbols().filter(|s| s.kind() == SymbolKind::Text && s.size() > 0);
    assert!(functions().count() > 3, "{} has its symbols", elf.display());

    let name = |s: &object::Symbol| s.name().unwrap_or("?").to_string();
    let bad = |s: &object::Symbol| ["rust_begin_unwind", "9panicking"].iter().any(|p| name(s).contains(p));
    let branches: Vec<_> =
        file.sections().flat_map(|s| branches(s.address(), s.data().unwrap_or_default())).collect();
    let at = |s: &object::Symbol, pc: u64| (s.address() & !1..(s.address() & !1) + s.size()).contains(&pc);
    functions()
        .filter(bad)
        .map(|panic| {
            let callers = branches.iter().filter(|(_, to)| *to == panic.address() & !1);
            let callers =
                callers.filter_map(|&(from, _)| functions().find(|f| at(f, from)).map(|f| name(&f)));
            (name(&panic), callers.collect())
        })
        .collect()
}

/// Every `bl` and far `b` in Thumb code, from where to where; data that look like one are harmless here.
fn branches(address: u64, code: &[u8]) -> impl Iterator<Item = (u64, u64)> {
    let half = |i: usize| u32::from(code[2 * i]) | u32::from(code[2 * i + 1]) << 8;
    (1..code.len() / 2).filter_map(move |i| {
        let (a, b) = (half(i - 1), half(i));
        if a >> 11 != 0b11110 || !matches!(b >> 12 & 0b1101, 0b1101 | 0b1001) {
            return None;
        }
        let (s, j1, j2) = (a >> 10 & 1, b >> 13 & 1, b >> 11 & 1);
        let high = s << 24 | (!(j1 ^ s) & 1) << 23 | (!(j2 ^ s) & 1) << 22;
        let offset = (high | (a & 0x3ff) << 12 | (b & 0x7ff) << 1) as i32;
        let from = address + 2 * (i as u64 - 1);
        Some((from, (from + 4).wrapping_add_signed((offset << 7 >> 7).into())))
    })
}

#[test]
#[ignore = "needs the targets"]
fn firmware_cannot_panic() {
    for (target, example) in [
        (M0, "footprint-ray"),
        (M3, "footprint-ray"),
        (M4F, "footprint-ray"),
        (M0, "footprint-renderer"),
        (M3, "footprint-renderer"),
        (M4F, "footprint-renderer"),
        (M0, "footprint-screen"),
        (M3, "footprint-screen"),
        (M4F, "footprint-screen"),
        (M3, "oled"),
        (M4F, "oled"),
    ] {
        // What the larger profile puts in line is the same on all.
        let profiles = if target == M4F { &[SMALL, RELEASE][..] } else { &[SMALL] };
        for profile in profiles {
            let found = panics(&firmware::build(target, example, profile, &[]));
            assert!(found.is_empty(), "{example} for {target}, {profile}, links {found:#?}");
        }
    }
}

/// The scan sees what there is to see: `bench` prints numbers, and printing can panic.
#[test]
#[ignore = "needs a target"]
fn the_scan_finds_panics_and_their_callers() {
    let found = panics(&firmware::build(M4F, "bench", RELEASE, &[]));
    for name in ["rust_begin_unwind", "9panicking9panic_fmt"] {
        let callers = found.iter().find(|(panic, _)| panic.contains(name)).map(|(_, callers)| callers.len());
        assert!(callers > Some(0), "{name}: {found:#?}");
    }
}
