use super::path::Path;
use super::{Frame, Lathe, View};
use crate::hit::Hit;
use crate::math::{Math, Native};
use crate::ray::Rays;
use crate::vector::{F32x3, Vector};

/// A lathe and the rays of neighbouring pixels, in the lathe's frame. What one ray has found is where the next one looks.
///
/// [`follow`](Sweep::follow) carries a hit on by Newton's method, [`clears`](Sweep::clears) passes over rays that miss.
/// Both answer only what they can certify; whatever is left is for a ray of its own.
pub(crate) struct Sweep<'a> {
    lathe: View<'a>,
    /// The first ray's point at t = 0, and the change from ray to ray. All rays are moved along themselves by one t, to
    /// where they are near the frame's origin.
    place: F32x3,
    place_step: F32x3,
    direction: F32x3,
    direction_step: F32x3,
    /// The t they were moved by.
    shift: f32,
    per_unit: f32,
    /// How far apart neighbouring rays are at most where the lathe is.
    pitch: f32,
    /// How many rays it takes at least for g to change by one.
    rays_per_g: f32,
    /// How long, in t, a ray can be in the lathe's bounding sphere at most.
    longest: f32,
    last: Last,
}

/// What the last ray has found.
#[derive(Clone, Copy)]
enum Last {
    /// Nothing yet.
    Nothing,
    /// A hit.
    Hit {
        segment: usize,
        t: f32,
        /// How much t changes from ray to ray, and how much that does.
        ahead: f32,
        curve: f32,
        /// About 1/(dg/dt), NaN if not known.
        per_slope: f32,
    },
    /// A miss: where g is largest.
    Miss { segment: usize, t: f32 },
}

/// What a sweep can say of a ray.
pub(crate) enum Said {
    /// This is the nearest hit.
    Hit(Glimpse),
    /// It misses, and so do that many rays after it, if they may be asked [`Sweep::clears`].
    Miss(f32),
    /// Nothing certain.
    Unsure,
}

/// A hit, and what its shading needs.
pub(crate) struct Glimpse {
    /// The distance along the ray, in units of its direction.
    pub t: f32,
    /// A vector along the outward normal, in object space.
    pub gradient: F32x3,
    pub enters: bool,
}

impl<'a> Sweep<'a> {
    /// Of so many rays, given in object space.
    pub fn new(lathe: &'a Lathe, rays: &Rays, len: usize) -> Self {
        let view = lathe.view();
        let Frame { scale, middle, root_squash, reach, high, steepest, .. } = *view.frame;
        let origin = F32x3 { z: rays.origin.z - middle, ..rays.origin } * scale;
        let origin_step = rays.origin_step * scale;
        let half = 0.5 * len as f32;
        let (o, d) = (origin + origin_step * half, rays.direction + rays.direction_step * half);
        let shift = -o.dot(d) / d.dot(d);
        let squashed = |v: F32x3| F32x3 { x: v.x * root_squash, ..v };
        let place = squashed(origin + rays.direction * shift);
        let place_step = squashed(origin_step + rays.direction_step * shift);
        let (direction, direction_step) = (squashed(rays.direction), squashed(rays.direction_step));

        // Bounds for all rays, from the middle one: its length and what the others' can differ by; the radius of the lathe's
        // bounding sphere; the t at which a ray can be in a sphere of twice that.
        let (away, length) = (norm(place + place_step * half), norm(squashed(d)));
        let turn = norm(direction_step);
        let around = Native::sqrt(reach + high * high);
        let shortest = length - half * turn;
        let (pitch, longest) = if shortest > 0.75 * length {
            let within = (away + 2.0 * around) / shortest;
            (norm(place_step) + within * turn, 2.0 * around / shortest)
        } else {
            (f32::INFINITY, f32::INFINITY)
        };
        Self {
            lathe: view,
            place,
            place_step,
            direction,
            direction_step,
            shift,
            per_unit: 1.0 / (scale * rays.unit),
            pitch,
            rays_per_g: 1.0 / (pitch * (2.0 * Native::sqrt(reach) + steepest)),
            longest,
            last: Last::Nothing,
        }
    }

    /// The next ray is like one that has hit.
    pub fn begin(&mut self, hit: &Hit) {
        self.last = Last::Hit {
            segment: hit.segment,
            t: hit.t / self.per_unit - self.shift,
            ahead: 0.0,
            curve: 0.0,
            per_slope: f32::NAN,
        };
    }

