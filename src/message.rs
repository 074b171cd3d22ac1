//! The message of an error: the same words when it is displayed and when it stops the compilation.

mod decimal;

use core::fmt;
use core::hash::{Hash, Hasher};

/// A part of a message.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Piece {
    /// Fixed words.
    Text(&'static str),
    /// A whole number.
    Count(usize),
    /// A number, written as `Debug` writes it.
    Number(f32),
    /// Three numbers in brackets.
    Vector([f32; 3]),
}

/// The pieces of a message, in order. Two messages are equal if all their pieces are equal. Numbers are equal
/// if they are written the same way: 0 and −0 differ, and any two NaNs are equal, since the sign of a NaN
/// differs from machine to machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Message([Piece; 6]);

impl Message {
    /// A message of N pieces, at most 6.
    pub const fn of<const N: usize>(pieces: [Piece; N]) -> Self {
        const { assert!(N <= 6) };
        let (mut all, mut i) = ([Piece::Text(""); 6], 0);
        while i < N {
            all[i] = pieces[i];
            i += 1;
        }
        Self(all)
    }

    /// Panics with the message, at compile time.
    #[track_caller]
    pub const fn stop(self) -> ! {
        match core::str::from_utf8(self.text().bytes()) {
            Ok(text) => panic!("{}", text),
            Err(_) => panic!("an error of embedded-lathe"),
        }
    }

    /// The message as text, for a panic: the same characters that `Display` writes.
    const fn text(self) -> Text {
        let (mut text, mut i) = (Text { bytes: [0; 256], len: 0 }, 0);
        while i < self.0.len() {
            match self.0[i] {
                Piece::Text(piece) => text.push_all(piece),
                Piece::Count(count) => text.push_count(count),
                Piece::Number(x) => decimal::push(&mut text, x),
                Piece::Vector([x, y, z]) => {
                    text.push_all("[");
                    decimal::push(&mut text, x);
                    text.push_all(", ");
                    decimal::push(&mut text, y);
                    text.push_all(", ");
                    decimal::push(&mut text, z);
                    text.push_all("]");
                }
            }
            i += 1;
        }
        text
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|piece| match piece {
            Piece::Text(text) => f.write_str(text),
            Piece::Count(count) => write!(f, "{count}"),
            Piece::Number(x) => write!(f, "{x:?}"),
            Piece::Vector(v) => write!(f, "{v:?}"),
        })
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        match (*self, *other) {
            (Self::Text(a), Self::Text(b)) => a == b,
            (Self::Count(a), Self::Count(b)) => a == b,
            (Self::Number(a), Self::Number(b)) => bits(a) == bits(b),
            (Self::Vector(a), Self::Vector(b)) => a.map(bits) == b.map(bits),
            _ => false,
        }
    }
}

/// The bits of a number, those of one NaN for all of them.
fn bits(x: f32) -> u32 {
    if x.is_nan() { f32::NAN } else { x }.to_bits()
}

impl PartialEq for Message {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl Hash for Message {
    fn hash<H: Hasher>(&self, state: &mut H) {
        for piece in self.0 {
            match piece {
                Piece::Text(text) => text.hash(state),
                Piece::Count(count) => count.hash(state),
                Piece::Number(x) => bits(x).hash(state),
                Piece::Vector(v) => v.map(bits).hash(state),
            }
        }
    }
}

/// Text that a `const fn` can write. Bytes beyond the 256th are left out.
struct Text {
    bytes: [u8; 256],
    len: usize,
}

impl Text {
    /// The bytes written so far.
    const fn bytes(&self) -> &[u8] {
        self.bytes.split_at(self.len).0
    }

    /// Appends a byte, if there is room.
    const fn push(&mut self, byte: u8) {
        if self.len < self.bytes.len() {
            self.bytes[self.len] = byte;
            self.len += 1;
        }
    }

    /// Appends all bytes of a string, as far as there is room.
    const fn push_all(&mut self, text: &str) {
        let (bytes, mut i) = (text.as_bytes(), 0);
        while i < bytes.len() {
            self.push(bytes[i]);
            i += 1;
        }
    }

