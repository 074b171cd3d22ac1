//! What is computed once for a picture.

use super::aspect::Aspects;
use crate::occlusion::PaintOrder;
use crate::scene::Scene;

/// The order in which a picture's solids are painted, and how each is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Plan {
    pub order: PaintOrder,
    pub(super) aspects: Aspects,
}

impl Plan {
    /// The plan of a scene's picture of `width` columns and `height` rows. Not inline: while this function
    /// runs, the stack holds the result twice.
    #[inline(never)]
    pub const fn of(scene: &Scene, width: u32, height: u32) -> Self {
        let order = PaintOrder::of(scene.solids, &scene.camera);
        Self { order, aspects: Aspects::of(scene, width, height) }
    }
}
