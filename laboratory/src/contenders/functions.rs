use core::marker::PhantomData;
use embedded_lathe::math::Math;
use micromath::F32Ext;

/// A library's functions as it ships them. ([`Math`]'s are held to bounds, so micromath's root is refined there; here it is raw.)
pub trait Functions {
    fn sqrt(x: f32) -> f32;
    fn cbrt(x: f32) -> f32;
    fn acos(x: f32) -> f32;
    fn cos(x: f32) -> f32;
}

/// A backend whose functions [`Math`] passes on unchanged: libm's or std's.
pub struct Direct<M>(PhantomData<M>);

impl<M: Math> Functions for Direct<M> {
    fn sqrt(x: f32) -> f32 {
        M::sqrt(x)
    }

    fn cbrt(x: f32) -> f32 {
        M::cbrt(x)
    }

    fn acos(x: f32) -> f32 {
        M::acos(x)
    }

    fn cos(x: f32) -> f32 {
        M::cos(x)
    }
}

/// micromath's own. It has no cube root: the power 1/3 stands in.
pub struct MicromathDirect;

impl Functions for MicromathDirect {
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
