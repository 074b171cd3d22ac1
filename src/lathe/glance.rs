//! What most rays meet, told without a walk.
//!
//! At a place on a ray, at the heights of the solid, g is known, and its slope. Everywhere else it lies below a
//! parabola, by the whole profile's bounds: over the distance s from there,
//!
//! `g ≤ c0 + (|c1| + J)·|s| + K·s²`, J = kinks·|dz|, K = bulge·dz² − q.
//!
//! If that does not come up to zero the ray misses. Otherwise the segment's own parabola tells where there may be a root,
//! or where g is greatest: the next place to look at. Once a root is in the segment looked at, Newton's method finds it;
//! and if its slope A exceeds J, `g ≤ −(A − J)·x + K·x²` at x before it: it is the first.
//!
//! The first place is the one nearest to the axis, which all but a few rays need no other than.
//! What is nearer to a decision than doubt, some times what rounding can do to g, is left to the walk: below zero g must
//! be by more; behind a root it must rise above that, as it does where `(A − J)² > 4·doubt·|g″/2|`; and the segment's
//! ends, and the ray's start, must be farther away.

use super::line::Line;
use super::path::flat;
use super::run::ROUNDING;
use super::{View, is_beyond};
use crate::hit::{Hit, Part};
use crate::math::order::greater;
use crate::math::{Math, Native};

/// What is seen at a glance.
pub(super) enum Glance {
    Misses,
    Meets(Hit),
    /// It takes a walk to tell.
    Unclear,
}

/// A decision nearer than this part of the radius, squared, is not made at a glance.
const MOST_DOUBT: f32 = 0.25;

/// How many places are looked at, at most.
const LOOKS: u32 = 3;

/// How many of Newton's steps are taken, at most.
const STEPS: u32 = 4;

/// How far from the root, in the frame, a step may leave off.
const ROOT: f32 = 1.0 / 33_554_432.0;

impl View<'_> {
    /// What a line that is not steep, and passes through the cylinder around the solid, meets beyond `t_min`.
    #[inline]
    pub fn glance(&self, line: &Line, t_min: f32) -> Glance {
        let View { frame, segments } = *self;
        let Line { point: mut p, direction: d, q, mut back, .. } = *line;
        let rise = d.z * d.z;
        let (jump, curve) = (frame.kinks * d.z.abs(), frame.bulge * rise - q);
        let doubt = ROUNDING * (2.0 + frame.steepest) * (frame.size + back.abs() * (q + rise));
        if !(curve < 0.0 && doubt < MOST_DOUBT) {
            return Glance::Unclear;
        }

        // Beyond an end's plane, on that plane. Farther from the axis the solid is on one side of it.
        let mut ahead = 0.0;
        if !(frame.low <= p.z && p.z <= frame.high) {
            let end = if p.z > frame.high { frame.high } else { frame.low };
            ahead = (end - p.z) / d.z;
            if flat(p, p) + q * (ahead * ahead) > frame.reach {
                return Glance::Misses;
            }
            p += d * ahead;
            (p.z, back) = (end, back - ahead);
        }

        let mut looks = LOOKS;
        let (index, segment, g, mut s) = loop {
            let index = self.index_at(p.z);
            let Some(segment) = segments.get(index) else {
                return Glance::Unclear;
            };
            let g = segment.g_along(p, d, q);
            let [c0, c1, c2, _] = g.c;
            let highest = c0 + doubt;
            let lean = jump + if ahead == 0.0 { c1.abs() } else { c1 * 1_f32.copysign(ahead) };
            if highest < 0.0 && (lean <= 0.0 || lean * lean < 4.0 * curve * highest) {
                return Glance::Misses;
            }
            let square = c1 * c1 - 4.0 * c2 * c0;
            let s = (Native::sqrt(greater(0.0, square)) - c1) / (c2 + c2);
            let z = p.z + s * d.z;
            if square >= 0.0 && segment.low <= z && z <= segment.high {
                break (index, segment, g, s);
            }
            looks -= 1;
            if looks == 0 || !(frame.low <= z && z <= frame.high) {
                return Glance::Unclear;
            }
            (p, back, ahead) = (p + d * s, back - s, 0.0);
        };

        let most = q + frame.curvature * rise;
        let mut steps = STEPS;
        loop {
            let slope = g.slope(s);
            let step = g.at(s) / slope;
            s -= step;
            if step * step * most <= ROOT * slope {
                break;
            }
            steps -= 1;
            if steps == 0 {
                return Glance::Unclear;
            }
        }
        let steep = g.slope(s) - jump;
        let is_first = steep > 0.0 && steep * steep > 4.0 * most * doubt;
        let (z, way) = (p.z + s * d.z, s - back);
        let is_within = z - segment.low > doubt && segment.high - z > doubt;
        let is_ahead = (way - t_min * line.unit) * steep > doubt;
        let u = (z - segment.low) * segment.per_height;
        let t = way / line.unit;
        if is_first && is_within && is_ahead && is_beyond(t, t_min) {
            Glance::Meets(Hit { t, segment: index, u, enters: true, part: Part::Wall })
        } else {
            Glance::Unclear
        }
    }
}
