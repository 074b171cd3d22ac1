//! A body in the types that the crate has for it: the one place that knows them.
//!
//! A sheet is a profile, its flats steps at the profile's ends. All the sheets of a body are one solid.

use crate::{Body, Sheet, Side};
use embedded_lathe::{Lathe, Profile, ProfileError, Segment};
use std::fmt::Write;

/// A body's profiles, one for each sheet.
#[derive(Clone, Debug)]
pub struct Profiles(Vec<Numbers>);

#[derive(Clone, Debug)]
struct Numbers {
    side: Side,
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
        Self { side: sheet.side, segments: sheet.segments().count(), knots, ordinates }
    }
}

impl Profiles {
    /// Those of a body.
    pub fn of(body: &Body) -> Self {
        Self(body.sheets.iter().map(Numbers::of).collect())
    }

    /// Turned, for at most N segments each, about the height that the first one is turned about.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] if the crate refuses one: more segments than N, for one.
    pub fn turned<const N: usize>(&self) -> Result<Vec<Lathe<[Segment; N]>>, ProfileError> {
        let profile = |sheet: &Numbers| Profile::<N>::from_squared_radii(&sheet.knots, &sheet.ordinates);
        let profiles = self.0.iter().map(profile).collect::<Result<Vec<_>, _>>()?;
        let turned = |profile: &Profile<N>| Lathe::turn_beside(*profile, &profiles[0]);
        Ok(profiles.iter().map(turned).collect())
    }

    /// The sheets of lathes that are [turned](Self::turned), for [`Solid::body`](embedded_lathe::Solid::body).
    pub fn sheets<'a, const N: usize>(
        &self,
        lathes: &'a [Lathe<[Segment; N]>],
    ) -> Vec<embedded_lathe::Sheet<'a>> {
        let sheet = |(numbers, lathe): (&Numbers, &'a Lathe<[Segment; N]>)| match numbers.side {
            Side::Outer => embedded_lathe::Sheet::outer(lathe),
            Side::Inner => embedded_lathe::Sheet::inner(lathe),
        };
        self.0.iter().zip(lathes).map(sheet).collect()
    }

    /// The source text: one `static`, a solid; of several sheets a body.
    pub fn source(&self, name: &str) -> String {
        let mut text = format!("pub static {name}: Solid = {{\n");
        if let [numbers] = self.0.as_slice() {
            let _ = writeln!(text, "    static LATHE: Lathe<[Segment; {}]> =", numbers.segments);
            text.push_str("        Lathe::turn(valid!(Profile::from_squared_radii(\n");
            lists(&mut text, numbers);
            text.push_str("        )));\n");
            let _ = writeln!(text, "    Solid::new(&LATHE, {COLOR})\n}};");
            return text;
        }
        for (i, numbers) in self.0.iter().enumerate() {
            let _ = writeln!(text, "    const PROFILE_{i}: Profile<{}> =", numbers.segments);
            text.push_str("        valid!(Profile::from_squared_radii(\n");
            lists(&mut text, numbers);
            text.push_str("        ));\n");
        }
        let mut sheets = String::new();
        for (i, Numbers { side, segments, .. }) in self.0.iter().enumerate() {
            let turned = match i {
                0 => "Lathe::turn(PROFILE_0)".into(),
                i => format!("Lathe::turn_beside(PROFILE_{i}, &PROFILE_0)"),
            };
            let _ = writeln!(text, "    static LATHE_{i}: Lathe<[Segment; {segments}]> = {turned};");
            let side = if *side == Side::Outer { "outer" } else { "inner" };
            let _ = writeln!(sheets, "        Sheet::{side}(&LATHE_{i}),");
        }
        let _ = writeln!(text, "    static SHEETS: [Sheet; {}] = [\n{sheets}    ];", self.0.len());
        let _ = writeln!(text, "    valid!(Solid::body(&SHEETS, {COLOR}))\n}};");
        text
    }
}

/// What a solid is printed with: terracotta.
const COLOR: &str = "Rgb::new(0.85, 0.45, 0.3)";

fn lists(text: &mut String, numbers: &Numbers) {
    list(text, &numbers.knots);
    list(text, &numbers.ordinates);
}

/// Numbers in lines of a decent length.
fn list(text: &mut String, numbers: &[f32]) {
    text.push_str("            &[\n");
    let mut line = String::new();
    for number in numbers {
        let number = format!("{number:?},");
        if line.len() + number.len() > 90 {
            let _ = writeln!(text, "               {line}");
            line.clear();
        }
        let _ = write!(line, " {number}");
    }
    let _ = writeln!(text, "               {line}");
    text.push_str("            ],\n");
}