    /// The next ray is not like the last.
    pub fn end(&mut self) {
        self.last = Last::Nothing;
    }

    /// What can be said of the i-th ray, given what the last one has found.
    #[inline(always)]
    pub fn look(&mut self, i: f32) -> Said {
        let (p, d) = (self.place + self.place_step * i, self.direction + self.direction_step * i);
        if let Last::Hit { segment, t, ahead, curve, per_slope } = self.last {
            if let Some(glimpse) = self.follow(&p, &d, segment, t, [ahead, curve], per_slope) {
                return Said::Hit(glimpse);
            }
        }
        self.graze(&p, &d)
    }

    /// Where g is largest along a ray: below zero it may be a certain miss, above it tells where to follow the hit from.
    ///
    /// From where it was on the last ray, by Newton's method on dg/dt. With `g = c0 + c2·s² + c3·s³` about there and |s| ≤ l, g stays below zero
    /// if c0 and c2 + |c3|·l are; l is the longest way in the lathe, or through the slab. The slabs before and behind are dealt with as for a hit.
    #[inline(never)]
    fn graze(&mut self, p: &F32x3, d: &F32x3) -> Said {
        let (mut index, mut t) = match self.last {
            Last::Nothing => {
                let t = -(p.x * d.x + p.y * d.y) / (d.x * d.x + d.y * d.y);
                let z = p.z + t * d.z;
                (self.lathe.segments.iter().take_while(|segment| segment.high < z).count(), t)
            }
            Last::Hit { segment, t, .. } | Last::Miss { segment, t } => (segment, t),
        };
        self.last = Last::Nothing;
        let q = d.x * d.x + d.y * d.y;
        let mut steps = 0;
        let (g, bend, curl) = loop {
            let Some(segment) = self.lathe.segments.get(index) else {
                return Said::Unsure;
            };
            let [f0, f1, f2, f3] = segment.f;
            let du = d.z * segment.per_height;
            let (x, y, u) =
                (p.x + t * d.x, p.y + t * d.y, (p.z + t * d.z - segment.low) * segment.per_height);
            let slope = ((3.0 * f3 * u + (f2 + f2)) * u + f1) * du - 2.0 * (x * d.x + y * d.y);
            let bend = (3.0 * f3 * u + f2) * (du * du) - q;
            let step = -0.5 * slope / bend;
            if !(bend < 0.0 && steps < 6) {
                return Said::Unsure;
            }
            steps += 1;
            let g = ((f3 * u + f2) * u + f1) * u + f0 - (x * x + y * y);
            t += step;
            let u = u + step * du;
            if u < 0.0 {
                index = index.wrapping_sub(1);
            } else if u > 1.0 {
                index += 1;
            } else if step.abs() < 1.0 / 1024.0 {
                // The value at the vertex, to the third order in the step.
                let l = (self.longest + 0.01) * du.abs();
                break (g + 0.5 * step * slope, bend, (f3 * (du * du)).abs() * if l < 1.0 { l } else { 1.0 });
            }
        };
        let margin = 1e-5;
        if g > margin {
            // The root before the vertex.
            let per_slope = Native::sqrt(-1.0 / (g * bend)) * 0.5;
            let back = 2.0 * g * per_slope;
            if let Some(glimpse) = self.follow(p, d, index, t - back, [0.0; 2], per_slope) {
                return Said::Hit(glimpse);
            }
            return Said::Unsure;
        }
        let up = d.z >= 0.0;
        let clear =
            |up: bool| self.is_outside_before(index, p, d, up) || self.keeps_side(index, p, d, up, false);
        if g < -margin && bend + curl < 0.0 && clear(up) && clear(!up) {
            self.last = Last::Miss { segment: index, t };
            return Said::Miss(-g * self.rays_per_g);
        }
        Said::Unsure
    }

