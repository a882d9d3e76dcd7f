//! What fills the layers.

pub(crate) mod mesh;
pub(crate) mod puffs;
#[cfg_attr(not(test), expect(dead_code, unused_imports, reason = "no scene asks for surfaces yet"))]
mod surface;
