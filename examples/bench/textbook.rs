//! Cardano's formula as textbooks have it: the yardstick. It divides by the leading coefficient and trusts what it is given.

use micromath::F32Ext;

/// The functions it asks for.
pub trait Functions {
    fn sqrt(x: f32) -> f32;
    fn cbrt(x: f32) -> f32;
    fn acos(x: f32) -> f32;
    fn cos(x: f32) -> f32;
}

pub struct Libm;

impl Functions for Libm {
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    fn cbrt(x: f32) -> f32 {
        libm::cbrtf(x)
    }
    fn acos(x: f32) -> f32 {
        libm::acosf(x)
    }
    fn cos(x: f32) -> f32 {
        libm::cosf(x)
    }
}

/// Which has no cube root but powers.
pub struct Micromath;

impl Functions for Micromath {
    fn sqrt(x: f32) -> f32 {
        F32Ext::sqrt(x)
    }
    fn cbrt(x: f32) -> f32 {
        F32Ext::copysign(F32Ext::powf(F32Ext::abs(x), 1.0 / 3.0), x)
    }
    fn acos(x: f32) -> f32 {
        F32Ext::acos(x)
    }
    fn cos(x: f32) -> f32 {
        F32Ext::cos(x)
    }
}

/// The least root of `c0 + c1·u + c2·u² + c3·u³` in [lo, hi].
///
/// With u = x − a/3: `x³ + p·x + q = 0`. One real root if `(q/2)² + (p/3)³ > 0`, else three.
pub fn first_root<F: Functions>([c0, c1, c2, c3]: [f32; 4], lo: f32, hi: f32) -> Option<f32> {
    const THIRD_TURN: f32 = core::f32::consts::TAU / 3.0;
    let (a, b, c) = (c2 / c3, c1 / c3, c0 / c3);
    let p = b - a * a / 3.0;
    let q = 2.0 * a * a * a / 27.0 - a * b / 3.0 + c;
    let (half, third) = (q / 2.0, p / 3.0);
    let discriminant = half * half + third * third * third;

    let mut first = None;
    let mut consider = |x: f32| {
        let u = x - a / 3.0;
        if u >= lo && u <= hi && first.is_none_or(|least| u < least) {
            first = Some(u);
        }
    };
    if discriminant > 0.0 {
        let root = F::sqrt(discriminant);
        consider(F::cbrt(root - half) + F::cbrt(-root - half));
    } else {
        let r = F::sqrt(-third);
        let angle = F::acos(-half / (r * r * r)) / 3.0;
        for k in [0.0, 1.0, 2.0] {
            consider(2.0 * r * F::cos(angle - k * THIRD_TURN));
        }
    }
    first
}
