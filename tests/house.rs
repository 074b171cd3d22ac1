//! The architecture as `src/lib.rs` draws it, held by the imports: every file names only stages to its left, no files name each
//! other in a circle, and every term of the crate's own, set in italics, is in the glossary.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The crate's files by module path: `["lathe", "ray"]` for `src/lathe/ray.rs`.
struct House {
    files: BTreeMap<Vec<String>, String>,
}

/// One name that a file imports, as a path of segments, and whether the file passes it on (`pub use`).
struct Import {
    path: Vec<String>,
    is_reexport: bool,
}

impl House {
    fn read() -> Self {
        let mut house = Self { files: BTreeMap::new() };
        house.read_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &[]);
        house
    }

    fn read_folder(&mut self, folder: &Path, module: &[String]) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let mut inner = module.to_vec();
            inner.push(path.file_stem().unwrap().to_str().unwrap().into());
            if path.is_dir() {
                self.read_folder(&path, &inner);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                self.files.insert(inner, fs::read_to_string(&path).unwrap());
            }
        }
    }

    fn lib(&self) -> &str {
        &self.files[&vec!["lib".to_string()]]
    }

    /// What the file of a module imports. Tests may import anything, and are left out.
    fn imports(&self, module: &[String]) -> Vec<Import> {
        let source = &self.files[module];
        let source = source.split("#[cfg(test)]\nmod tests").next().unwrap();
        let code: String =
            source.lines().map(|line| line.split("//").next().unwrap()).collect::<Vec<_>>().join("\n");
        let mut imports = Vec::new();
        for statement in code.split(';') {
            let Some((before, tree)) = statement.rsplit_once("use ").filter(|(before, _)| {
                let last = before.lines().last().unwrap_or("").trim();
                last.is_empty() || last.starts_with("pub")
            }) else {
                imports.extend(inline_paths(statement));
                continue;
            };
            let is_reexport = before.lines().last().unwrap_or("").contains("pub");
            let mut paths = Vec::new();
            expand(&[], tree, &mut paths);
            imports.extend(paths.into_iter().map(|path| Import { path, is_reexport }));
        }
        imports
    }

    /// The module that a path leads to, as written in a file, through what other files pass on. `None` for other crates.
    fn resolve(&self, from: &[String], path: &[String]) -> Option<Vec<String>> {
        let (mut at, mut rest) = match path.first().map(String::as_str) {
            Some("crate") => (Vec::new(), &path[1..]),
            Some("self") => (from.to_vec(), &path[1..]),
            Some("super") => (from.to_vec(), path),
            Some(first) => {
                let child = [from, &[first.to_string()]].concat();
                if !self.files.contains_key(&child) {
                    return None;
                }
                (from.to_vec(), path)
            }
            None => return None,
        };
        while rest.first().is_some_and(|segment| segment == "super") {
            at.pop();
            rest = &rest[1..];
        }
        while let Some(first) = rest.first() {
            let next = [at.as_slice(), std::slice::from_ref(first)].concat();
            if self.files.contains_key(&next) {
                (at, rest) = (next, &rest[1..]);
                continue;
            }
            // An item: of this file, or passed on by it.
            let file = if at.is_empty() { vec!["lib".to_string()] } else { at.clone() };
            let passed_on = self
                .imports(&file)
                .into_iter()
                .find(|import| import.is_reexport && import.path.last() == Some(first));
            return match passed_on {
                Some(import) => self.resolve(&at, &import.path),
                None => Some(file),
            };
        }
        Some(at)
    }

    /// Each file with the files that it imports from, what it only passes on left out.
    fn edges(&self) -> BTreeMap<Vec<String>, BTreeSet<Vec<String>>> {
        let modules = self.files.keys().filter(|module| *module != &["lib"]);
        modules
            .map(|module| {
                let imports = self.imports(module);
                let used = imports.iter().filter(|import| !import.is_reexport);
                let mut targets: BTreeSet<_> =
                    used.filter_map(|import| self.resolve(module, &import.path)).collect();
                targets.remove(module);
                (module.clone(), targets)
            })
            .collect()
    }
}

/// The paths of a use tree: `a::{b, c::d}` is `a::b` and `a::c::d`.
fn expand(prefix: &[String], tree: &str, paths: &mut Vec<Vec<String>>) {
    let tree = tree.trim();
    let Some((head, group)) = tree.split_once('{') else {
        let tree = tree.split(" as ").next().unwrap();
        let segments = tree.split("::").map(|segment| segment.trim().to_string());
        paths.push(prefix.iter().cloned().chain(segments).filter(|segment| segment != "self").collect());
        return;
    };
    let head = head.split("::").map(str::trim).filter(|segment| !segment.is_empty()).map(String::from);
    let prefix: Vec<_> = prefix.iter().cloned().chain(head).collect();
    let group = group.rsplit_once('}').expect("a closing brace").0;
    let (mut depth, mut start) = (0, 0);
    for (at, character) in group.char_indices() {
        match character {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                expand(&prefix, &group[start..at], paths);
                start = at + 1;
            }
            _ => (),
        }
    }
    if !group[start..].trim().is_empty() {
        expand(&prefix, &group[start..], paths);
    }
}

