//! A body in the types that the crate has for it: the one place that knows them.
//!
//! A profile has no steps and no rings. So each stretch of a sheet between two steps is a profile of its own, all of
//! them in one pose. At a step of an outer wall the wider of the two stretches gets a flat cap, which the
//! narrower one stands on, or hangs from. What no cap can close is left open: see [`Profiles::open`].

use crate::{Body, Sheet, Side};
use embedded_lathe::{End, Lathe, Profile, ProfileError, Segment};
use std::fmt::Write;

/// A body's profiles.
#[derive(Clone, Debug)]
pub struct Profiles {
    profiles: Vec<Stretch>,
    /// The rings that are left open, by height and radii.
    pub open: Vec<(f64, [f64; 2])>,
}

#[derive(Clone, Debug)]
struct Stretch {
    knots: Vec<f32>,
    ordinates: Vec<f32>,
    /// Whether there is a cap, below and above.
    caps: [bool; 2],
}

impl Profiles {
    /// Those of a body.
    pub fn of(body: &Body) -> Self {
        let mut all = Self { profiles: Vec::new(), open: Vec::new() };
        body.sheets.iter().for_each(|sheet| all.add(sheet));
        all
    }

    fn add(&mut self, sheet: &Sheet) {
        let first = self.profiles.len();
        let mut knots = vec![sheet.knots[0]];
        let mut from = 0;
        for pair in sheet.knots.windows(2) {
            if pair[0] == pair[1] {
                from = self.push(&mut knots, sheet, from);
            }
            knots.push(pair[1]);
            if pair[0] == pair[1] {
                knots = vec![pair[1]];
            }
        }
        self.push(&mut knots, sheet, from);
        // The steps between two stretches.
        for i in first + 1..self.profiles.len() {
            let [below, above] = [self.end(i - 1, true), self.end(i, false)];
            if sheet.side == Side::Outer {
                let (wider, cap) = if below > above { (i - 1, 1) } else { (i, 0) };
                self.profiles[wider].caps[cap] = true;
            } else {
                self.leave(self.profiles[i].knots[0], below, above);
            }
        }
        let last = self.profiles.len() - 1;
        for (flat, at, cap) in [(sheet.base, first, 0), (sheet.top, last, 1)] {
            let Some(to) = flat else { continue };
            let end = self.end(at, cap == 1);
            if to == 0.0 {
                self.profiles[at].caps[cap] = true;
            } else {
                let stretch = &self.profiles[at];
                let height = if cap == 1 { stretch.knots[stretch.knots.len() - 1] } else { stretch.knots[0] };
                self.leave(height, end, to);
            }
        }
    }

    /// Adds the stretch whose ordinates begin at `from`; the next one's begin at what is returned.
    fn push(&mut self, knots: &mut Vec<f32>, sheet: &Sheet, from: usize) -> usize {
        let end = from + 3 * (knots.len() - 1) + 1;
        let ordinates = sheet.ordinates[from..end].to_vec();
        self.profiles.push(Stretch { knots: core::mem::take(knots), ordinates, caps: [false; 2] });
        end
    }

    fn end(&self, profile: usize, upper: bool) -> f32 {
        let ordinates = &self.profiles[profile].ordinates;
        if upper { ordinates[ordinates.len() - 1] } else { ordinates[0] }
    }

    fn leave(&mut self, height: f32, from: f32, to: f32) {
        let radii = [from.min(to), from.max(to)].map(|square| f64::from(square).sqrt());
        self.open.push((f64::from(height), radii));
    }

    /// Turned, for as many segments as there may be in one of them.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] if the crate refuses one: more segments than N, for one.
    pub fn turned<const N: usize>(&self) -> Result<Vec<Lathe<[Segment; N]>>, ProfileError> {
        let ends = |capped: bool| if capped { End::Capped } else { End::Open };
        self.profiles
            .iter()
            .map(|profile| {
                let turned = Profile::<N>::from_squared_radii(&profile.knots, &profile.ordinates)?;
                let [base, top] = profile.caps.map(ends);
                Ok(Lathe::turn(turned.base(base).top(top)))
            })
            .collect()
    }

    /// The source text: a `static` for each, and if there are several, one with all of them as solids.
    pub fn source(&self, name: &str) -> String {
        let mut text = String::new();
        let count = self.profiles.len();
        let names: Vec<String> = if count == 1 {
            vec![name.to_string()]
        } else {
            (1..=count).map(|i| format!("{name}_{i}")).collect()
        };
        for (profile, name) in self.profiles.iter().zip(&names) {
            let segments = profile.knots.len() - 1;
            let _ = writeln!(text, "pub static {name}: Lathe<[Segment; {segments}]> = Lathe::turn(");
            text.push_str("    valid!(Profile::from_squared_radii(\n");
            list(&mut text, &profile.knots);
            list(&mut text, &profile.ordinates);
            text.push_str("    ))");
            let methods = [".base(End::Capped)", ".top(End::Capped)"];
            for (method, _) in methods.iter().zip(profile.caps).filter(|(_, cap)| *cap) {
                let _ = write!(text, "\n    {method}");
            }
            text.push_str(",\n);\n");
        }
        if count > 1 {
            let _ = writeln!(text, "pub static {name}: [Solid; {count}] = [");
            for name in &names {
                let _ = writeln!(text, "    Solid::new(&{name}, Rgb::new(0.85, 0.45, 0.3)),");
            }
            text.push_str("];\n");
        }
        text
    }
}

/// Numbers in lines of a decent length.
fn list(text: &mut String, numbers: &[f32]) {
    text.push_str("        &[\n");
    let mut line = String::new();
    for number in numbers {
        let number = format!("{number:?},");
        if line.len() + number.len() > 90 {
            let _ = writeln!(text, "           {line}");
            line.clear();
        }
        let _ = write!(line, " {number}");
    }
    let _ = writeln!(text, "           {line}");
    text.push_str("        ],\n");
}
