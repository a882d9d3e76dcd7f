//! What fills the layers.

pub(crate) mod mesh;
pub(crate) mod puffs;
pub(crate) mod surface;
pub(crate) mod volume;
