//! A body in the types that the crate has for it: the one place that knows them.
//!
//! A sheet is a profile, its flats steps at the profile's ends. All the sheets of a body are solids in one pose.

use crate::{Body, Sheet};
use embedded_lathe::{Lathe, Profile, ProfileError, Segment};
use std::fmt::Write;

/// A body's profiles, one for each sheet.
#[derive(Clone, Debug)]
pub struct Profiles(Vec<Numbers>);

#[derive(Clone, Debug)]
struct Numbers {
    segments: usize,
    knots: Vec<f32>,
    ordinates: Vec<f32>,
}

impl Numbers {
    fn of(sheet: &Sheet) -> Self {
        let (mut knots, mut ordinates) = (sheet.knots.clone(), sheet.ordinates.clone());
        let [low, high] = sheet.ends();
        if let Some(base) = sheet.base.filter(|base| *base != low) {
            knots.insert(0, knots[0]);
            ordinates.insert(0, base);
        }
        if let Some(top) = sheet.top.filter(|top| *top != high) {
            knots.push(knots[knots.len() - 1]);
            ordinates.push(top);
        }
        Self { segments: sheet.segments().count(), knots, ordinates }
    }
}

impl Profiles {
    /// Those of a body.
    pub fn of(body: &Body) -> Self {
        Self(body.sheets.iter().map(Numbers::of).collect())
    }

    /// Turned, for at most N segments each.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] if the crate refuses one: more segments than N, for one.
    pub fn turned<const N: usize>(&self) -> Result<Vec<Lathe<[Segment; N]>>, ProfileError> {
        let turned = |sheet: &Numbers| {
            Profile::<N>::from_squared_radii(&sheet.knots, &sheet.ordinates).map(Lathe::turn)
        };
        self.0.iter().map(turned).collect()
    }

    /// The source text: a `static` for each, and if there are several, one with all of them as solids.
    pub fn source(&self, name: &str) -> String {
        let mut text = String::new();
        let count = self.0.len();
        let names: Vec<String> = if count == 1 {
            vec![name.to_string()]
        } else {
            (1..=count).map(|i| format!("{name}_{i}")).collect()
        };
        for (Numbers { segments, knots, ordinates }, name) in self.0.iter().zip(&names) {
            let _ = writeln!(text, "pub static {name}: Lathe<[Segment; {segments}]> =");
            text.push_str("    Lathe::turn(valid!(Profile::from_squared_radii(\n");
            list(&mut text, knots);
            list(&mut text, ordinates);
            text.push_str("    )));\n");
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
