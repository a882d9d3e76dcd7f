//! Light: where it comes from, and what keeps it away.

mod clusters;
mod extrude;
mod lights;
mod murk;
mod shadows;
mod soften;
mod volumes;

pub(crate) use clusters::Clusters;
pub(crate) use lights::LightsUniform;
pub(crate) use murk::Murk;
pub(crate) use shadows::{Casting, Shadows};
pub(crate) use soften::Soften;
pub(crate) use volumes::Volumes;
