//! Neighbouring rays, one after another: where one meets the wall is where the next one is looked for.
//!
//! In the lathe's frame the rays of a row are `P = M + s·D`, M and D linear in the pixel's number i, with s
//! counted from where the row passes the solid. A pixel is one of three things, the cheapest asked first:
//!
//! - **A root, followed** from the last pixel's by Newton's method, one step mostly ([`Sweep::follow`]), and
//!   certified to be the ray's first (`first.rs`).
//! - **One of a run of misses**, certified together ([`Sweep::look`], `clear.rs`).
//! - **Nothing certain**: within `doubt` of a silhouette, a rim or a cap. Its ray goes alone, as any other.

use super::path::{Path, flat};
use super::segment::{Cover, Segment};
use super::{Lathe, View};
use crate::hit::{Hit, Part};
use crate::math::{Math, Native};
use crate::rays::Rays;
use crate::vector::{F32x3, dot, vector};

/// A run of rays at a lathe, and the root that is followed along it.
pub(crate) struct Sweep<'a> {
    pub(super) lathe: View<'a>,
    /// Not if the rays spread too wide, or begin too near the solid, for what they share to be of use.
    is_usable: bool,
    /// M and D, in the frame, x scaled by √k.
    pub(super) rays: Rays,
    /// Where s = 0 is on the rays; that times `per_unit` is a distance along them.
    shift: f32,
    per_unit: f32,
    /// One beyond the last pixel.
    pub(super) end: u32,
    /// Every point of the solid on every ray of the run has |s| ≤ span.
    pub(super) span: f32,
    /// The largest |dz| and the least q of any ray of the run.
    pub(super) steep: f32,
    pub(super) q: f32,
    /// Whether they rise, or fall, or, as some do either: neither.
    rising: Option<bool>,
    /// The largest |∂z/∂i| within the span.
    pub(super) drift: f32,
    /// What lies nearer than this to a decision, in g or in z, is not decided here.
    pub(super) doubt: f32,
    /// The slope of a root behind which g comes to more than that: A² > 4·q·doubt.
    pub(super) slack: f32,
    /// A step s leaves an error of `s²/slope` over this.
    tolerance: f32,

    /// Whether there is a root to follow, and whether it enters the solid, 1, or leaves it, −1.
    following: bool,
    pub(super) sign: f32,
    /// Its place at the last pixel, how far it moved there, and how much farther than before.
    s: f32,
    step: f32,
    bend: f32,
    /// The segment it is in, and from where to where in it roots are certain.
    pub(super) index: usize,
    pub(super) segment: &'a Segment,
    from: f32,
    to: f32,
    /// Of what the rays may have passed before they come to the segment: K and J, and the cylinder.
    pub(super) k: f32,
    pub(super) j: f32,
    pub(super) reach: f32,
    /// The slope above which a root is certain.
    certain: f32,
    /// The pixel last looked at in vain.
    looked: u32,
}

/// What a ray sees of the surface.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    /// How far along the ray.
    pub t: f32,
    /// A vector along the outward normal, in object space.
    pub gradient: F32x3,
    /// 1 where the ray enters the solid, −1 where it leaves it.
    pub sign: f32,
}

/// What a look at a ray with no root to follow comes to.
pub(crate) enum Look {
    /// This and the following pixels, up to the given one, see nothing of the solid.
    Clear(u32),
    /// There may be a root to follow.
    Follow,
    /// The ray has to go alone.
    Unknown,
}

/// In units of the frame, where the largest radius is between 1 and 2: what silhouettes are left in doubt.
const DOUBT: f32 = 1.0 / 4096.0;

/// What rounding can do at a unit's distance: sixteen units of 2⁻²⁴, four times what it was seen to do.
const ROUNDING: f32 = 16.0 / 16_777_216.0;

/// How far from the root a step may leave off.
const ROOT: f32 = 1.0 / 4_194_304.0;

/// How often Newton's method, or a change of segment, is tried before the ray goes alone.
const STEPS: u32 = 4;

impl Lathe {
    /// The pixels from `start` to `end` of a row of rays, in object space. `unit` is the rays' own.
    #[inline(always)]
    pub(crate) fn sweep(&self, rays: &Rays, unit: f32, start: u32, end: u32) -> Sweep<'_> {
        let lathe = self.view();
        let frame = lathe.frame;
        let (d, d1) = (frame.squashed(rays.direction), frame.squashed(rays.direction_step));
        let o = frame.squashed(frame.point(rays.origin));
        let o1 = frame.squashed(rays.origin_step * frame.scale);

        let half = 0.5 * (end - start) as f32;
        let centre = start as f32 + half;
        let (oc, dc) = (o + o1 * centre, d + d1 * centre);
        let square = dot(dc, dc);
        let shift = -dot(oc, dc) / square;
        let (m, m1) = (o + d * shift, o1 + d1 * shift);
        let mc = oc + dc * shift;