    /// Appends a whole number in decimal digits.
    const fn push_count(&mut self, count: usize) {
        let mut power = 1;
        while count / power >= 10 {
            power *= 10;
        }
        while power > 0 {
            self.push(b'0' + (count / power % 10) as u8);
            power /= 10;
        }
    }
}

/// Implements `Display`, `Error`, `PartialEq`, `Eq` and `Hash` for an error type that has a method `const fn
/// message(self) -> Message`: all of them use the message alone.
macro_rules! impl_error {
    ($error:ty) => {
        impl $error {
            /// Stops the compilation with the message. Called by [`valid!`](crate::valid).
            #[doc(hidden)]
            #[track_caller]
            pub const fn stop(self) -> ! {
                self.message().stop()
            }
        }

        impl core::fmt::Display for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Display::fmt(&self.message(), f)
            }
        }

        impl core::error::Error for $error {}

        /// Numbers are compared by their bits: a NaN equals itself.
        impl PartialEq for $error {
            fn eq(&self, other: &Self) -> bool {
                self.message() == other.message()
            }
        }

        impl Eq for $error {}

        impl core::hash::Hash for $error {
            fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
                self.message().hash(state);
            }
        }
    };
}

pub(crate) use impl_error;

#[cfg(test)]
mod tests {
    extern crate std;

    use super::Piece::{self, Count, Number, Text, Vector};
    use super::*;
    use std::string::{String, ToString};

    fn written(pieces: [Piece; 1]) -> String {
        str::from_utf8(Message::of(pieces).text().bytes()).unwrap().to_string()
    }

    #[test]
    fn counts_and_texts_are_written_as_displayed() {
        for count in [0, 1, 9, 10, 99, 100, 12_345, usize::MAX] {
            assert_eq!(written([Count(count)]), count.to_string());
        }
        let message = Message::of([Text("at "), Vector([1.0, f32::NAN, -2.5e-9]), Text(", "), Number(0.1)]);
        assert_eq!(message.to_string(), "at [1.0, NaN, -2.5e-9], 0.1");
        assert_eq!(str::from_utf8(message.text().bytes()), Ok(&*message.to_string()));
    }

    /// As core writes it for debugging: so many numbers, and those where something may change.
    #[test]
    fn numbers_are_written_as_debugged() {
        let odd =
            [0.0, 1.0, 10.0, 0.1, 0.3, 9.999_999e9, 1e16, 9.999_999e15, 1e-4, 1e-5, 1e-45, 1e38, f32::MAX];
        let near = odd.into_iter().flat_map(|x| [x, x.next_up(), x.next_down()]);
        let bits = (0..200_000_u32).map(|i| f32::from_bits(i.wrapping_mul(2_654_435_761)));
        let powers = (-149..128).map(|e| 2f32.powi(e));
        let not_finite = [f32::NAN, f32::INFINITY];
        for x in near.chain(bits).chain(powers).chain(not_finite).flat_map(|x| [x, -x]) {
            if x.is_nan() {
                assert_eq!(written([Number(x)]), "NaN");
                continue;
            }
            assert_eq!(written([Number(x)]), std::format!("{x:?}"));
        }
    }

    #[test]
    fn messages_are_equal_if_their_texts_are() {
        let message = |x: f32| Message::of([Number(x), Vector([1.0, x, 2.0])]);
        let hash = |message: Message| {
            let mut state = std::hash::DefaultHasher::new();
            message.hash(&mut state);
            state.finish()
        };
        for [a, b] in [[f32::NAN, -f32::NAN], [0.0, -0.0], [1.0, 1.0], [1.0, 2.0]] {
            let [a, b] = [a, b].map(message);
            let same = a.to_string() == b.to_string();
            assert_eq!((a == b, hash(a) == hash(b)), (same, same), "{a} {b}");
        }
    }

    #[test]
    fn what_is_too_long_is_cut_off() {
        let message =
            Message::of([Text("0123456789012345678901234567890123456789012345678901234567890123456789"); 6]);
        assert_eq!(message.text().bytes().len(), 256);
    }
}
