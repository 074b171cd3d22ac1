//! What one may ask of a ray and a lathe: the nearest crossing, any, all.

use super::fast_path::Glance;
use super::local_ray::LocalRay;
use super::traverse::walk;
use crate::hit::Hit;
use crate::lathe::{Lathe, Segment};
use crate::math::minmax::greater;
use crate::ray::Ray;
use crate::solve::{Bracketed, Solver};
use core::ops::ControlFlow;
use heapless::Vec;

impl<const N: usize> Lathe<[Segment; N]> {
    /// All crossings beyond `t_min`, in order.
    ///
    /// A segment is met at most three times and either cap once: the capacity C must be at least 3·N + 2,
    /// which is checked at compile time, and cannot overflow.
    pub fn hits<const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        match self.whole().glance(ray, t_min) {
            Glance::Misses => Vec::new(),
            Glance::Meets(nearest) => self.hits_on::<Bracketed, C>(ray, t_min, Some(nearest)),
            Glance::Unclear => self.hits_on::<Bracketed, C>(ray, t_min, None),
        }
    }

    /// [`Lathe::hits`] with the solver S.
    pub fn hits_by<S: Solver, const C: usize>(&self, ray: &Ray, t_min: f32) -> Vec<Hit, C> {
        self.hits_on::<S, C>(ray, t_min, None)
    }

    /// The first is the nearest to the last bit, if that is known, and none before the one before: rounding may put a
    /// wall before a cap at its rim.
    fn hits_on<S: Solver, const C: usize>(&self, ray: &Ray, t_min: f32, nearest: Option<Hit>) -> Vec<Hit, C> {
        const {
            assert!(C >= 3 * N + 2, "a ray can meet a lathe of N segments 3·N + 2 times");
        }
        let mut hits = Vec::<Hit, C>::new();
        let path = LocalRay::new(&self.frame, ray);
        let _: Option<()> = walk::<S, _, false>(self.view(), &path, t_min, |hit| {
            let hit = match (hits.last(), nearest) {
                (None, Some(nearest)) if hit.enters => nearest,
                (None, _) => hit,
                (Some(last), _) => Hit { t: greater(last.t, hit.t), ..hit },
            };
            let _ = hits.push(hit);
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
    pub fn nearest(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        match self.whole().glance(ray, t_min) {
            Glance::Misses => None,
            Glance::Meets(hit) => Some(hit),
            Glance::Unclear => self.walked(ray, t_min),
        }
    }

    /// The nearest crossing of a ray that a glance does not tell. Apart, since it is rare.
    #[cold]
    #[inline(never)]
    fn walked(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        self.nearest_by::<Bracketed>(ray, t_min)
    }

    /// [`Lathe::nearest`] with the solver S, by a walk along the ray.
    // In line: of two frames one within the other this makes one, where the stack is deepest.
    #[inline(always)]
    pub fn nearest_by<S: Solver>(&self, ray: &Ray, t_min: f32) -> Option<Hit> {
        let path = LocalRay::new(&self.frame, ray);
        walk::<S, _, false>(self.view(), &path, t_min, ControlFlow::Break)
    }

    /// Whether there is any crossing beyond `t_min`: what a shadow asks. The signs at a chord's two ends
    /// often answer without a root.
    pub fn is_hit(&self, ray: &Ray, t_min: f32) -> bool {
        match self.whole().glance(ray, t_min) {
            Glance::Misses => false,
            Glance::Meets(_) => true,
            Glance::Unclear => self.is_hit_by::<Bracketed>(ray, t_min),
        }
    }

    /// [`Lathe::is_hit`] with the solver S, by a walk along the ray.
    pub fn is_hit_by<S: Solver>(&self, ray: &Ray, t_min: f32) -> bool {
        let path = LocalRay::new(&self.frame, ray);
        walk::<S, _, true>(self.view(), &path, t_min, ControlFlow::Break).is_some()
    }
}
