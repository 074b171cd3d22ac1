//! A lathe, or several that bound one body, with a place in the world and a color.

use crate::arithmetic::Gloss;
use crate::color::Rgb;
use crate::hit::Hit;
use crate::lathe::Lathe;
use crate::math::minmax::greater;
use crate::pose::Pose;
use crate::ray::{Ray, RayError};
use crate::scene_error::SceneError;
use crate::sheet::Sheet;
use crate::shell::is_shell;
use crate::solve::Newton;
use crate::surface::Surface;
use crate::vector::{F32x3, array, difference, one_norm, scale, sum, vector};
use heapless::Vec;

/// A turned solid in the world: its shape, its pose, its color and how shiny it is.
///
/// ```
/// use embedded_lathe::{Lathe, Pose, Profile, Rgb, Rotation, Segment, Solid, valid};
///
/// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
/// static RED_BALL: Solid = Solid::new(&BALL, Rgb::new(0.9, 0.2, 0.1))
///     .posed(valid!(Pose::new([0.0, 0.0, 1.0], Rotation::IDENTITY, 0.5)))
///     .shiny(20);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid<'a> {
    /// The lathe of a solid that is no body, as an outer sheet; the first sheet of a body.
    first: Sheet<'a>,
    /// The other sheets of a body; empty if the solid is no body.
    rest: &'a [Sheet<'a>],
    /// Half the height of the cylinder around all sheets, and its radius, in the solid's own space.
    half_height: f32,
    radius: f32,
    /// Whether it is a body whose sheets do not hide one another from outside.
    is_shell: bool,
    pose: Pose,
    color: Rgb,
    gloss: Gloss,
}

impl<'a> Solid<'a> {
    /// A matt solid in the pose [`Pose::IDENTITY`].
    #[must_use]
    pub const fn new(lathe: &'a Lathe, color: Rgb) -> Self {
        Self {
            first: Sheet::outer(lathe),
            rest: &[],
            half_height: lathe.half_height(),
            radius: lathe.radius(),
            is_shell: false,
            pose: Pose::IDENTITY,
            color,
            gloss: Gloss::new(0),
        }
    }

