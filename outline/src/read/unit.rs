//! What the numbers of a drawing are.

use svgtypes::{Length, LengthUnit};

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// Millimeters.
    Millimeter,
    /// The numbers have none, or one that is not told.
    None,
    /// So many millimeters. Numbers in it are turned into millimeters.
    Millimeters(f64),
}

impl Unit {
    /// From its name: mm, cm, in, pt, pc, px (96 an inch), or 1 for none; or with a factor before it, as in
    /// `0.1mm`.
    pub fn from_name(name: &str) -> Option<Self> {
        let length: Length = name.parse().or_else(|_| format!("1{name}").parse()).ok()?;
        if !(length.number > 0.0 && length.number.is_finite()) {
            return None;
        }
        match length.unit {
            LengthUnit::None => (length.number == 1.0).then_some(Self::None),
            _ => millimeters(length).map(Self::Millimeters),
        }
    }

    /// What numbers in it have to be multiplied by.
    pub(crate) fn factor(self) -> f64 {
        match self {
            Self::Millimeter | Self::None => 1.0,
            Self::Millimeters(factor) => factor,
        }
    }

    /// What they are afterwards.
    pub(crate) fn reduced(self) -> Self {
        match self {
            Self::Millimeters(_) => Self::Millimeter,
            unit => unit,
        }
    }

    /// Its name, as it follows a number.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::None => "",
            _ => " mm",
        }
    }
}

/// A length that has a unit of its own.
pub(crate) fn millimeters(length: Length) -> Option<f64> {
    let each = match length.unit {
        LengthUnit::Mm => 1.0,
        LengthUnit::Cm => 10.0,
        LengthUnit::In => 25.4,
        LengthUnit::Pt => 25.4 / 72.0,
        LengthUnit::Pc => 25.4 / 6.0,
        LengthUnit::Px => 25.4 / 96.0,
        LengthUnit::None | LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => return None,
    };
    Some(length.number * each)
}
