/// Marks the branch that calls this function as rarely taken, so that the compiler lays the other one out for
/// speed. The call itself does nothing and costs nothing.
#[cold]
#[inline(always)]
pub(crate) fn cold_path() {}
