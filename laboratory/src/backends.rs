//! Every solver over every backend that ships.

/// A test of each, by a function that takes the solver as its type.
#[macro_export]
macro_rules! over_every_backend {
    ($check:ident) => {
        $crate::over_every_backend! { $check:
            split_over_native: Split<Native>,
            split_over_std: Split<Std>,
            split_over_libm: Split<Libm>,
            split_over_micromath: Split<Micromath>,
            cardano_over_native: Cardano<Native>,
            cardano_over_std: Cardano<Std>,
            cardano_over_libm: Cardano<Libm>,
            cardano_over_micromath: Cardano<Micromath>,
        }
    };
    ($check:ident: $($name:ident: $solver:ident<$backend:ident>,)*) => {$(
        #[test]
        fn $name() {
            $check::<embedded_lathe::solve::$solver<embedded_lathe::math::$backend>>();
        }
    )*};
}
