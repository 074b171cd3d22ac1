//! What is known of a row's rays, for an arithmetic to convert it once for the row.

/// Some of the bounds of a row, by the names that they have in `RowBounds`; but `span` is how far along a ray a
/// probe looks.
pub(crate) struct RowLimits {
    pub span: f32,
    pub start: f32,
    pub low: f32,
    pub high: f32,
    pub drift: f32,
    pub slip: f32,
    pub tolerance: f32,
    pub knot_tolerance: f32,
}
