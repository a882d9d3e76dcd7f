//! What fills the layers.

pub(crate) mod puffs;