/// Paths of the crate that stand in the code itself.
fn inline_paths(code: &str) -> Vec<Import> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let paths = code.match_indices("crate::").map(|(at, _)| {
        let end = code[at..].find(|c| !is_part(c)).map_or(code.len(), |len| at + len);
        code[at..end].trim_end_matches(':').split("::").map(String::from).collect()
    });
    paths.map(|path| Import { path, is_reexport: false }).collect()
}

/// The stages of the arrow line in the crate's documentation, in order.
fn stages(lib: &str) -> Vec<String> {
    let pipe = lib.split("//! # The pipe").nth(1).expect("a section on the pipe");
    let block = pipe.split("//! ```").nth(1).expect("a block with the arrow line");
    let line: Vec<_> = block.lines().skip(1).map(|line| line.trim_start_matches("//!").trim()).collect();
    line.join(" ").split('→').map(str::trim).filter(|stage| !stage.is_empty()).map(String::from).collect()
}

#[test]
fn every_stage_names_only_stages_to_its_left() {
    let house = House::read();
    let stages = stages(house.lib());
    let place = |module: &[String]| {
        let stage = stages.iter().position(|stage| *stage == module[0]);
        stage.unwrap_or_else(|| panic!("{} is not in the arrow line of lib.rs", module.join("::")))
    };
    let edges = house.edges();
    let mut imports = 0;
    for (module, targets) in &edges {
        for target in targets.iter().filter(|target| *target != &["lib"]) {
            imports += 1;
            assert!(
                place(target) <= place(module),
                "{} names {}, to its right",
                module.join("::"),
                target.join("::")
            );
        }
    }
    // The reader of imports reads: a crate of so many files has more imports than files.
    assert!(imports > edges.len(), "{imports} imports found in {} files", edges.len());
    for stage in &stages {
        assert!(edges.keys().any(|module| module[0] == *stage), "no file for the stage {stage}");
    }
}

#[test]
fn no_files_name_each_other_in_a_circle() {
    let edges = House::read().edges();
    let mut done = BTreeSet::new();
    for module in edges.keys() {
        visit(&edges, module, &mut Vec::new(), &mut done);
    }

    fn visit(
        edges: &BTreeMap<Vec<String>, BTreeSet<Vec<String>>>,
        module: &Vec<String>,
        way: &mut Vec<Vec<String>>,
        done: &mut BTreeSet<Vec<String>>,
    ) {
        let names: Vec<_> = way.iter().chain([module]).map(|module| module.join("::")).collect();
        assert!(!way.contains(module), "a circle: {}", names.join(" → "));
        if done.contains(module) {
            return;
        }
        way.push(module.clone());
        for target in edges.get(module).into_iter().flatten() {
            visit(edges, target, way, done);
        }
        way.pop();
        done.insert(module.clone());
    }
}

/// What stands in italics in the docs and comments of a file, without code. A plural counts as its singular.
fn italics(source: &str) -> BTreeSet<String> {
    let mut terms = BTreeSet::new();
    let mut is_code = false;
    let mut text = String::new();
    for line in source.lines().filter_map(|line| line.trim().strip_prefix("//")) {
        let line = line.trim_start_matches(['/', '!']).trim();
        is_code ^= line.starts_with("```");
        if !is_code && !line.starts_with("```") {
            // Every other piece between backticks is code.
            text.extend(line.split('`').step_by(2));
            text.push(' ');
        }
    }
    let pieces: Vec<_> = text.replace("**", "").split('*').map(String::from).collect();
    let is_word =
        |piece: &str| piece.starts_with(char::is_alphabetic) && piece.ends_with(char::is_alphabetic);
    for piece in pieces.iter().skip(1).step_by(2).filter(|piece| is_word(piece)) {
        terms.insert(piece.split_whitespace().collect::<Vec<_>>().join(" "));
    }
    terms
}

/// The terms of the glossary in the crate's documentation.
fn glossary(lib: &str) -> BTreeSet<String> {
    let section = lib.split("//! # Glossary").nth(1).expect("a glossary");
    let section = section.split("//! # ").next().unwrap();
    let rows = section.lines().filter_map(|line| line.strip_prefix("//! | *"));
    rows.map(|row| row.split('*').next().unwrap().to_string()).collect()
}

#[test]
fn the_glossary_defines_every_term_of_our_own_and_no_other() {
    let house = House::read();
    let glossary = glossary(house.lib());
    assert!(glossary.len() > 10, "{glossary:?}");
    let mut used = BTreeSet::new();
    for (module, source) in house.files.iter().filter(|(module, _)| *module != &["lib"]) {
        for term in italics(source) {
            let singular = term.strip_suffix('s').unwrap_or(&term);
            let entry = [term.as_str(), singular].into_iter().find(|term| glossary.contains(*term));
            let entry = entry.unwrap_or_else(|| panic!("{} leans on *{term}*", module.join("::")));
            used.insert(entry.to_string());
        }
    }
    let unused: Vec<_> = glossary.difference(&used).collect();
    assert!(unused.is_empty(), "in the glossary, and in no file in italics: {unused:?}");
}
