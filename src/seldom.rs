//! Which way the compiler need not lay out for speed.

/// To be called where that is.
#[cold]
#[inline(always)]
pub(crate) fn seldom() {}
