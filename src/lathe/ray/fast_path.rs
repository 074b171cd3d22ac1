//! What most rays meet, decided without a traversal.
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
//! The first place is the one nearest to the axis, which all but a few rays need no other than. Of x and y no more matters
//! there than the ray's moment about the axis, which over √q is the distance from it: so a ray that passes by costs no
//! division. (Of slopes, c1 and A and J, it is the halves that are reckoned with.)
//!
//! Where a profile has steps g may jump upwards, too: for misses, the sum of all jumps is part of `room`, and so of doubt.
//! Hits of such a lathe are the traversal's to find.
//!
//! What is nearer to a decision than doubt, which is more than what rounding can do to g at a place, is left to the walk:
//! below zero g must be by more; behind a root it must rise above that, as it does where `(A − J)² > 4·doubt·|g″/2|`; and
//! the segment's ends, and the ray's start, must be farther away. What is not a number decides nothing.

use super::is_beyond;
use crate::cubic::Cubic;
use crate::hit::{Hit, Part};
use crate::lathe::frame::View;
use crate::math::cold_path;
use crate::math::minmax::{greater, lesser};
use crate::math::{Math, Native};
use crate::ray::Ray;

/// What the fast path decides about a ray.
pub(super) enum Glance {
    /// It meets nothing beyond `t_min`.
    Miss,
    /// This is its nearest crossing.
    Hit(Hit),
    /// One or the other: the traversal decides.
    Undecided,
}

/// The q of a ray that is not steep: whatever a direction's length, from 1 to 43.
const FLAT: f32 = 0.25;

/// How many of Newton's steps are taken, at most.
const STEPS: u32 = 4;

/// How far from the root, in units of the direction, a step may leave off.
const ROOT: f32 = 1.0 / 33_554_432.0;

impl View<'_> {
    /// What a ray meets beyond `t_min`.
    #[inline]
    pub(super) fn glance(&self, ray: &Ray, t_min: f32) -> Glance {
        let View { frame, segments } = *self;
        let (o, d) = (ray.origin, ray.direction);
        let x = d.x * frame.squash;
        let q = x * d.x + d.y * d.y;
        let moment = (o.x * d.y - o.y * d.x) * frame.across;
        let moment = moment * moment;
        if moment > frame.reach * q {
            return Glance::Miss;
        }
        let rise = d.z * d.z;
        let bulge = frame.bulge * rise;
        if !(q > greater(bulge, FLAT)) {
            return Glance::Undecided;
        }

        // Where it is nearest to the axis: how far behind its origin, how far off and how high.
        let per_q = 1.0 / q;
        let mut back = (o.x * x + o.y * d.y) * frame.scale * per_q;
        let mut square = moment * per_q;
        let mut z = (o.z - frame.middle) * frame.scale - d.z * back;
        let mut doubt = frame.rounding * (frame.room + back.abs() * (q + rise));
        let jump = || (frame.kinks * d.z).abs();

        // Half the slope of the square.
        let mut pull = 0.0;
        // Beyond an end's plane, on that plane. Farther from the axis the solid is on one side of it.
        let end = lesser(frame.high, greater(frame.low, z));
        if end != z {
            cold_path();
            let away = (end - z) / d.z;
            pull = q * away;
            square += pull * away;
            // The flatter the ray, the farther off rounding may put the place, and so this.
            doubt *= 1.0 + (pull / d.z).abs();
            if square > frame.reach + doubt {
                return Glance::Miss;
            }
            (z, back) = (end, back - away);
        }

        let mut index = self.index_at(z);
        let mut is_second = false;
        let (segment, u, kappa, [c0, c1, c2], mut s) = loop {
            let Some(segment) = segments.get(index) else {
                return Glance::Undecided;
            };
            let (u, kappa) = ((z - segment.low) * segment.per_height, d.z * segment.per_height);
            let [f0, f1, f2] = segment.about(u);
            let [c0, c1, c2] = [f0 - square, f1 * kappa - pull, f2 * (kappa * kappa) - q];
            let highest = c0 + doubt;
            if highest < 0.0 {
                let lean = if !is_second && pull != 0.0 {
                    greater(jump() + c1 * 1_f32.copysign(pull), 0.0)
                } else {
                    jump() + c1.abs()
                };
                if lean * lean < (bulge - q) * highest {
                    return Glance::Miss;
                }
            }
            let apart = c1 * c1 - c2 * c0;
            let s = (Native::sqrt(apart) - c1) / c2;
            let to = u + kappa * s;
            // From 0 to 1, as a number's bits tell: only those below zero have more.
            if to.to_bits() <= 1_f32.to_bits() {
                break (segment, u, kappa, [c0, c1, c2], s);
            }
            cold_path();
            if is_second {
                return Glance::Undecided;
            }
            is_second = true;
            let s = if apart >= 0.0 { s } else { -c1 / c2 };
            let turn = q * s;
            square += (pull + pull + turn) * s;
            (pull, back, z) = (pull + turn, back - s, z + d.z * s);
            // Beyond the solid's ends there is no segment.
            while segments.get(index).is_some_and(|segment| z < segment.low) {
                index = index.wrapping_sub(1);
            }
            while segments.get(index).is_some_and(|segment| segment.high < z) {
                index += 1;
            }
        };

        if frame.has_jumps {
            return Glance::Undecided;
        }
        let g = Cubic::new([c0, c1 + c1, c2, segment.f[3] * (kappa * kappa * kappa)]);
        let most = q + frame.curvature * rise;
        let mut steps = STEPS;
        let slope = loop {
            let (value, slope) = g.with_slope(s);
            let step = value / slope;
            s -= step;
            if most * step * step <= ROOT * slope {
                break slope;
            }
            steps -= 1;
            if steps == 0 {
                return Glance::Undecided;
            }
        };
        // From before the last step. That turned half the slope by less than three tenths of what it exceeds J by: the
        // square of that is no more than ROOT·A/(2·doubt) of this one's, doubt at least 80·ROOT·(2 + S), and A at most 12·(2 + S):
        // of a direction of more than four it is more, but so is `doubt`, by how far away the eye is.
        let steep = 0.5 * slope - jump();
        let (u, way) = (u + kappa * s, s - back);
        let unit = frame.scale * ray.unit;
        let t = way / unit;
        // Beyond t_min it is ahead, and so the slope must be above zero.
        let is_told = steep * steep > 2.0 * most * doubt
            && lesser(u, 1.0 - u) > doubt * segment.per_height
            && (way - t_min * unit) * steep > doubt
            && is_beyond(t, t_min);
        if is_told {
            Glance::Hit(Hit { t, segment: index, u, enters: true, part: Part::Wall })
        } else {
            Glance::Undecided
        }
    }
}
