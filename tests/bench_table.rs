//! The bench's table of cubics: g along chords of the vase, as rays of its reference picture meet them.
//!
//! ```text
//! cargo test --test bench_table -- --ignored       writes the table anew
//! ```
#![cfg(not(target_os = "none"))]

#[allow(dead_code)]
#[path = "../examples/scenes/mod.rs"]
mod scenes;

use std::{fmt::Write, fs};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/bench/cubics.rs");

/// Every how many pixels of the picture a ray is taken, either way, and every how many of their cubics.
const STEP: usize = 5;
const KEPT: usize = 5;

/// Cubics over a chord, from 0 at its start to 1 at its end, whose Bernstein ordinates leave open whether there is a root.
///
/// Between two points Pₐ, P_b of a ray, at uₐ, u_b of a segment, the ordinates of `f − (x² + y²)` are those of f, cut to [uₐ, u_b], less
/// ⟨Pₐ,Pₐ⟩, (⟨Pₐ,Pₐ⟩ + 2⟨Pₐ,P_b⟩)/3, (2⟨Pₐ,P_b⟩ + ⟨P_b,P_b⟩)/3 and ⟨P_b,P_b⟩.
fn cubics() -> Vec<[f32; 4]> {
    let pixels = (0..240).step_by(STEP).flat_map(|y| (0..240).step_by(STEP).map(move |x| (x, y)));
    let all = pixels.flat_map(|(x, y)| {
        let ray = scenes::VASE_SCENE.camera.ray(x, y, 240, 240);
        let ends = [ray.at(0.0), ray.at(1.0)].map(|p| p.map(f64::from));
        let direction = std::array::from_fn(|i| ends[1][i] - ends[0][i]);
        (0..4).filter_map(move |segment| cubic(ends[0], direction, segment))
    });
    all.step_by(KEPT).collect()
}

fn cubic(origin: [f64; 3], direction: [f64; 3], segment: usize) -> Option<[f32; 4]> {
    let [z, top] = [0, 1].map(|i| f64::from(scenes::VASE_KNOTS[segment + i]));
    let b: [f64; 4] = std::array::from_fn(|i| scenes::VASE_ORDINATES[3 * segment + i].into());
    let [a, b_t] = chord(origin, direction, [z, top], b.into_iter().fold(0.0, f64::max))?;

    let point = |t: f64| std::array::from_fn(|i| origin[i] + t * direction[i]);
    let [p, q]: [[f64; 3]; 2] = [point(a), point(b_t)];
    let [u, v] = [p, q].map(|p| (p[2] - z) / (top - z));
    let f = [blossom(b, [u, u, u]), blossom(b, [u, u, v]), blossom(b, [u, v, v]), blossom(b, [v, v, v])];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1];
    let (pp, pq, qq) = (dot(p, p), dot(p, q), dot(q, q));
    let [g0, g1, g2, g3] = [f[0] - pp, f[1] - (pp + 2.0 * pq) / 3.0, f[2] - (2.0 * pq + qq) / 3.0, f[3] - qq];

    let open = [g1, g2, g3].iter().any(|g| (*g > 0.0) != (g0 > 0.0));
    let power = [g0, 3.0 * (g1 - g0), 3.0 * (g2 - 2.0 * g1 + g0), g3 - 3.0 * (g2 - g1) - g0];
    open.then_some(power.map(|c| c as f32))
}

/// From where to where the ray is in the slab and in the cylinder.
fn chord(o: [f64; 3], d: [f64; 3], heights: [f64; 2], reach: f64) -> Option<[f64; 2]> {
    let [s, t] = heights.map(|z| (z - o[2]) / d[2]);
    let q = d[0] * d[0] + d[1] * d[1];
    let nearest = -(o[0] * d[0] + o[1] * d[1]) / q;
    let [x, y] = [0, 1].map(|i| o[i] + nearest * d[i]);
    let half = ((reach - x * x - y * y) / q).sqrt();
    if half.is_nan() {
        return None;
    }
    let [from, to] = [s.min(t).max(nearest - half), s.max(t).min(nearest + half)];
    (0.0 < from && from < to).then_some([from, to])
}

/// De Casteljau's steps, each with a parameter of its own: the ordinates over any part of a Bézier curve.
fn blossom([b0, b1, b2, b3]: [f64; 4], [u, v, w]: [f64; 3]) -> f64 {
    let mix = |a: f64, b: f64, u: f64| a + (b - a) * u;
    let [c0, c1, c2] = [mix(b0, b1, u), mix(b1, b2, u), mix(b2, b3, u)];
    mix(mix(c0, c1, v), mix(c1, c2, v), w)
}

fn table() -> String {
    let cubics = cubics();
    let mut text = format!(
        "//! Cubics of rays that meet the vase, constant term first. Written by `tests/bench_table.rs`.\n\npub static CUBICS: [[f32; 4]; {}] = [\n",
        cubics.len()
    );
    for [c0, c1, c2, c3] in cubics {
        writeln!(text, "    [{c0:?}, {c1:?}, {c2:?}, {c3:?}],").unwrap();
    }
    text + "];\n"
}

#[test]
fn the_bench_has_this_table() {
    assert_eq!(fs::read_to_string(FILE).unwrap(), table(), "write it anew: see the head of this file");
}

#[test]
fn the_table_is_large_and_most_of_it_has_roots() {
    let cubics = cubics();
    assert!((180..=260).contains(&cubics.len()), "{}", cubics.len());
    let crossing = cubics.iter().filter(|c| (c[0] > 0.0) != (c.iter().sum::<f32>() > 0.0)).count();
    assert!(crossing * 2 > cubics.len(), "{crossing} of {}", cubics.len());
}

#[test]
#[ignore = "writes examples/bench/cubics.rs"]
fn write() {
    fs::write(FILE, table()).unwrap();
}