        // |M + s·D| ≤ size means |s| ≤ |M·D|/D² + size/|D|. M·D vanishes in the middle of the run, and D² and
        // q are above their tangents there.
        let least = square - 2.0 * half * dot(dc, d1).abs();
        let length = Native::sqrt(least);
        let across = half * (dot(mc, d1) + dot(m1, dc)).abs() + half * half * dot(m1, d1).abs();
        let span = (across / length + frame.size) / length;
        let q = flat(dc, dc) - 2.0 * half * flat(dc, d1).abs();
        let steep = dc.z.abs() + half * d1.z.abs();
        let distance = shift.abs() * length + frame.size;
        let doubt = DOUBT + ROUNDING * distance * (2.0 + frame.steepest);
        let most = square + 2.0 * half * dot(dc, d1).abs() + half * half * dot(d1, d1);
        Sweep {
            lathe,
            is_usable: least > 0.25 * square
                && q > 0.0
                && shift > span
                && doubt < 0.25
                && frame.steepest < 1e9,
            rays: Rays { origin: m, origin_step: m1, direction: d, direction_step: d1 },
            shift,
            per_unit: 1.0 / (frame.scale * unit),
            end,
            span,
            steep,
            rising: (dc.z.abs() > half * d1.z.abs()).then_some(dc.z > 0.0),
            q,
            drift: m1.z.abs() + span * d1.z.abs(),
            doubt,
            slack: 4.0 * Native::sqrt(doubt),
            tolerance: ROOT / (most + frame.curvature * (steep * steep)),
            following: false,
            sign: 1.0,
            s: 0.0,
            step: 0.0,
            bend: 0.0,
            index: 0,
            segment: lathe.segments.first().unwrap_or(&Segment::EMPTY),
            from: 0.0,
            to: 0.0,
            k: 0.0,
            j: 0.0,
            reach: 0.0,
            certain: 0.0,
            looked: u32::MAX,
        }
    }
}

impl Sweep<'_> {
    /// The root of the last pixel, found again for the next one and certified.
    #[inline(always)]
    pub fn follow(&mut self, i: u32) -> Option<Seen> {
        if !self.following {
            return None;
        }
        let (m, d) = self.rays.at(i);
        let mut s = self.s + self.step + self.bend;
        for _ in 0..STEPS {
            let segment = self.segment;
            let (x, y) = (m.x + s * d.x, m.y + s * d.y);
            let u = (m.z + s * d.z - segment.low) * segment.per_height;
            let (f, f1, f2) = segment.slopes(u);
            let kappa = d.z * segment.per_height;
            let b = x * d.x + y * d.y;
            let slope = f1 * kappa - (b + b);
            let step = (f - (x * x + y * y)) / slope;
            s -= step;
            if !(step * step <= self.tolerance * (self.sign * slope)) {
                continue;
            }
            let u = u - step * kappa;
            if !(self.from <= u && u <= self.to) {
                if self.move_on(u) {
                    continue;
                }
                break;
            }
            if !(slope > self.certain || self.is_first(slope, b, f, d) || self.is_first_by_segments(i, s)) {
                break;
            }
            let moved = s - self.s;
            (self.bend, self.step, self.s) = (moved - self.step, moved, s);
            let f1 = f1 - f2 * (step * kappa);
            return Some(Seen {
                t: (self.shift + s) * self.per_unit,
                gradient: vector([
                    self.lathe.frame.root_squash * (x - step * d.x),
                    y - step * d.y,
                    -0.5 * segment.per_height * f1,
                ]),
                sign: self.sign,
            });
        }
        // At a silhouette, most likely. Looking would find the same root, or one that is too near it.
        (self.following, self.looked) = (false, i);
        None
    }

    /// On to the segment next to this one, where u says. False if there is none.
    #[inline(never)]
    fn move_on(&mut self, u: f32) -> bool {
        let next = if u > 1.0 { self.index + 1 } else { self.index.wrapping_sub(1) };
        self.enter(next)
    }

    #[inline(never)]
    fn enter(&mut self, index: usize) -> bool {
        let Some(segment) = self.lathe.segments.get(index) else {
            return false;
        };
        (self.index, self.segment) = (index, segment);
        let Cover { reach, bulge, kinks } = match self.rising {
            Some(true) => segment.below,
            Some(false) => segment.above,
            None => self.all(),
        };
        let pad = self.doubt * segment.per_height;
        self.from = if index == 0 { pad } else { 0.0 };
        self.to = if index + 1 == self.lathe.segments.len() { 1.0 - pad } else { 1.0 };
        self.k = bulge * (self.steep * self.steep) - self.q;
        self.j = kinks * self.steep;
        self.reach = reach;
        self.certain = if self.sign > 0.0 && self.k <= 0.0 { self.j + self.slack } else { f32::INFINITY };
        true
    }

    /// The whole profile's bounds.
    pub(super) fn all(&self) -> Cover {
        self.lathe.segments.first().map_or(Cover::NONE, |segment| segment.above)
    }

    /// With nothing to follow: do this pixel and the next ones certainly see nothing, or where may a root be?
    pub fn look(&mut self, i: u32) -> Look {
        if !self.is_usable || self.looked == i {
            return Look::Unknown;
        }
        self.looked = i;
        let (m, d) = self.rays.at(i);
        let path = Path::about(m, d, 0.0, 1.0);
        let crest = self.crest(&path);
        if crest.g < -self.doubt {
            return Look::Clear(i.saturating_add(1).saturating_add(self.clear_after(i, &path, crest.g)));
        }
        let Some((index, s)) = crest.entry else {
            return Look::Unknown;
        };
        (self.sign, self.s, self.step, self.bend) = (1.0, s, 0.0, 0.0);
        self.following = self.enter(index);
        Look::Follow
    }

    /// A ray gone alone meets the lathe here: there the next one's root is looked for.
    pub fn found(&mut self, hit: &Hit) {
        self.sign = if hit.enters { 1.0 } else { -1.0 };
        (self.s, self.step, self.bend) = (hit.t / self.per_unit - self.shift, 0.0, 0.0);
        self.following = self.is_usable && hit.part == Part::Wall && self.enter(hit.segment);
    }
}