    /// The nearest hit of the i-th ray, if it follows from the last one's and can be certified.
    ///
    /// # Newton's method, continued
    ///
    /// From where the last two hits point, in the last one's segment or a neighbour. 1/(dg/dt) is carried on too, and corrected by
    /// `r ← r·(2 − r·dg/dt)`: no division. What remains after a step is bounded by the step times what r lacks, and
    /// the step squared times the curvature.
    ///
    /// # The certificate that nothing lies nearer
    ///
    /// In the segment: before the root, at t − d, g is `−d·(slope − bend·d + c3·d²)`, and the parenthesis keeps its sign if its Bernstein
    /// ordinates over [0, longest] do. Where the ray was inside before it leaves, g is concave on the way and
    /// positive where it comes in. Before the segment: none, if it is the first; otherwise the ray comes
    /// into the segment's slab farther from the axis than any segment before reaches, and was farther before.
    #[inline(always)]
    fn follow(
        &mut self,
        p: &F32x3,
        d: &F32x3,
        mut index: usize,
        last: f32,
        [ahead, curve]: [f32; 2],
        mut r: f32,
    ) -> Option<Glimpse> {
        let q = d.x * d.x + d.y * d.y;
        let mut t = last + ahead + curve;
        let mut changes = 0;
        loop {
            let segment = self.lathe.segments.get(index)?;
            let [f0, f1, f2, f3] = segment.f;
            let (u0, du) = ((p.z - segment.low) * segment.per_height, d.z * segment.per_height);
            let (mut slope, mut bend);
            let mut steps = 0;
            loop {
                let (x, y, u) = (p.x + t * d.x, p.y + t * d.y, u0 + t * du);
                let g = ((f3 * u + f2) * u + f1) * u + f0 - (x * x + y * y);
                slope = ((3.0 * f3 * u + (f2 + f2)) * u + f1) * du - 2.0 * (x * d.x + y * d.y);
                bend = (3.0 * f3 * u + f2) * (du * du) - q;
                let lacks = 1.0 - slope * r;
                let lacks = if lacks.abs() < 0.25 {
                    r += r * lacks;
                    lacks * lacks
                } else {
                    r = 1.0 / slope;
                    0.0
                };
                let step = g * r;
                t -= step;
                if step.abs() * (lacks + (step * bend * r).abs()) <= CLOSE {
                    break;
                }
                steps += 1;
                if steps == 4 {
                    return None;
                }
            }
            let u = u0 + t * du;
            if u < 0.0 || u > 1.0 {
                if changes == 1 {
                    return None;
                }
                changes = 1;
                index = if u < 0.0 { index.checked_sub(1)? } else { index + 1 };
                r = f32::NAN;
                continue;
            }
            let c3 = f3 * (du * du * du);
            let far = t + self.shift;
            if !(far > 0.0) || !self.is_first(index, t, p, d, [slope, bend, c3]) {
                return None;
            }
            // Two rays tell where t goes, three how it bends.
            let next = t - last;
            let curve = if ahead == 0.0 { 0.0 } else { next - ahead };
            self.last = Last::Hit { segment: index, t, ahead: next, curve, per_slope: r };
            let enters = slope > 0.0;
            let slope = ((3.0 * f3 * u + (f2 + f2)) * u + f1) * segment.per_height;
            let root_squash = self.lathe.frame.root_squash;
            return Some(Glimpse {
                t: far * self.per_unit,
                gradient: F32x3 { x: root_squash * (p.x + t * d.x), y: p.y + t * d.y, z: -0.5 * slope },
                enters,
            });
        }
    }

    /// Whether a root at t, in a segment, has no other before it. Its slope, half the second derivative and the cubic coefficient of g there are given.
    #[inline(always)]
    fn is_first(&self, index: usize, t: f32, p: &F32x3, d: &F32x3, [slope, bend, c3]: [f32; 3]) -> bool {
        let segments = self.lathe.segments;
        let Some(segment) = segments.get(index) else {
            return false;
        };
        let up = d.z >= 0.0;
        let plane = if up { segment.low } else { segment.high };
        let is_end = if up { index == 0 } else { index + 1 == segments.len() };
        // Where the ray comes into the slab, times dz.
        let way = plane - p.z;
        let (x, y) = (p.x * d.z + way * d.x, p.y * d.z + way * d.y);
        let (square, dz2) = (x * x + y * y, d.z * d.z);
        if slope > 0.0 {
            let before = if up { segment.below } else { segment.above };
            let nearing = x * d.x + y * d.y;
            let alone = |l: f32| slope - 0.5 * bend * l > 0.0 && slope - bend * l + c3 * (l * l) > 0.0;
            (alone(self.longest) || alone((way / d.z - t).abs()))
                && (is_end
                    || square > before * dz2 && (nearing < 0.0) == up
                    || self.keeps_side(index, p, d, up, false))
        } else {
            // How far back that is, times |dz|; g is positive there if it exceeds what rounding could make of zero.
            let back = (way - t * d.z).abs();
            let b = if up { segment.b[0] } else { segment.b[3] };
            let dz = d.z.abs();
            let end = if up { self.lathe.frame.base } else { self.lathe.frame.top };
            b * dz2 > square * (1.0 + 1e-5)
                && (-2.0 * slope * dz + bend * back > 0.0 || bend < 0.0 && bend * dz < 3.0 * c3 * back)
                && end.is_none()
                && (is_end || self.keeps_side(index, p, d, up, true))
        }
    }

