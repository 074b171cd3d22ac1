//! Where a ray meets a solid: numbers only.

/// A crossing of a ray and the surface of a solid.
///
/// What is seen of it (the point, the normal) is [`Lathe::surface`](crate::Lathe::surface)'s to say: most
/// hits are not seen.
///
/// ```
/// use embedded_lathe::{Lathe, Part, Profile, Ray, valid};
///
/// let ball = Lathe::turn(valid!(Profile::sphere(1.0)));
/// let ray = Ray::new([0.0, -3.0, 0.0], [0.0, 1.0, 0.0])?;
/// let hit = ball.nearest(&ray, 0.0).unwrap();
/// assert_eq!((hit.t, hit.enters, hit.part), (2.0, true, Part::Wall));
/// # Ok::<(), embedded_lathe::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Hit {
    /// The distance along the ray, in units of its direction.
    pub t: f32,
    /// The profile's segment, from 0 at the base.
    pub segment: usize,
    /// The profile's parameter in the segment, from 0 at its lower knot to 1 at its upper.
    pub u: f32,
    /// Whether the ray enters the solid here, or leaves it.
    pub enters: bool,
    /// Which part of the surface it is.
    pub part: Part,
}

/// The parts of a solid's surface.
///
/// ```
/// use embedded_lathe::{Lathe, Part, Profile, Ray, valid};
///
/// let drum = Lathe::turn(valid!(Profile::cylinder(1.0, 2.0)));
/// let down = Ray::new([0.3, 0.2, 5.0], [0.0, 0.0, -1.0])?;
/// assert_eq!(drum.nearest(&down, 0.0).unwrap().part, Part::Top);
/// # Ok::<(), embedded_lathe::RayError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Part {
    /// What the profile sweeps.
    Wall,
    /// The cap at the lower end.
    Base,
    /// The cap at the upper end.
    Top,
}
