//! Light: where it comes from, and what keeps it away.

mod lights;
mod shadows;
mod soften;

pub(crate) use lights::LightsUniform;
pub(crate) use shadows::{QUADS as SHADOW_QUADS, Shadows, Stencil};
pub(crate) use soften::Soften;
