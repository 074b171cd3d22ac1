//! Errors that stop the compilation.

/// The value of a `Result`, found at compile time; an error stops the compilation with its message.
///
/// ```
/// use embedded_lathe::{Lathe, Profile, Segment, valid};
///
/// static KNOB: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(1.0, 0.4)));
/// ```
///
/// A knot out of order is found before there is a program:
///
/// ```compile_fail
/// use embedded_lathe::{Lathe, Profile, Segment, valid};
///
/// static WRONG: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::from_squared_radii(&[1.0, 0.0], &[1.0, 1.0, 1.0, 1.0])));
/// // error: evaluation panicked: not above the knot before it, or by too little: knot 1
/// ```
///
/// It works for every error of this crate whose constructor is `const`:
/// [`ProfileError`](crate::ProfileError), [`RayError`](crate::RayError), [`SceneError`](crate::SceneError).
#[macro_export]
macro_rules! valid {
    ($result:expr) => {
        const {
            match $result {
                Ok(value) => value,
                Err(error) => error.stop(),
            }
        }
    };
}

/// Panics with a text and a number, at compile time.
#[track_caller]
pub(crate) const fn stop(text: &str, number: Option<usize>) -> ! {
    let mut message = [0; 96];
    let bytes = text.as_bytes();
    let mut len = 0;
    while len < bytes.len() && len < message.len() {
        message[len] = bytes[len];
        len += 1;
    }
    if let Some(number) = number {
        let mut power = 1;
        while number / power >= 10 {
            power *= 10;
        }
        while power > 0 && len < message.len() {
            message[len] = b'0' + (number / power % 10) as u8;
            len += 1;
            power /= 10;
        }
    }
    match core::str::from_utf8(message.split_at(len).0) {
        Ok(message) => panic!("{}", message),
        Err(_) => panic!("invalid"),
    }
}
