//! A crossing of a ray and a surface: where it is along the ray and on the profile.

/// A crossing of a ray and the surface of a solid.
///
/// It holds neither the point nor the normal: most crossings are not visible.
/// [`Lathe::surface`](crate::Lathe::surface) computes both where they are needed.
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
    /// The ray's parameter at the crossing: the distance, in lengths of the ray's direction.
    pub t: f32,
    /// The index of the profile's segment, 0 for the lowest. Of a cap or a ring it is the segment whose end
    /// it is at.
    pub segment: usize,
    /// The profile's parameter in the segment, from 0 at its lower knot to 1 at its upper knot. Of a cap or a
    /// ring it is exactly 0 or 1.
    pub u: f32,
    /// Whether the ray enters the solid here. If `false`, it leaves the solid.
    pub enters: bool,
    /// The part of the surface that is crossed.
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
    /// The wall: the surface that the profile sweeps out.
    Wall,
    /// The cap or the ring at the lower end.
    Base,
    /// The cap or the ring at the upper end.
    Top,
    /// The ring of a step between two segments. It faces up where [`Hit::u`] is 1, the upper end of the
    /// segment below, and down where [`Hit::u`] is 0, the lower end of the segment above.
    Ring,
}
