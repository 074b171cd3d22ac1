//! Whether curves cross each other.

use crate::piece::Point;

/// A curve p(t), 0 ≤ t ≤ 1, and into how many chords it is cut.
pub(crate) struct Strand<'a> {
    pub at: Box<dyn Fn(f64) -> Point + 'a>,
    pub chords: usize,
}

#[derive(Clone, Copy)]
struct Chord {
    strand: usize,
    t: [f64; 2],
    ends: [Point; 2],
}

impl Chord {
    fn low(&self) -> f64 {
        self.ends[0].z.min(self.ends[1].z)
    }

    fn high(&self) -> f64 {
        self.ends[0].z.max(self.ends[1].z)
    }
}

/// A point at which two strands cross. Strands that touch, or end on one another, do not.
pub(crate) fn find(strands: &[Strand]) -> Option<Point> {
    let whole = |strand: usize| chords(strands, strand, 0.0, 1.0, strands[strand].chords);
    let mut all: Vec<Chord> = (0..strands.len()).flat_map(whole).collect();
    all.sort_by(|a, b| a.low().total_cmp(&b.low()));
    for (i, a) in all.iter().enumerate() {
        for b in all[i + 1..].iter().take_while(|b| b.low() <= a.high()) {
            if crosses(a, b).is_some()
                && let Some(at) = looked_closer(strands, a, b)
            {
                return Some(at);
            }
        }
    }
    None
}

fn chords(strands: &[Strand], strand: usize, from: f64, to: f64, count: usize) -> Vec<Chord> {
    let t = |i: usize| from + (to - from) * i as f64 / count as f64;
    let points: Vec<Point> = (0..=count).map(|i| (strands[strand].at)(t(i))).collect();
    let chord = |i: usize| Chord { strand, t: [t(i), t(i + 1)], ends: [points[i], points[i + 1]] };
    (0..count).map(chord).collect()
}

/// The same two chords in 16 each, three times: chords may cross where the curves do not.
fn looked_closer(strands: &[Strand], a: &Chord, b: &Chord) -> Option<Point> {
    let mut pairs = vec![(*a, *b)];
    for _ in 0..3 {
        let finer = |chord: &Chord| {
            let count = if strands[chord.strand].chords == 1 { 1 } else { 16 };
            chords(strands, chord.strand, chord.t[0], chord.t[1], count)
        };
        let mut closer = Vec::new();
        for (a, b) in &pairs {
            let (a, b) = (finer(a), finer(b));
            let both = a.iter().flat_map(|a| b.iter().map(move |b| (*a, *b)));
            closer.extend(both.filter(|(a, b)| crosses(a, b).is_some()).take(4));
        }
        pairs = closer;
    }
    pairs.first().and_then(|(a, b)| crosses(a, b))
}

/// Where two chords cross, both in their insides.
fn crosses(a: &Chord, b: &Chord) -> Option<Point> {
    let [p, q] = a.ends;
    let [v, w] = b.ends;
    if p.r.max(q.r) < v.r.min(w.r) || v.r.max(w.r) < p.r.min(q.r) {
        return None;
    }
    let side = |o: Point, d: Point, x: Point| (d.r - o.r) * (x.z - o.z) - (d.z - o.z) * (x.r - o.r);
    let (s, t) = (side(v, w, p), side(v, w, q));
    let (x, y) = (side(p, q, v), side(p, q, w));
    // What lies on the other chord to rounding does not cross it.
    let size = p.distance(q).max(v.distance(w));
    let clear = 1e-9 * size * size;
    let opposite = |s: f64, t: f64| s.abs() > clear && t.abs() > clear && (s > 0.0) != (t > 0.0);
    (opposite(s, t) && opposite(x, y)).then(|| {
        let k = s / (s - t);
        Point { r: p.r + k * (q.r - p.r), z: p.z + k * (q.z - p.z) }
    })
}
