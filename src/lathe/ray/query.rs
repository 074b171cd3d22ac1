//! The queries for one ray: its nearest crossing with a lathe, whether there is any, all of them.

use super::fast_path::Decision;
use super::local_ray::LocalRay;
use super::traverse::traverse;
use crate::hit::Hit;
use crate::lathe::{Lathe, Segment};
use crate::math::minmax::greater;
use crate::ray::Ray;
use crate::solve::{Newton, Solver};
use heapless::Vec;

impl<const N: usize> Lathe<[Segment; N]> {
    /// Returns all crossings with t > `t_min`, in order.
    ///
    /// A ray crosses a segment at most three times, and each plane between two segments or at an end once. So
    /// the capacity C must be at least 3·N + (N + 1) = 4·N + 1, which is checked at compile time; then the
    /// vector cannot overflow.
    #[must_use]
    pub fn hits<const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        let mut hits = room::<N, C>();
        self.each_hit(ray, t_min, |hit| {
            let _ = hits.push(hit);
        });
        hits
    }

    /// [`Lathe::hits`] with the solver S, by the traversal alone.
    #[must_use]
    pub fn hits_by<S: Solver, const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        let mut hits = room::<N, C>();
        self.each_hit_by::<S>(ray, t_min, |hit| {
            let _ = hits.push(hit);
        });
        hits
    }
}

/// An empty vector for the hits of a lathe of N segments. Its capacity C must be at least 4·N + 1, the most
/// hits that a ray can have: a smaller one does not compile.
fn room<const N: usize, const C: usize>() -> Vec<Hit, C> {
    const {
        assert!(C > 4 * N, "a ray can meet a lathe of N segments 4·N + 1 times");
    }
    Vec::new()
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// Calls `see` with each crossing beyond `t_min`, in order: the same as [`Lathe::hits`] returns.
    pub(crate) fn each_hit(&self, ray: &Ray, t_min: f32, see: impl FnMut(Hit)) {
        match self.view_with_spare().fast_path(ray, t_min) {
            Decision::Miss => {}
            Decision::Hit(nearest) => self.each_hit_on::<Newton>(ray, t_min, Some(nearest), see),
            Decision::Undecided => self.each_hit_on::<Newton>(ray, t_min, None, see),
        }
    }

    /// [`Lathe::each_hit`] with the solver S, by the traversal alone.
    pub(crate) fn each_hit_by<S: Solver>(&self, ray: &Ray, t_min: f32, see: impl FnMut(Hit)) {
        self.each_hit_on::<S>(ray, t_min, None, see);
    }

    /// Calls `see` with `nearest`, if the fast path has found it, and then with each crossing beyond `t_min`
    /// that the traversal finds, except for `nearest` itself. If the traversal's first crossing enters the
    /// solid, it is `nearest` again, at a t that may differ by rounding, and is left out. If it leaves the
    /// solid, the t that the traversal computes for `nearest` is not beyond `t_min`. No t is smaller than the
    /// one before it: where rounding puts a wall before the cap at its rim, the wall's t is raised.
    fn each_hit_on<S: Solver>(&self, ray: &Ray, t_min: f32, nearest: Option<Hit>, mut see: impl FnMut(Hit)) {
        let local = LocalRay::new(&self.frame, ray);
        let (mut count, mut last) = (0, f32::NEG_INFINITY);
        let mut next = |hit: Hit| {
            // The crossing that the fast path has found, again.
            if !(nearest.is_some() && count == 1 && hit.enters) {
                last = greater(last, hit.t);
                see(Hit { t: last, ..hit });
            }
            count += 1;
        };
        nearest.map(&mut next);
        let _ = traverse::<S>(self.view(), &local, t_min, |hit| {
            next(hit);
            Some(())
        });
    }

    /// Returns the nearest crossing with t > `t_min`, or `None` if there is none.
    ///
    /// For most rays that come from outside, the fast path evaluates one segment or two, found by binary
    /// search, whatever the number of segments. For the others the segments near the ray are traversed.
    ///
    /// A ray from inside, or one that comes in through an open end, meets the wall from within, and its hit
    /// leaves the solid. A horizontal ray exactly at the height of a cap hits the wall at the cap's rim.
    // Not inlined: it needs all registers, and so do its callers.
    #[inline(never)]
    #[must_use]
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        match self.view_with_spare().fast_path(ray, t_min) {
            Decision::Miss => None,
            Decision::Hit(hit) => Some(hit),
            Decision::Undecided => self.traversed(ray, t_min),
        }
    }

    /// The nearest crossing of a ray that the fast path leaves undecided. Not inlined, since it is rare.
    #[cold]
    #[inline(never)]
    fn traversed(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        self.nearest_by::<Newton>(ray, t_min)
    }

    /// [`Lathe::nearest`] with the solver S, by the traversal alone.
    // Inlined: it makes one stack frame of two where the stack is deepest.
    #[inline(always)]
    #[must_use]
    pub fn nearest_by<S: Solver>(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        let local = LocalRay::new(&self.frame, ray);
        let mut nearest = None;
        let _ = traverse::<S>(self.view(), &local, t_min, |hit| {
            nearest = Some(hit);
            None
        });
        nearest
    }

    /// Whether there is any crossing with t > `t_min`, as shadows need it: true exactly where
    /// [`Lathe::nearest`] returns a hit, and [`Lathe::hits`] at least one.
    ///
    /// A ray that starts on the surface may or may not cross it there, by rounding. [`Lathe::spawn`] returns
    /// a ray that does not:
    ///
    /// ```
    /// use embedded_lathe::{Lathe, Profile, Ray, valid};
    ///
    /// let ball = Lathe::turn(valid!(Profile::sphere(1.0)));
    /// let ray = Ray::new([0.2, -3.0, 0.1], [0.0, 1.0, 0.0])?;
    /// let hit = ball.nearest(&ray, 0.0).unwrap();
    /// let to_light = ball.spawn(&ray, &hit, [-0.5, -0.7, 0.5])?;
    /// assert!(!ball.is_hit(&to_light, 0.0)); // not in its own shadow
    /// # Ok::<(), embedded_lathe::RayError>(())
    /// ```
    #[must_use]
    pub fn is_hit(&self, ray: &Ray, t_min: f32) -> bool {
        self.nearest(ray, t_min).is_some()
    }
}
