//! The laboratory's pictures and tables, written to `docs/`.
//!
//! ```text
//! cargo run --release --example laboratory               all but soak
//! cargo run --release --example laboratory -- tables     docs/solvers.csv, docs/intersections.csv
//! cargo run --release --example laboratory -- cost       docs/cost-host.csv, docs/cost-sextic.csv, counted by valgrind
//! cargo run --release --example laboratory -- charts     docs/cost-and-error.svg, docs/cost-and-error-soft-float.svg
//! cargo run --release --example laboratory -- pictures   docs/pictures.csv, docs/pictures.svg: whole pictures, and those of other renderers
//! cargo run --release --example laboratory -- outlines   docs/segments.svg: segments against tolerance, for an outline of degree 5
//! cargo run --release --example laboratory -- page       the tables of docs/ACCURACY.md and docs/SPEED.md, from the CSV files
//! cargo run --release --example laboratory -- atlas      docs/atlas-*.png, docs/eye-level.png
//! cargo run --release --example laboratory -- soak 60    60 minutes of fresh questions; what the crate gets wrong, printed
//! .ci/solvers                                            docs/cost-m4f.csv, docs/cost-m3.csv, counted by QEMU
//! ```

mod atlas;
mod boards;
mod charts;
mod cost;
mod csv;
mod outlines;
mod page;
mod pictures;
mod plot;
mod progress;
mod soak;
mod tables;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        [] => {
            tables::write()?;
            cost::write()?;
            charts::write()?;
            pictures::write()?;
            outlines::write()?;
            page::write()?;
            atlas::write()
        }
        ["tables"] => tables::write(),
        ["cost"] => cost::write(),
        ["charts"] => charts::write(),
        ["pictures"] => pictures::write(),
        ["outlines"] => outlines::write(),
        ["page"] => page::write(),
        ["atlas"] => atlas::write(),
        ["soak", minutes] => soak::run(minutes.parse()?),
        ["solve", method, family] => cost::solve(method.parse()?, family.parse()?),
        ["target", file] => cost::from_target(file),
        _ => {
            Err("not a command of the laboratory: see the head of laboratory/examples/laboratory/main.rs"
                .into())
        }
    }
}
