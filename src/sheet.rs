//! A part of a *body*'s surface, a *sheet*: a lathe, and the side of it that the material is on.

use crate::color::Rgb;
use crate::hit::Hit;
use crate::lathe::Lathe;

/// One of the sheets that bound a body: a turned profile with the material inside of it, or outside.
///
/// A profile has one radius at each height. So a wall with thickness needs two sheets, and so does an outline
/// that passes a height twice: see [`Solid::body`](crate::Solid::body).
///
/// ```
/// use embedded_lathe::*;
///
/// static WALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(0.5, 1.0)?.top(End::Open)));
/// static RED_OUTSIDE: Sheet = Sheet::outer(&WALL).colored(Rgb::new(0.8, 0.1, 0.1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet<'a> {
    lathe: &'a Lathe,
    is_inner: bool,
    pub(crate) color: Option<Rgb>,
}

impl<'a> Sheet<'a> {
    /// A sheet with the material inside: an outer wall.
    #[must_use]
    pub const fn outer(lathe: &'a Lathe) -> Self {
        Self { lathe, is_inner: false, color: None }
    }

    /// A sheet with the material outside: the wall of a hollow.
    #[must_use]
    pub const fn inner(lathe: &'a Lathe) -> Self {
        Self { lathe, is_inner: true, color: None }
    }

    /// This sheet in a color of its own, instead of the body's.
    #[must_use]
    pub const fn colored(self, color: Rgb) -> Self {
        Self { color: Some(color), ..self }
    }

    /// Its shape.
    #[must_use]
    pub const fn lathe(&self) -> &'a Lathe {
        self.lathe
    }

    /// Whether the material is outside of it.
    #[must_use]
    pub const fn is_inner(&self) -> bool {
        self.is_inner
    }

    /// Its own color, if it has one.
    #[must_use]
    pub const fn color(&self) -> Option<Rgb> {
        self.color
    }

    /// Converts a hit of this sheet's lathe to a hit of the body: `enters` becomes whether the ray enters the
    /// material, so on an inner sheet it is reversed.
    #[inline(always)]
    pub(crate) fn hit(&self, hit: Hit) -> Hit {
        Hit { enters: hit.enters != self.is_inner, ..hit }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Sheet<'_> {
    fn format(&self, f: defmt::Formatter) {
        defmt::write!(f, "Sheet {{ is_inner: {}, color: {} }}", self.is_inner, self.color);
    }
}
