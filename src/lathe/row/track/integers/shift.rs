//! The change of a number from one fixed-point format to another.

/// A multiplication by a power of two, from 2⁻³¹ to 2³¹.
#[derive(Clone, Copy)]
pub(super) struct Shift {
    left: u32,
    right: u32,
}

impl Shift {
    /// The multiplication by `2^left`, for `left` from −31 to 31.
    pub fn left(left: i32) -> Self {
        Self { left: left.max(0) as u32, right: (-left).max(0) as u32 }
    }

    /// x times the power, rounded down. The result must be in the range of `i32`.
    #[inline(always)]
    pub fn of(self, x: i32) -> i32 {
        (x << self.left) >> self.right
    }
}
