//! Files that somebody damaged: an error or an outline, no panic, in a time that their size bounds.

use embedded_lathe_outline::{
    Fit, body,
    read::{self, Options, Unit},
};
use rand::{RngExt, SeedableRng, rngs::ChaCha8Rng};

const TEXTS: [(&str, char); 5] = [
    (include_str!("../../examples/outlines/bell.svg"), 's'),
    (include_str!("../../examples/outlines/ring.svg"), 's'),
    (
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><g transform=\"scale(2) rotate(3)\"><rect x=\"1\" width=\"3\" height=\"4\" rx=\"1\"/></g></svg>",
        's',
    ),
    ("height,radius\n0,0\n1,1.5\n2,1.7\n2,1.7\n3,1\n4.5,0\n", 't'),
    (
        r#"{"kind": "catmull-rom", "points": [[0, 0], [0, 0], [1, 0.5], [0.5, 2], [0.7, 3], [0, 3.5], [0, 3.5]]}"#,
        'j',
    ),
];

/// What may stand in place of something else.
const PIECES: [&str; 16] =
    ["0", "-", "1e9", "1e-9", "1e308", "-7", ".", "M", "a1 1 0 01", "Z", "z", " ", "\n", ",", "nan", "é"];

/// `DAMAGED=100000 cargo test --release -p embedded-lathe-outline --test any_text` looks longer.
#[test]
fn damaged_files() {
    let most: u64 = std::env::var("DAMAGED").ok().and_then(|count| count.parse().ok()).unwrap_or(120);
    let (mut read_well, mut fitted) = (0, 0);
    for seed in 0..most {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let (text, kind) = TEXTS[rng.random_range(0..TEXTS.len())];
        let mut chars: Vec<char> = text.chars().collect();
        for _ in 0..rng.random_range(0..4) {
            let at = rng.random_range(0..chars.len());
            let end = (at + rng.random_range(0..3)).min(chars.len());
            let piece = PIECES[rng.random_range(0..PIECES.len())];
            chars.splice(at..end, piece.chars());
        }
        let text: String = chars.into_iter().collect();
        let options = Options { unit: Some(Unit::None), straight: rng.random(), ..Options::default() };
        let drawing = match kind {
            's' => read::svg(&text, &options),
            't' => read::table(&text, &options),
            _ => read::json(&text, &options),
        };
        let Ok(drawing) = drawing else { continue };
        read_well += 1;
        let tolerance = 0.02 * drawing.outline.size();
        if let Ok(body) = body(&drawing.outline, &Fit { places: 30, ..Fit::within(tolerance) }) {
            assert!(body.error <= tolerance, "seed {seed}: {text}");
            fitted += 1;
        }
    }
    assert!(read_well > most / 8 && fitted > most / 16, "{read_well} read, {fitted} fitted of {most}");
}