    /// A matt body bounded by several sheets about one axis, in the pose [`Pose::IDENTITY`].
    ///
    /// A closed outline that goes up and comes down again, or turns back in height, is cut where it turns. A
    /// sheet whose material is inside of it is an outer one, a sheet whose material is outside an inner one.
    /// Two sheets may meet in a rim that is a flat ring. Then one of the two profiles, either of them, has
    /// that ring as a step at its end.
    ///
    /// ```
    /// use embedded_lathe::*;
    ///
    /// // A cup: its wall, with the rim as a step at the top, and its hollow, which ends there.
    /// const WALL: Profile<1> = valid!(Profile::from_squared_radii(
    ///     &[0.0, 1.0, 1.0],
    ///     &[0.16, 0.2, 0.22, 0.25, 0.2],
    /// )?
    /// .base(End::Capped));
    /// const HOLLOW: Profile<1> = valid!(Profile::from_squared_radii(
    ///     &[0.1, 1.0],
    ///     &[0.12, 0.16, 0.18, 0.2],
    /// )?
    /// .base(End::Capped));
    ///
    /// static SHEETS: [Lathe<[Segment; 1]>; 2] = [Lathe::turn(WALL), Lathe::turn_beside(HOLLOW, &WALL)];
    /// static CUP: [Sheet; 2] = [Sheet::outer(&SHEETS[0]), Sheet::inner(&SHEETS[1]).colored(Rgb::WHITE)];
    /// static SOLIDS: [Solid; 1] = [valid!(Solid::body(&CUP, Rgb::new(0.2, 0.3, 0.7)))];
    ///
    /// let down = Ray::new([0.1, 0.0, 3.0], [0.0, 0.0, -1.0])?;
    /// let bottom = SOLIDS[0].nearest(&down, 0.0).unwrap();
    /// assert!((bottom.t - 2.9).abs() < 1e-6 && bottom.enters);
    /// assert_eq!(SOLIDS[0].surface(&down, &bottom).normal, [0.0, 0.0, 1.0]);
    /// assert!(SOLIDS[0].is_inside([0.1, 0.0, 0.05]) && !SOLIDS[0].is_inside([0.1, 0.0, 0.5]));
    /// # Ok::<(), RayError>(())
    /// ```
    ///
    /// # Inside
    ///
    /// A point is inside the body if more outer sheets than inner ones hold it; a sheet holds what is between
    /// its ends and within its wall. If the outline is closed, the number of outer sheets that hold a point
    /// exceeds that of inner ones by one or by zero. The crossings of the body are those of its sheets, and
    /// [`Hit::enters`] says whether the ray enters the material. If sheets leave gaps or overlap, all their
    /// crossings are still reported.
    ///
    /// No ray slips between two sheets that meet at a height, with a squared radius that is the same number
    /// in both profiles. For this, all sheets are prepared about one height: the first by [`Lathe::turn`],
    /// the others by [`Lathe::turn_beside`] the first. And rays are cast at a body by the traversal alone,
    /// since the two ways to cast a ray may differ where it grazes a rim: the fast path may find a hit there,
    /// and the traversal none.
    ///
    /// A body whose first sheet is an outer one, and all others hollows within it, each closed or joined to it
    /// by a rim at either end, takes the least time in a picture: seen from outside, its sheets are not
    /// compared by their distances.
    ///
    /// # Errors
    ///
    /// [`SceneError::NoSheets`] if there is none, [`SceneError::SheetMiddle`] if one is not prepared about
    /// the height that the first one is, and [`SceneError::SheetSquash`] if one is not squashed as the first
    /// one is.
    pub const fn body(sheets: &'a [Sheet<'a>], color: Rgb) -> Result<Self, SceneError> {
        let [first, rest @ ..] = sheets else {
            return Err(SceneError::NoSheets);
        };
        let alone = Self::new(first.lathe(), color);
        let mut body = Self { first: *first, rest, is_shell: is_shell(sheets), ..alone };
        let (own, mut sheet) = (first.lathe(), 1);
        while sheet < sheets.len() {
            let other = sheets[sheet].lathe();
            if other.middle() != own.middle() {
                return Err(SceneError::SheetMiddle { sheet, middle: other.middle(), first: own.middle() });
            }
            if other.squash() != own.squash() {
                return Err(SceneError::SheetSquash { sheet, squash: other.squash(), first: own.squash() });
            }
            body.half_height = body.half_height.max(other.half_height());
            body.radius = body.radius.max(other.radius());
            sheet += 1;
        }
        Ok(body)
    }

    /// This solid in another pose.
    #[must_use]
    pub const fn posed(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// This solid in another color.
    #[must_use]
    pub const fn colored(self, color: Rgb) -> Self {
        Self { color, ..self }
    }

    /// This solid with a highlight, given the exponent of Phong's model: the highlight is wide at 5, narrow
    /// at 100. Zero is matt.
    #[must_use]
    pub const fn shiny(self, exponent: u8) -> Self {
        Self { gloss: Gloss::new(exponent), ..self }
    }

    /// Its shape; of a body, the first sheet's.
    #[must_use]
    pub const fn lathe(&self) -> &'a Lathe {
        self.first.lathe()
    }

    /// Its sheets, the first one first: of a solid that is no body, its lathe as an outer sheet.
    pub fn sheets(&self) -> impl Iterator<Item = &Sheet<'a>> {
        let (mut next, mut rest) = (Some(&self.first), self.rest.iter());
        core::iter::from_fn(move || core::mem::replace(&mut next, rest.next()))
    }

    /// Whether it has more than one sheet.
    pub(crate) const fn is_body(&self) -> bool {
        !self.rest.is_empty()
    }

    /// Whether it is a body of which every ray from outside sees the one sheet that it first meets from the
    /// side without material: see [`is_shell`].
    pub(crate) const fn is_shell(&self) -> bool {
        self.is_shell
    }

    /// Its position, rotation and scale.
    #[must_use]
    pub const fn pose(&self) -> Pose {
        self.pose
    }

    /// Its color.
    #[must_use]
    pub const fn color(&self) -> Rgb {
        self.color
    }

    /// The color of one of its sheets: the sheet's own, or else the solid's.
    #[inline(always)]
    pub(crate) fn color_of<'s>(&'s self, sheet: &'s Sheet) -> &'s Rgb {
        sheet.color.as_ref().unwrap_or(&self.color)
    }

    /// The exponent of its highlight, or zero if it is matt.
    #[must_use]
    pub const fn shininess(&self) -> u8 {
        self.gloss.exponent
    }

    /// Its highlight.
    pub(crate) const fn gloss(&self) -> &Gloss {
        &self.gloss
    }

    /// The nearest crossing of a ray of the world beyond `t_min`, as [`Lathe::nearest`]. Of a body, segments
    /// are counted from sheet to sheet: those of the second one go on where the first one's end.
    #[must_use]
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        let ray = &self.ray_into(ray);
        if !self.is_body() {
            return self.lathe().nearest(ray, t_min);
        }
        let (mut nearest, mut segments) = (None, 0);
        for sheet in self.sheets() {
            if let Some(hit) = sheet.lathe().nearest_by::<Newton>(ray, t_min)
                && nearest.is_none_or(|nearest: Hit| hit.t < nearest.t)
            {
                nearest = Some(Hit { segment: segments + hit.segment, ..sheet.hit(hit) });
            }
            segments += sheet.lathe().segments();
        }
        nearest
    }

    /// Whether a ray of the world crosses the solid beyond `t_min`, as [`Lathe::is_hit`].
    #[must_use]
    pub fn is_hit(&self, ray: &Ray, t_min: f32) -> bool {
        self.nearest(ray, t_min).is_some()
    }

    /// The crossings of a ray of the world beyond `t_min`, in order, as [`Lathe::hits`]: the C nearest ones,
    /// if there are more. A sheet of n segments is crossed 4·n + 1 times at most.
    #[must_use]
    pub fn hits<const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        let ray = &self.ray_into(ray);
        let (mut hits, mut segments) = (Vec::new(), 0);
        for sheet in self.sheets() {
            let see = |hit: Hit| insert(&mut hits, Hit { segment: segments + hit.segment, ..sheet.hit(hit) });
            if self.is_body() {
                sheet.lathe().each_hit_by::<Newton>(ray, t_min, see);
            } else {
                sheet.lathe().each_hit(ray, t_min, see);
            }
            segments += sheet.lathe().segments();
        }
        hits
    }

    /// Whether a point of the world is inside the solid: if its sheet holds it, or more outer sheets of a
    /// body than inner ones.
    #[must_use]
    pub fn is_inside(&self, point: [f32; 3]) -> bool {
        let point = array(self.pose.point_into(vector(point)));
        let sides = self.sheets().filter(|sheet| sheet.lathe().is_inside(point));
        sides.map(|sheet| if sheet.is_inner() { -1 } else { 1 }).sum::<i32>() > 0
    }

    /// The sheet that was hit.
    #[must_use]
    pub fn sheet_of(&self, hit: &Hit) -> &Sheet<'a> {
        self.located(hit).1
    }

    /// The number of the sheet that was hit, as [`Solid::sheets`] lists them: 0 for a solid that is no body.
    #[must_use]
    pub fn sheet_number(&self, hit: &Hit) -> usize {
        self.located(hit).0
    }

    /// The number of the sheet that was hit, the sheet, and the hit as one of that sheet's lathe: its segment
    /// counted from that lathe's first, and `enters` reversed if the sheet is an inner one. A segment beyond
    /// the body's last counts as one of the last sheet.
    fn located(&self, hit: &Hit) -> (usize, &Sheet<'a>, Hit) {
        let (mut number, mut sheet, mut segment) = (0, &self.first, hit.segment);
        for next in self.rest {
            let Some(after) = segment.checked_sub(sheet.lathe().segments()) else { break };
            (number, sheet, segment) = (number + 1, next, after);
        }
        (number, sheet, sheet.hit(Hit { segment, ..*hit }))
    }

    /// The point and the normal of a hit, in the world, as [`Lathe::surface`]: the normal points out of the
    /// material.
    #[must_use]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let (_, sheet, hit) = self.located(hit);
        let normal = self.pose.rotation.turn(sheet.lathe().normal(&self.ray_into(ray), &hit));
        let normal = if sheet.is_inner() { normal * -1.0 } else { normal };
        Surface { point: ray.at(hit.t), normal: array(normal) }
    }

    /// A ray of the world that goes on from a hit of this solid, as [`Lathe::spawn`]. The offset is
    /// `16·2⁻²⁴·(4·R + distance + |origin| + |point|)`, all measured in the world. R is the radius of a ball
    /// about the middle of the axis that contains the solid; if the solid is stretched along x, the solid
    /// without that stretch. `|origin|` and `|point|` are the sums |x| + |y| + |z| of the coordinates of the
    /// ray's origin and of the hit. `distance` is the same sum for the vector from the pose's position to the
    /// ray's origin, plus the distance of the position from the middle of the axis.
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Pose, Profile, Ray, Rgb, Rotation, Segment, Solid, valid};
    ///
    /// static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// let ball = Solid::new(&BALL, Rgb::WHITE);
    /// let solids = [ball, ball.posed(Pose::new([3.0, 0.0, 0.0], Rotation::IDENTITY, 1.0)?)];
    ///
    /// let ray = Ray::new([0.9, -4.0, 0.0], [0.0, 1.0, 0.0])?;
    /// let hit = solids[0].nearest(&ray, 0.0).unwrap();
    /// let to_light = solids[0].spawn(&ray, &hit, [1.0, 0.0, 0.0])?;
    /// assert!(solids.iter().any(|solid| solid.is_hit(&to_light, 0.0))); // in the second one's shadow
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Ray::new`]: for `direction`, and for a starting point beyond f32's range.
    pub fn spawn(&self, ray: &Ray, hit: &Hit, direction: [f32; 3]) -> Result<Ray, RayError> {
        let Pose { position, scale, .. } = self.pose;
        let ball = self.sheets().map(|sheet| sheet.lathe().ball()).fold(0.0, greater);
        let own = scale * (4.0 * ball + self.lathe().middle().abs());
        let lengths = own + one_norm(difference(ray.origin, position)) + one_norm(ray.origin);
        self.surface(ray, hit).spawn(direction, lengths)
    }

    /// A ray of the world in object space, with the same t.
    #[inline]
    pub(crate) const fn ray_into(&self, ray: &Ray) -> Ray {
        Ray {
            origin: self.pose.point_into(ray.origin),
            direction: self.direction_into(ray.direction),
            unit: ray.unit / self.pose.scale,
        }
    }

    /// A direction of the world in object space. Its length does not change.
    #[inline(always)]
    pub(crate) const fn direction_into(&self, direction: F32x3) -> F32x3 {
        self.pose.rotation.back(direction)
    }

    /// The point of the world where object space has its origin.
    pub(crate) const fn position(&self) -> F32x3 {
        self.pose.position
    }

    /// The vector from a point to the center of the cylinder around the solid, in the world.
    pub(crate) const fn center_from(&self, point: F32x3) -> F32x3 {
        // The positions are subtracted first: if the smaller vector were added to a large position before, it
        // would be lost to rounding.
        let to_position = difference(self.pose.position, point);
        sum(to_position, scale(self.axis(), self.lathe().middle() * self.pose.scale))
    }

    /// The unit vector along the solid's axis, in the world.
    pub(crate) const fn axis(&self) -> F32x3 {
        self.pose.rotation.axis()
    }

    /// Half the height of the cylinder around the solid, in the world.
    pub(crate) const fn half_height(&self) -> f32 {
        self.half_height * self.pose.scale
    }

    /// The radius of the cylinder around the solid, in the world. Infinite if the squash k is zero: then the
    /// solid is endless along x.
    pub(crate) const fn radius(&self) -> f32 {
        self.radius * self.pose.scale
    }
}

/// Inserts a hit into a list in order of t, after those of the same t. If the list is full, the farthest of
/// all is left out: that may be `hit` itself.
fn insert<const C: usize>(hits: &mut Vec<Hit, C>, mut hit: Hit) {
    let mut is_behind = false;
    for other in hits.iter_mut() {
        is_behind |= hit.t < other.t;
        if is_behind {
            core::mem::swap(other, &mut hit);
        }
    }
    let _ = hits.push(hit);
}

#[cfg(feature = "defmt")]
impl defmt::Format for Solid<'_> {
    fn format(&self, f: defmt::Formatter) {
        let Self { pose, color, .. } = self;
        defmt::write!(f, "Solid {{ pose: {}, color: {}, shininess: {} }}", pose, color, self.shininess());
    }
}
