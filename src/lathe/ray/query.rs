//! What one may ask of a ray and a lathe: the nearest crossing, any, all.

use super::fast_path::Decision;
use super::local_ray::LocalRay;
use super::traverse::traverse;
use crate::hit::Hit;
use crate::lathe::{Lathe, Segment};
use crate::math::minmax::greater;
use crate::ray::Ray;
use crate::solve::{Newton, Solver};
use core::ops::ControlFlow;
use heapless::Vec;

impl<const N: usize> Lathe<[Segment; N]> {
    /// All crossings beyond `t_min`, in order.
    ///
    /// A segment is met at most three times, and each plane between two segments or at an end once: the capacity C must be at
    /// least 3·N + (N + 1) = 4·N + 1, which is checked at compile time, and cannot overflow.
    #[must_use]
    pub fn hits<const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        match self.view_with_spare().fast_path(ray, t_min) {
            Decision::Miss => Vec::new(),
            Decision::Hit(nearest) => self.hits_on::<Newton, C>(ray, t_min, Some(nearest)),
            Decision::Undecided => self.hits_on::<Newton, C>(ray, t_min, None),
        }
    }

    /// [`Lathe::hits`] with the solver S.
    #[must_use]
    pub fn hits_by<S: Solver, const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        self.hits_on::<S, C>(ray, t_min, None)
    }

    /// All crossings that a traversal finds. What the fast path has found comes first, as it is: that crossing is entered a
    /// rounding earlier or later by the traversal, or, if `t_min` lies between the two, not reported. No t is below the one
    /// before it: rounding may put a wall before a cap at its rim.
    fn hits_on<S: Solver, const C: usize>(&self, ray: &Ray, t_min: f32, nearest: Option<Hit>) -> Vec<Hit, C> {
        const {
            assert!(C > 4 * N, "a ray can meet a lathe of N segments 4·N + 1 times");
        }
        let mut hits = Vec::<Hit, C>::from_iter(nearest);
        let path = LocalRay::new(&self.frame, ray);
        let _: Option<()> = traverse::<S, _>(self.view(), &path, t_min, |hit| {
            match hits.last() {
                // The same crossing again.
                Some(_) if nearest.is_some() && hits.len() == 1 && hit.enters => {}
                last => {
                    let t = last.map_or(hit.t, |last| greater(last.t, hit.t));
                    let _ = hits.push(Hit { t, ..hit });
                }
            }
            ControlFlow::Continue(())
        });
        hits
    }
}

impl<T: AsRef<[Segment]> + ?Sized> Lathe<T> {
    /// The nearest crossing beyond `t_min`, if any: t > t_min.
    ///
    /// Most rays that come from outside need a look at one segment, or two, whatever the number of segments; it is
    /// found by steps of half of what remains. The others are followed through the segments near them.
    ///
    /// A ray from inside, or through an open end, meets the wall from within: the hit leaves. A ray that lies
    /// in the plane of a cap meets its rim.
    // Apart: it takes all the registers there are, and what calls it needs its own.
    #[inline(never)]
    #[must_use]
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        match self.view_with_spare().fast_path(ray, t_min) {
            Decision::Miss => None,
            Decision::Hit(hit) => Some(hit),
            Decision::Undecided => self.traversed(ray, t_min),
        }
    }

    /// The nearest crossing of a ray that a glance does not tell. Apart, since it is rare.
    #[cold]
    #[inline(never)]
    fn traversed(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        self.nearest_by::<Newton>(ray, t_min)
    }

    /// [`Lathe::nearest`] with the solver S, by a walk along the ray.
    // In line: of two frames one within the other this makes one, where the stack is deepest.
    #[inline(always)]
    #[must_use]
    pub fn nearest_by<S: Solver>(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        let path = LocalRay::new(&self.frame, ray);
        traverse::<S, _>(self.view(), &path, t_min, ControlFlow::Break)
    }

    /// Whether there is any crossing beyond `t_min`: what a shadow asks. True where [`Lathe::nearest`] has a hit and where
    /// [`Lathe::hits`] has any, and nowhere else.
    ///
    /// A ray that starts on the surface, as rounding has it, may or may not meet it there. [`Lathe::spawn`] makes one that
    /// does not:
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
