//! A frame, as far as it has been computed.

use embedded_lathe::Picture;

/// A picture, and which of its rows comes next. Between two rows it can be left, kept, and sent to another thread.
pub struct Frame<'a> {
    picture: Picture<'a>,
    next: u32,
}

impl<'a> Frame<'a> {
    pub const fn new(picture: Picture<'a>) -> Self {
        Self { picture, next: 0 }
    }

    /// Writes the next row into the buffer; `false` if there is none left.
    pub fn next_row(&mut self, buffer: &mut [u8]) -> bool {
        let is_row = self.next < self.picture.height();
        if is_row {
            self.picture.bytes_of_row(0, self.next, buffer);
            self.next += 1;
        }
        is_row
    }
}
