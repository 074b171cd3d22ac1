//! The *arithmetic* in which the pixels of a row are computed: floats, or integers where the machine has no
//! floating-point unit. It is chosen here, for the whole crate.
//!
//! An f32 addition takes an FPU one instruction, and a machine without an FPU some 80. A product of integers
//! takes one instruction on both, except on ARMv6-M. So what is computed for every pixel, from the point
//! where its ray meets the wall to its share of light, exists twice: [`floats`] and [`integers`], and so do
//! the loop that tracks a root and the bounds of a probe. What is computed once for a row, and single rays,
//! are floats everywhere. On a machine with an FPU the integers would take more instructions, because many of
//! their products are followed by a shift, and because they need tests of ranges that floats do not.
//!
//! The tests compare both with single rays. Each gives the same bits on every machine; the two differ by one
//! *shade* of a color channel in fewer than one pixel of 10 000. A build can choose by `--cfg
//! embedded_lathe_arithmetic="floats"` or `"integers"`; otherwise the target's architecture and ABI decide.
//! Whether a RISC-V has an FPU, the build script knows by the target's name: see
//! [`Native`](crate::math::Native).

// One of the two is not used.
#[allow(dead_code, unused_imports)]
pub(crate) mod floats;
#[allow(dead_code, unused_imports)]
pub(crate) mod integers;
mod limits;
mod share;

pub(crate) use limits::RowLimits;
pub(crate) use share::Share;

// A name that is imported by itself hides the same name from a `*`: where the integers are imported, they
// take the place of the floats.
#[allow(unused_imports)]
pub(crate) use floats::*;
#[cfg(any(
    embedded_lathe_arithmetic = "integers",
    all(
        not(embedded_lathe_arithmetic = "floats"),
        any(
            all(target_arch = "arm", not(target_abi = "eabihf")),
            all(target_arch = "riscv32", not(embedded_lathe_riscv_f)),
        )
    )
))]
pub(crate) use integers::{
    Flat, Gloss, KEPT, Length, Normal, Numbers, Pair, Rays, Seen, ToLight, Views, Wall,
};

#[cfg(test)]
mod tests {
    use super::{floats, integers};
    use crate::vector::{F32x3, Vector, vector};

    /// Numbers from −1 to 1, by a linear congruential generator (Knuth's MMIX).
    struct Even(u64);

    impl Even {
        fn next(&mut self) -> f32 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 40) as f32 / (1 << 23) as f32 - 1.0
        }

        fn vector(&mut self) -> F32x3 {
            vector([self.next(), self.next(), self.next()])
        }

        fn unit(&mut self) -> F32x3 {
            let v = self.vector();
            v * (1.0 / libm::sqrtf(v.dot(v)))
        }
    }

    /// Both arithmetics find the same light on a sample, to within an error. In floats an inverse root and a
    /// cosine are off by 10⁻⁶ at most, a highlight by five times that times half its exponent. The errors of
    /// integers are smaller.
    #[test]
    fn light_is_that_of_floats() {
        let mut even = Even(1995);
        let (mut worst, mut lit, mut glossy) = ([0.0_f32; 2], 0, 0);
        let share = |share: super::Share| share.units() as f32 / super::Share::UNITS;
        for number in 0..20_000 {
            let (gradient, unit, first, change) = (
                even.vector() * libm::exp2f(30.0 * even.next()),
                even.unit(),
                even.unit(),
                even.vector() * 0.01,
            );
            let n = even.unit();
            let direct = [1.0, 0.85, 0.25][number as usize % 3];
            let (column, shininess) = (number % 240, [1, 2, 15, 60, 255][number as usize % 5]);
            let (a, b) = (floats::Seen::new(gradient), integers::Seen::new(gradient));
            let (la, lb) = (
                floats::ToLight::new(unit, direct).mirrored(n),
                integers::ToLight::new(unit, direct).mirrored(n),
            );
            let (va, vb) = (floats::Views::new(first, change, 240), integers::Views::new(first, change, 240));
            let (ca, cb) = (a.cosine(&la), b.cosine(&lb));
            let cosines = [share(ca.share(&la)), share(cb.share(&lb))];
            let highlights = [
                share(va.highlight(column, &a, ca, &la, &floats::Gloss::new(shininess))),
                share(vb.highlight(column, &b, cb, &lb, &integers::Gloss::new(shininess))),
            ];
            lit += u32::from(cosines[0] > 0.0);
            glossy += u32::from(highlights[0] > 0.01);
            worst[0] = worst[0].max((cosines[0] - cosines[1]).abs());
            worst[1] = worst[1].max((highlights[0] - highlights[1]).abs() / (0.5 * f32::from(shininess)));
        }
        assert!(lit > 9_000 && glossy > 1_000, "{lit} {glossy}");
        assert!(worst[0] <= 1.1e-6 && worst[1] <= 5.5e-6, "{worst:?}");
        assert!(worst[0] >= 0.3e-6 && worst[1] >= 0.8e-6, "the bounds are slack: {worst:?}");
        for up in [1.0, -1.0] {
            let (la, lb) = (vector([0.6, 0.0, 0.8]), vector([0.6, 0.0, 0.8]));
            let a = share(
                floats::Seen::flat(up)
                    .cosine(&floats::ToLight::new(la, 1.0))
                    .share(&floats::ToLight::new(la, 1.0)),
            );
            let b = share(
                integers::Seen::flat(up)
                    .cosine(&integers::ToLight::new(lb, 1.0))
                    .share(&integers::ToLight::new(lb, 1.0)),
            );
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }
}