    /// Whether the ray, or its reverse, comes into a segment's slab farther from the axis than the segments before reach, and from farther still; or there are none.
    #[inline(always)]
    fn is_outside_before(&self, index: usize, p: &F32x3, d: &F32x3, up: bool) -> bool {
        let segments = self.lathe.segments;
        let Some(segment) = segments.get(index) else {
            return false;
        };
        let (plane, before) = if up { (segment.low, segment.below) } else { (segment.high, segment.above) };
        let way = plane - p.z;
        let (x, y) = (p.x * d.z + way * d.x, p.y * d.z + way * d.y);
        let nearing = x * d.x + y * d.y;
        before == 0.0 || x * x + y * y > before * (d.z * d.z) && (nearing < 0.0) == up
    }

    /// Whether the ray is inside, or outside, all through the slabs of the segments before one. Between the planes of a slab the Bernstein ordinates
    /// of g are `b0 − ⟨A,A⟩, b1 − (⟨A,A⟩ + 2⟨A,B⟩)/3, b2 − (2⟨A,B⟩ + ⟨B,B⟩)/3, b3 − ⟨B,B⟩`; here times dz².
    #[inline(never)]
    fn keeps_side(&self, index: usize, p: &F32x3, d: &F32x3, up: bool, inside: bool) -> bool {
        let segments = self.lathe.segments;
        let before = if up { segments.get(..index) } else { segments.get(index + 1..) };
        let dz2 = d.z * d.z;
        let at = |z: f32| (p.x * d.z + (z - p.z) * d.x, p.y * d.z + (z - p.z) * d.y);
        before.unwrap_or(&[]).iter().all(|segment| {
            let ((ax, ay), (bx, by)) = (at(segment.low), at(segment.high));
            let (aa, ab, bb) = (ax * ax + ay * ay, ax * bx + ay * by, bx * bx + by * by);
            let [b0, b1, b2, b3] = segment.b;
            // Far beyond what rounding could do to a sign.
            let margin = 1e-5 * (aa + bb + segment.reach * dz2);
            [
                b0 * dz2 - aa,
                b1 * dz2 - (aa + 2.0 * ab) * (1.0 / 3.0),
                b2 * dz2 - (2.0 * ab + bb) * (1.0 / 3.0),
                b3 * dz2 - bb,
            ]
            .iter()
            .all(|&g| if inside { g > margin } else { g < -margin })
        })
    }

    /// Whether all rays from the i-th on, so many, certainly miss.
    ///
    /// They are all within δ of the middle one wherever the lathe is. A point that moves by δ sees its distance ρ from the axis change by δ and the squared
    /// radius at its height by δ times the profile's steepest slope; so g stays negative where it is below
    /// `−2δ·ρ − δ·slope` on the middle ray.
    pub fn clears(&self, i: usize, len: usize) -> bool {
        let half = 0.5 * (len - 1) as f32;
        // A little for the rounding of all this.
        let delta = half * self.pitch + 1e-5;
        if !(delta < 1.0) {
            return false;
        }
        let at = i as f32 + half;
        let (p, d) = (self.place + self.place_step * at, self.direction + self.direction_step * at);
        let path = Path::through(p, d, self.shift, self.per_unit);
        path.clears(self.lathe, delta)
    }
}

/// 2⁻²³ of the frame's unit: half a rounding of what is near one.
const CLOSE: f32 = 1.0 / 8_388_608.0;

fn norm(v: F32x3) -> f32 {
    Native::sqrt(v.dot(v))
}
