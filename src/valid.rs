//! Errors that stop the compilation.

/// Unwraps a `Result` at compile time. An `Err` stops the compilation with the error's message.
///
/// ```
/// use embedded_lathe::{Lathe, Profile, Segment, valid};
///
/// static KNOB: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(1.0, 0.4)));
/// ```
///
/// A knot out of order is an error of the compiler:
///
/// ```compile_fail
/// use embedded_lathe::{Lathe, Profile, Segment, valid};
///
/// static WRONG: Lathe<[Segment; 1]> =
///     Lathe::turn(valid!(Profile::from_squared_radii(&[1.0, 0.5], &[1.0, 1.0, 1.0, 1.0])));
/// // error: evaluation panicked: the height of knot 1 is 0.5, not above, or too little above, that of the knot before it, 1.0
/// ```
///
/// It works for every error of this crate whose constructor is `const`:
/// [`ProfileError`](crate::ProfileError), [`RayError`](crate::RayError), [`SceneError`](crate::SceneError).
///
/// # Several steps
///
/// Steps that may fail are chained with `?`, as in a function. If the chain contains a `?`, every step that
/// returns a `Result` needs one, the last step too.
///
/// ```
/// use embedded_lathe::{End, Lathe, Profile, Segment, valid};
///
/// static TUBE: Lathe<[Segment; 1]> =
///     Lathe::turn(valid!(Profile::cylinder(1.0, 0.4)?.squash(0.5)?.top(End::Open)));
/// ```
///
/// ```compile_fail
/// # use embedded_lathe::{End, Lathe, Profile, Segment, valid};
/// static WRONG: Lathe<[Segment; 1]> =
///     Lathe::turn(valid!(Profile::cylinder(1.0, 0.4)?.squash(1.5)?.top(End::Open)));
/// // error: evaluation panicked: the squash must be from 0 to 1, and is 1.5
/// ```
///
/// The macro does not see a `?` within parentheses: an argument that is a `Result` needs a `valid!` of its
/// own.
///
/// # Functions
///
/// A value that depends on a function's parameters is not a constant, so the function cannot use `valid!` on
/// it. It returns the `Result`, and its caller, who passes constants, uses `valid!`:
///
/// ```
/// use embedded_lathe::*;
///
/// static PAWN: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cone(0.2, 0.9)));
///
/// const fn pawn_at(x: f32, y: f32, size: f32) -> Result<Solid<'static>, SceneError> {
///     match Pose::new([x, y, 0.0], Rotation::IDENTITY, size) {
///         Ok(pose) => Ok(Solid::new(&PAWN, Rgb::WHITE).posed(pose)),
///         Err(error) => Err(error),
///     }
/// }
///
/// static PAWNS: [Solid; 2] = [valid!(pawn_at(-0.5, 0.0, 1.0)), valid!(pawn_at(0.5, 0.0, 0.9))];
/// ```
///
/// ```compile_fail
/// # use embedded_lathe::*;
/// # static PAWN: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cone(0.2, 0.9)));
/// # const fn pawn_at(x: f32, y: f32, size: f32) -> Result<Solid<'static>, SceneError> {
/// #     match Pose::new([x, y, 0.0], Rotation::IDENTITY, size) {
/// #         Ok(pose) => Ok(Solid::new(&PAWN, Rgb::WHITE).posed(pose)),
/// #         Err(error) => Err(error),
/// #     }
/// # }
/// static WRONG: Solid = valid!(pawn_at(-0.5, 0.0, 0.0));
/// // error: evaluation panicked: the scale must be from 1e-30 to 1e30, and is 0.0
/// ```
#[macro_export]
macro_rules! valid {
    // A `?` comes next: the tokens before it are a `Result`, which is unwrapped.
    (@ $(? $is_chain:tt)? [$($step:tt)+] ? $($rest:tt)*) => {
        $crate::valid!(@ ? ! [(match ($($step)+) {
            Ok(value) => value,
            Err(error) => error.stop(),
        })] $($rest)*)
    };
    (@ $(? $is_chain:tt)? [$($step:tt)*] $next:tt $($rest:tt)*) => {
        $crate::valid!(@ $(? $is_chain)? [$($step)* $next] $($rest)*)
    };
    // No token is left: after a `?` the tokens are the value; without any `?` they are a `Result`.
    (@ ? ! [$($value:tt)+]) => {
        const { $($value)+ }
    };
    (@ [$($result:tt)+]) => {
        $crate::valid!(@ [$($result)+] ?)
    };
    ($($result:tt)+) => {
        $crate::valid!(@ [] $($result)+)
    };
}
